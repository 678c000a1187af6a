// Protects the work that passes are compared by: all that a pass does is counted, and nothing that
// passes before it did.
#include "plan/pass_work.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace aips::pass_work_test {
namespace {

TEST(PassWork, EyePathsAndTheirRaysAreTheEyes) {
    const PassWork paths = pass_work(100, 0, {}, {});
    const PassWork rays = pass_work(100, 150, {}, {});
    EXPECT_GT(paths.eye, 0);
    EXPECT_GT(rays.eye, paths.eye);
    EXPECT_EQ(rays.photons, 0);
}

TEST(PassWork, AllThatPhotonsAskForIsTheirs) {
    const std::vector<std::function<std::uint64_t&(PhotonPassTotals&)>> counts{
        [](PhotonPassTotals& t) -> std::uint64_t& { return t.counts.rays; },
        [](PhotonPassTotals& t) -> std::uint64_t& { return t.counts.bounces; },
        [](PhotonPassTotals& t) -> std::uint64_t& { return t.counts.guided_emissions; },
        [](PhotonPassTotals& t) -> std::uint64_t& { return t.counts.guided_bounces; },
        [](PhotonPassTotals& t) -> std::uint64_t& { return t.gathered; },
        [](PhotonPassTotals& t) -> std::uint64_t& { return t.learned; }};
    for (std::size_t i = 0; i < counts.size(); ++i) {
        PhotonPassTotals before, after;
        counts[i](before) = 1000;
        counts[i](after) = 1000;
        EXPECT_EQ(pass_work(100, 100, before, after).photons, 0) << i;
        counts[i](after) = 1300;
        const PassWork work = pass_work(100, 100, before, after);
        EXPECT_GT(work.photons, 0) << i;
        EXPECT_EQ(work.eye, pass_work(100, 100, {}, {}).eye) << i;
        counts[i](before) = 0;
        counts[i](after) = 300;
        EXPECT_EQ(pass_work(100, 100, before, after).photons, work.photons) << i;
    }
}

}  // namespace
}  // namespace aips::pass_work_test
