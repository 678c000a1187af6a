// Protects that a scene of pbrt is the same image here: each probe shows one material, texture,
// light, camera, film or shape, and has the image that pbrt-v4 makes of it (pbrt-probes/README.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <set>

#include "block_test.h"
#include "rendered_image.h"

namespace pbrt_probe_test {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = PBRT_PROBES;
constexpr std::size_t kBlock = 8;
// Most are seen to be the same by fewer passes, as noise only adds to what differs.
constexpr int kFewPasses = 64, kPasses = 256;
// What blocks may differ by: noise of both images, and colours that are products of RGB here and of
// spectra there.
constexpr double kMedian = 0.015, kMost = 0.04;

/// Means of blocks, one channel after the other.
std::vector<double> block_means(const render::Image& image) {
    std::vector<double> means;
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<double> channel;
        for (std::size_t i = c; i < image.rgb.size(); i += 3)
            channel.push_back(double(image.rgb[i]));
        const std::vector<double> blocks =
            statistics::block_means(channel, image.width, image.height, kBlock);
        means.insert(means.end(), blocks.begin(), blocks.end());
    }
    return means;
}

struct Difference {
    double median = 0, most = 0;  ///< most: of 95 % of the blocks

    bool is_small() const { return median <= kMedian && most <= kMost; }
};

/// Relative differences of blocks' channels; what is darker than a thousandth of the mean is not
/// compared.
Difference compare(const render::Image& ours, const render::Image& theirs) {
    const std::vector<double> a = block_means(ours), b = block_means(theirs);
    double mean = 0;
    for (const double value : b)
        mean += value / double(b.size());
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!std::isfinite(a[i]) || !std::isfinite(b[i]))
            throw std::runtime_error("an image holds what is no number");
        if (std::max(a[i], b[i]) > 1e-3 * mean)
            differences.push_back(std::abs(a[i] - b[i]) / std::max(b[i], 1e-3 * mean));
    }
    std::sort(differences.begin(), differences.end());
    return {differences.at(differences.size() / 2), differences.at(differences.size() * 95 / 100)};
}

/// Renders a probe, and compares its image with pbrt's.
Difference compare_with_pbrt(const std::string& name, int passes) {
    const render::Folder folder;
    const render::Image ours = render::render(
        kFolder / (name + ".pbrt"),
        fmt::format("--integrator path --passes {} --threads 1 --seed 1", passes), folder);
    const render::Image theirs = render::read_image(kFolder / (name + ".exr"));
    if (ours.width != theirs.width || ours.height != theirs.height)
        throw std::runtime_error("the images have different sizes");
    return compare(ours, theirs);
}

/// Probes whose images differ, and why: lines "NAME: REASON".
std::map<std::string, std::string> explained() {
    std::map<std::string, std::string> found;
    std::ifstream in(kFolder / "differences.txt");
    for (std::string line; std::getline(in, line);) {
        const std::size_t colon = line.find(": ");
        if (colon != std::string::npos && line[0] != '#')
            found[line.substr(0, colon)] = line.substr(colon + 2);
    }
    return found;
}

/// Names of all probes: scenes but for those that others include.
std::set<std::string> probes() {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(kFolder))
        if (entry.path().extension() == ".pbrt") names.insert(entry.path().stem());
    for (const char* part : {"lamp", "stage", "walls"})
        names.erase(part);
    return names;
}

const std::vector<std::string> kDiffuse{"diffuse",   "mix",        "named",
                                        "interface", "subsurface", "hair"};
const std::vector<std::string> kConductors{"conductor", "coatedconductor"};
const std::vector<std::string> kDielectrics{"dielectric", "thindielectric"};
const std::vector<std::string> kCoats{"coateddiffuse"};
const std::vector<std::string> kTextures{"texture", "displacement", "normalmap"};
const std::vector<std::string> kLights{"light"};
const std::vector<std::string> kCameras{"camera", "film", "filter", "colourspace"};
const std::vector<std::string> kShapes{"shape", "instances", "moving", "transforms"};
const std::vector<std::string> kMedia{"medium"};

bool is_of(const std::string& name, const std::vector<std::string>& beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const std::string& beginning) { return name.starts_with(beginning); });
}

/// All probes whose names begin so: the same image as pbrt's, but for those that are explained,
/// which still differ.
void check(const std::vector<std::string>& beginnings) {
    const std::map<std::string, std::string> known = explained();
    for (const std::string& name : probes()) {
        if (!is_of(name, beginnings)) continue;
        SCOPED_TRACE(name);
        const auto reason = known.find(name);
        Difference found;
        if (reason == known.end()) found = compare_with_pbrt(name, kFewPasses);
        if (reason != known.end() || !found.is_small()) found = compare_with_pbrt(name, kPasses);
        std::cout << fmt::format("{}: median {:.2f} %, 95 % within {:.2f} %\n", name,
                                 100 * found.median, 100 * found.most);
        if (reason == known.end()) {
            EXPECT_LE(found.median, kMedian);
            EXPECT_LE(found.most, kMost);
        } else {
            EXPECT_FALSE(found.is_small())
                << "differences.txt says that it differs: " << reason->second;
        }
    }
}

TEST(PbrtProbes, Diffuse) {
    check(kDiffuse);
}
TEST(PbrtProbes, Conductors) {
    check(kConductors);
}
TEST(PbrtProbes, Dielectrics) {
    check(kDielectrics);
}
TEST(PbrtProbes, Coats) {
    check(kCoats);
}
TEST(PbrtProbes, Textures) {
    check(kTextures);
}
TEST(PbrtProbes, Lights) {
    check(kLights);
}
TEST(PbrtProbes, CamerasAndFilm) {
    check(kCameras);
}
TEST(PbrtProbes, Shapes) {
    check(kShapes);
}
TEST(PbrtProbes, Media) {
    check(kMedia);
}

TEST(PbrtProbes, AreAllRendered) {
    const std::set<std::string> names = probes();
    EXPECT_GE(names.size(), 100u);
    for (const std::string& name : names) {
        int times = 0;
        for (const auto* group : {&kDiffuse, &kConductors, &kDielectrics, &kCoats, &kTextures,
                                  &kLights, &kCameras, &kShapes, &kMedia})
            times += is_of(name, *group) ? 1 : 0;
        EXPECT_EQ(times, 1) << name;
    }
    for (const auto& [name, reason] : explained())
        EXPECT_TRUE(names.contains(name)) << name;
}

}  // namespace
}  // namespace pbrt_probe_test
