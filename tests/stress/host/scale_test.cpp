// Protects the image from the unit of length: the same room in micrometres or in thousands of
// kilometres, its lamps scaled so that radiance stays, gives the same image in every mode. Powers
// of two only change exponents, so every bit must stay: any length written into the code shows. And
// from the room's place: up to the distance from which the renderer warns that single precision no
// longer does, the image stays as well.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "block_test.h"
#include "rendered_image.h"
#include "scaled_room.h"
#include "stress_case.h"

namespace scale_test {
namespace {

constexpr int kSize = 32;
constexpr std::size_t kBlock = 8;
constexpr double kSignificance = 0.01;

/// A way to render the room.
struct Method {
    std::string name, arguments;
};

std::string photons(const std::string& plugin, const std::string& more = "") {
    return "--passes 3 --integrator " + plugin + " --set " + plugin + ".photonperpass=8000" + more;
}

const std::vector<Method>& methods() {
    static const std::vector<Method> all{
        {"path", "--passes 6 --integrator path"},
        {"none", photons("aips", " --set aips.guide=none")},
        {"adaptive", photons("aips")},
        {"paper", photons("aips", " --set aips.guide=paper")},
        {"ppm", photons("ppm")},
        {"sppm", photons("sppm")},
        {"photonmap", photons("aips", " --set aips.mode=photonmap")},
        {"radius=adaptive", photons("aips", " --set aips.radius=adaptive")},
        {"photonsampler=amc",
         photons("aips", " --set aips.guide=none --set aips.photonsampler=amc")},
        {"photons by noise", "--passes 3 --integrator aips"},
    };
    return all;
}

class StressScale : public testing::Test {
  protected:
    render::Image room(const stress::Placement& placement, const Method& method, unsigned seed) {
        const auto scene = folder_.write("room.lxs", stress::scaled_room(placement, kSize));
        return render::render(scene, method.arguments + " --seed " + std::to_string(seed), folder_);
    }
    statistics::BlockMeans rooms(const stress::Placement& placement, const Method& method,
                                 unsigned first_seed) {
        statistics::BlockMeans means;
        for (unsigned seed = 0; seed < seeds_; ++seed)
            means.push_back(room(placement, method, first_seed + seed).block_means(kBlock));
        return means;
    }

    unsigned seeds_ = stress::sized(4u, 8u);
    render::Folder folder_;
};

std::string text(double number) {
    std::ostringstream out;
    out << number;
    return out.str();
}

std::size_t different(const render::Image& a, const render::Image& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        count += a.rgb[i] == b.rgb[i] ? 0 : 1;
    return count;
}

TEST_F(StressScale, PowersOfTwoKeepEveryBit) {
    const std::vector<int> exponents =
        stress::sized(std::vector{-20, 20}, std::vector{-26, -24, -22, -20, -10, 10, 20, 30, 40});
    for (const Method& method : methods()) {
        const auto unscaled = room({}, method, 7);
        for (const int exponent : exponents) {
            const auto scaled = room({std::exp2(exponent)}, method, 7);
            EXPECT_EQ(different(scaled, unscaled), 0u) << method.name << ", 2^" << exponent;
        }
    }
    stress::record("a room at 2^" + std::to_string(exponents.front()) + " to 2^" +
                       std::to_string(exponents.back()) + " units, " +
                       std::to_string(methods().size()) + " ways to render",
                   "0 of " + std::to_string(kSize * kSize) + " pixels differ");
}

TEST_F(StressScale, PowersOfTenKeepTheImage) {
    const std::vector<double> scales =
        stress::sized(std::vector{1e-6}, std::vector{1e-11, 1e-9, 1e-6, 1e-3, 1e3, 1e6});
    const std::size_t count = stress::sized<std::size_t>(3, methods().size());
    double detectable = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Method& method = methods()[i];
        const auto unscaled = rooms({}, method, 10);
        for (const double scale : scales) {
            const auto c = statistics::compare(unscaled, rooms({scale}, method, 20), kSignificance);
            EXPECT_FALSE(c.differs()) << method.name << " at " << scale << ": " << c.describe();
            detectable = std::max(detectable, c.detectable);
        }
    }
    EXPECT_LT(detectable, 0.15);
    stress::record("a room at " + text(scales.front()) + " to " + text(scales.back()) +
                       " units against 1, block tests at 1 %",
                   "same; largest detectable difference of a mean " + text(100 * detectable) +
                       " %, at most 15 %");
}

/// Where nothing warns the image may change by 1 %: vertices move by up to 1/16000 of the extent.
TEST_F(StressScale, MovedRoomsKeepTheImageUpToTheWarning) {
    constexpr double kAllowed = 0.01;
    const std::vector<double> distances =
        stress::sized(std::vector{3000.0}, std::vector{100.0, 1000.0, 3000.0});
    const std::size_t count = stress::sized<std::size_t>(2, methods().size());
    for (std::size_t i = 0; i < count; ++i) {
        const Method& method = methods()[i];
        const auto still = rooms({}, method, 30);
        for (const double d : distances) {
            const auto moved = rooms({1, {d, -0.7 * d, 0.3 * d}}, method, 40);
            const auto c = statistics::compare(still, moved, kSignificance, kAllowed);
            EXPECT_FALSE(c.differs()) << method.name << " at " << d << ": " << c.describe();
        }
    }
    stress::record("a room up to " + text(distances.back()) + " units from the origin",
                   "same within 1 %, block tests at 1 %");
}

TEST_F(StressScale, LostPrecisionIsSaidOnce) {
    const auto messages = [&](double scale, double distance) {
        const auto scene = folder_.write(
            "room.lxs", stress::scaled_room({scale, {distance * scale, 0, 0}}, kSize));
        return render::output_of(std::string(LXSRENDER) + " '" + scene + "' -o '" +
                                 (folder_ / "out.exr") +
                                 "' --quiet --passes 1 --integrator path 2>&1");
    };
    for (const double scale : {1e-6, 1.0, 1e6}) {
        EXPECT_EQ(messages(scale, 3000), "") << scale;
        const std::string said = messages(scale, 4000);
        const std::string message = "units from the origin, where positions are rounded to";
        const auto at = said.find(message);
        ASSERT_NE(at, std::string::npos) << said;
        EXPECT_EQ(said.find(message, at + 1), std::string::npos) << said;
        EXPECT_NE(said.find("room.lxs:"), std::string::npos) << said;
    }
    // Far beyond, where rounding shows, the render still ends with a finite image.
    for (const double distance : {1e4, 1e6}) {
        const auto image = room({1, {distance, 0, 0}}, methods()[2], 1);
        EXPECT_TRUE(std::all_of(image.rgb.begin(), image.rgb.end(),
                                [](float v) { return std::isfinite(v) && v >= 0; }));
    }
    stress::record("a room 3.5 units wide, 3000, 4000 and 1e4 to 1e6 units from the origin",
                   "warns once from 4000 on; images finite");
}

}  // namespace
}  // namespace scale_test
