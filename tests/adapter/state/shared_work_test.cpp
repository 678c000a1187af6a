// Protects: what ranks tell each other of parts arrives whole and in its place, whatever the sizes
// of parts and the number of ranks; and ranks whose work differs are refused.
#include "ranks/shared_work.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "thread_ranks.h"

namespace aips::ranks_test {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Numbers of which no two parts have the same, nor the same count; part 5 is copied by several
/// threads.
std::vector<std::uint32_t> numbers_of(std::uint32_t part) {
    std::vector<std::uint32_t> numbers(part == 5 ? 300'000 : part % 4);
    std::iota(numbers.begin(), numbers.end(), 1'000'000 * part);
    return numbers;
}

TEST(SharedWork, AllRanksHaveAllParts) {
    constexpr Origin kMaterial = 0;
    for (const std::uint32_t count : {1u, 2u, 3u, 7u}) {
        for (const std::uint32_t parts : {0u, 1u, 6u, 40u}) {
            mock::ThreadRanks job(count);
            job.run([&](Ranks& ranks) {
                InvalidSampleFilter filter;
                std::vector<std::vector<std::uint32_t>> numbers(parts);
                const auto work = [&](std::uint32_t part) {
                    numbers[part] = numbers_of(part);
                    if (part % 3 == 0) filter.count(kMaterial);
                };
                share_out(&ranks, parts, &filter, work,
                          [&](std::uint32_t part, StateArchive& archive) {
                              archive.values(numbers[part]);
                          });
                for (std::uint32_t part = 0; part < parts; ++part)
                    EXPECT_EQ(numbers[part], numbers_of(part)) << part << " of " << parts;
                EXPECT_EQ(filter.counts()[kMaterial], (parts + 2) / 3);
            });
        }
    }
}

TEST(SharedWork, OtherWorkIsRefused) {
    const auto told = [](const auto& elements_of) {
        mock::ThreadRanks job(2);
        job.run([&](Ranks& ranks) {
            SharedWork work(&ranks, 4, nullptr);
            work.exchange([&](std::uint32_t part, StateArchive& archive) {
                std::vector<float> elements(elements_of(ranks.rank(), part));
                plain(archive, std::span<float>(elements));
            });
        });
    };
    EXPECT_NO_THROW(told([](std::uint32_t, std::uint32_t part) { return 10 * part; }));
    const auto refused = ThrowsMessage<StateError>(HasSubstr("ranks do not have the same work"));
    EXPECT_THAT([&] { told([](std::uint32_t rank, std::uint32_t) { return 10 + rank; }); },
                refused);
}

}  // namespace
}  // namespace aips::ranks_test
