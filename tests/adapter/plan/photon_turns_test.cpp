// Protects the passes without photons: of each few passes one shoots, any of them as often as the
// others, so that the photons' part has the right expectation whenever a render ends.
#include "plan/photon_turns.h"

#include <gtest/gtest.h>

#include <array>

#include "plan/constants.h"

namespace aips::photon_turns_test {
namespace {

TEST(PhotonTurns, AllPassesShootWhereEachHasItsOwn) {
    for (std::uint64_t pass = 0; pass < 100; ++pass)
        EXPECT_TRUE((PhotonTurns{1, 16}.shoots(7, pass)));
}

TEST(PhotonTurns, OneOfEachFewShoots) {
    for (std::uint32_t every = 2; every <= kMostTurns; every *= 2) {
        const PhotonTurns turns{every, 16};
        for (std::uint64_t pass = 0; pass < 16; ++pass)
            EXPECT_TRUE(turns.shoots(3, pass)) << "before they began";
        for (std::uint64_t first = 16; first < 16 + 64 * every; first += every) {
            unsigned shot = 0;
            for (std::uint64_t pass = first; pass < first + every; ++pass)
                shot += turns.shoots(3, pass);
            EXPECT_EQ(shot, 1u) << "passes from " << first;
        }
    }
}

/// Pearson's test at 0.1 %: 24.3 for seven degrees of freedom.
TEST(PhotonTurns, EachOfThemAsOften) {
    const PhotonTurns turns{8, 16};
    std::array<double, 8> shot{};
    constexpr double kSeeds = 4000;
    for (std::uint64_t seed = 0; seed < std::uint64_t(kSeeds); ++seed) {
        for (std::uint64_t pass = 24; pass < 32; ++pass)
            shot[pass - 24] += turns.shoots(seed, pass);
    }
    double chi_square = 0;
    for (const double count : shot)
        chi_square += (count - kSeeds / 8) * (count - kSeeds / 8) / (kSeeds / 8);
    EXPECT_LT(chi_square, 24.3);
}

}  // namespace
}  // namespace aips::photon_turns_test
