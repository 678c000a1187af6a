// Protects small things in vast scenes: a glass ball of 26 cm with its caustic, on a ground of 474
// km, and a view of 14 mm on one of 20 km. Grids must not grow with the extent, neither the
// ground's size nor the pixels that see its horizon may blur what is near, and photons of lamps at
// infinity must not fall on a lattice of the numbers that they are made from.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

#include "block_test.h"
#include "rendered_image.h"
#include "stress_case.h"

namespace vast_scene_test {
namespace {

constexpr int kSize = 64;

/// The ball at the origin under a small lamp, on a square ground of `extent` metres, seen from
/// above or, with the horizon, from the side.
std::string ball_on_ground(double extent, bool horizon) {
    std::ostringstream out;
    const double h = extent / 2;
    out << "Film \"fleximage\" \"integer xresolution\" [" << kSize << "] \"integer yresolution\" ["
        << kSize << "]\n"
        << (horizon ? "LookAt 0 -1.6 0.6  0 0 0.45  0 0 1\n"
                    : "LookAt 0 -0.9 0.9  0 0.1 0  0 0 1\n")
        << R"(Camera "perspective" "float fov" [40]
PixelFilter "box"
Sampler "random"
SurfaceIntegrator "aips"
WorldBegin
Material "matte" "color Kd" [0.6 0.6 0.6]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [)"
        << -h << ' ' << -h << " 0 " << h << ' ' << -h << " 0 " << h << ' ' << h << " 0 " << -h
        << ' ' << h << R"( 0]
AttributeBegin
Translate 0 0 0.15
Material "glass" "float index" [1.5]
Shape "sphere" "float radius" [0.13]
AttributeEnd
AttributeBegin
AreaLightSource "area" "color L" [900 900 900] "float power" [0] "float efficacy" [0]
Translate 0.2 0.7 1.0
Material "matte" "color Kd" [0 0 0]
Shape "sphere" "float radius" [0.02]
AttributeEnd
WorldEnd
)";
    return out.str();
}

/// A render and what its statistics say.
struct Result {
    render::Image image;
    double radius = 0, bytes = 0, bound_bytes = 0;
};

double number(const std::string& json, const std::string& name) {
    std::smatch found;
    if (!std::regex_search(json, found, std::regex('"' + name + "\": *([-+.eE0-9]+)"))) {
        throw std::runtime_error("no " + name + " in the statistics");
    }
    return std::stod(found[1]);
}

Result rendered(double extent, bool horizon, const std::string& method) {
    const render::Folder folder;
    const auto scene = folder.write("ground.lxs", ball_on_ground(extent, horizon));
    Result result;
    result.image = render::render(
        scene, "--passes 32 --seed 3 " + method + " --stats '" + (folder / "stats.json") + "'",
        folder);
    const std::string statistics = folder.read("stats.json");
    result.radius = number(statistics, "radius");
    result.bytes = number(statistics, "engine_bytes");
    result.bound_bytes = number(statistics, "engine_bound_bytes");
    return result;
}

const std::vector<std::string> kMethods{
    "--set aips.photonperpass=40000 --set aips.radius=schedule",
    "--set aips.photonperpass=40000 --set aips.radius=adaptive",
    "--set aips.photonperpass=40000 --set aips.mode=photonmap",
    "--integrator sppm --set sppm.photonperpass=40000",
    "--integrator ppm --set ppm.photonperpass=40000",
};

constexpr double kVast = 474e3, kNear = 20;  // extents, metres

/// Of the lower half of the image: the caustic, and never the lamp itself. Of 32 passes it has a
/// standard deviation of 4 % over seeds, of 4 passes one of 28 %.
double brightest_block(const Result& result) {
    const auto blocks = result.image.block_means(2);
    return *std::max_element(blocks.begin() + std::ptrdiff_t(blocks.size() / 2), blocks.end());
}

TEST(StressVastScene, GroundOf474KmLeavesACausticOf26CmAsItIs) {
    double worst = 0, most_bytes = 0;
    for (const std::string& method : kMethods) {
        SCOPED_TRACE(method);
        const Result near = rendered(kNear, false, method), vast = rendered(kVast, false, method);
        // radius=adaptive measures: its mean radius has a standard deviation of 4 % here.
        const bool measured = method.find("radius=adaptive") != std::string::npos;
        EXPECT_NEAR(vast.radius, near.radius, (measured ? 0.15 : 0.05) * near.radius);
        const double difference =
            statistics::median_difference(vast.image.block_means(8), near.image.block_means(8));
        EXPECT_LT(difference, 0.02);
        EXPECT_NEAR(brightest_block(vast), brightest_block(near), 0.2 * brightest_block(near));
        EXPECT_LT(vast.bytes, vast.bound_bytes);
        EXPECT_LT(vast.bytes, 1.2 * near.bytes);
        worst = std::max(worst, difference);
        most_bytes = std::max(most_bytes, vast.bytes);
    }
    std::ostringstream figure;
    figure << "median block differs by " << 100 * worst
           << " % (at most 2 %) from a ground of 20 m; " << most_bytes / 1048576 << " MiB";
    stress::record("a ground of 474 km under a glass ball of 26 cm, five methods", figure.str());
}

/// A view of 14 mm on a square ground of `extent` metres in parallel light along `from`, all of
/// which comes there through a slab of glass.
std::string ground_under_slab(double extent, const std::string& from) {
    std::ostringstream out;
    const double h = extent / 2;
    out << "Film \"fleximage\" \"integer xresolution\" [" << kSize << "] \"integer yresolution\" ["
        << kSize << R"(]
LookAt 0 0 0.028  0 0 0  0 1 0
Camera "perspective" "float fov" [28]
PixelFilter "box"
Sampler "random"
SurfaceIntegrator "aips"
WorldBegin
LightSource "distant" "point from" [)"
        << from << R"(] "point to" [0 0 0]
Material "matte" "color Kd" [0.6 0.6 0.6]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [)"
        << -h << ' ' << -h << " 0 " << h << ' ' << -h << " 0 " << h << ' ' << h << " 0 " << -h
        << ' ' << h << R"( 0]
Material "glass" "float index" [1.5]
Shape "trianglemesh" "integer triindices" [0 2 3 0 3 1 4 5 7 4 7 6 0 1 5 0 5 4 2 6 7 2 7 3
  0 4 6 0 6 2 1 3 7 1 7 5] "point P" [-.1 -.1 .03 .1 -.1 .03 -.1 .1 .03 .1 .1 .03
  -.1 -.1 .035 .1 -.1 .035 -.1 .1 .035 .1 .1 .035]
WorldEnd
)";
    return out.str();
}

/// Of pixels that should all be alike, how far they are from their median, relative to it.
struct Differences {
    double half = 0;         ///< of half of them less
    double nine_tenths = 0;  ///< of nine in ten: not of the few that a guide's first passes leave
};

Differences differences_of_pixels(double extent, const std::string& from) {
    const render::Folder folder;
    const auto scene = folder.write("slab.lxs", ground_under_slab(extent, from));
    auto pixels = render::render(scene,
                                 "--seed 4 --set aips.photonperpass=40000 --passes " +
                                     std::to_string(stress::sized(64, 96)),
                                 folder)
                      .block_means(1);
    const auto share_below = [&pixels](double share) {
        const auto place = pixels.begin() + std::ptrdiff_t(share * double(pixels.size()));
        std::nth_element(pixels.begin(), place, pixels.end());
        return *place;
    };
    const double typical = share_below(0.5);
    for (double& pixel : pixels)
        pixel = std::abs(pixel / typical - 1);
    return {share_below(0.5), share_below(0.9)};
}

/// On a lattice of 2^-24 of the scene, 1.7 mm, photons make dots that no number of passes levels.
TEST(StressVastScene, SunThroughASlabLeavesNoDots) {
    Differences worst;
    for (const std::string from : {"0.3 0.2 1", "1 0 1"}) {
        SCOPED_TRACE(from);
        const Differences found = differences_of_pixels(20e3, from);
        EXPECT_LT(found.half, 0.3);
        EXPECT_LT(found.nine_tenths, 0.8);
        worst = {std::max(worst.half, found.half), std::max(worst.nine_tenths, found.nine_tenths)};
    }
    std::ostringstream figure;
    figure << "half of the pixels differ by less than " << 100 * worst.half
           << " % (at most 30 %), nine in ten by less than " << 100 * worst.nine_tenths
           << " % (at most 80 %)";
    stress::record("a view of 14 mm through a slab of glass, in the sun on a ground of 20 km",
                   figure.str());
}

TEST(StressVastScene, HorizonDoesNotBlurWhatIsNear) {
    double most = 0;
    for (const std::string& method : kMethods) {
        SCOPED_TRACE(method);
        const Result near = rendered(kNear, true, method), vast = rendered(kVast, true, method);
        EXPECT_LT(vast.radius, 2 * near.radius);
        EXPECT_GT(brightest_block(vast), 0.4 * brightest_block(near));
        EXPECT_LT(vast.bytes, vast.bound_bytes);
        most = std::max(most, vast.radius / near.radius);
    }
    std::ostringstream figure;
    figure << "radius " << most << " (at most 2) times that on a ground of 20 m";
    stress::record("the same with the horizon in view", figure.str());
}

}  // namespace
}  // namespace vast_scene_test
