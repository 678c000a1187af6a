// Protects scenes/: each loads without a word; photons and path tracing render it. Photons need no
// advice there; `path` is told where it misses caustics.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <regex>
#include <set>
#include <sstream>

#include "rendered_image.h"

namespace scenes_test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(SCENES)) {
        if (entry.path().extension() == ".lxs") names.push_back(entry.path().stem());
    }
    std::ranges::sort(names);
    return names;
}

/// Name for GoogleTest, which takes no hyphens.
std::string test_name(const testing::TestParamInfo<std::string>& scene) {
    return std::regex_replace(scene.param, std::regex("-"), "_");
}

/// What a scene may say: the prism disperses, which methods that carry light from pass to pass
/// leave out.
/// Of magic-lamp `path` sees nothing in two passes, and is told why.
bool allowed_warning(const std::string& scene, const std::string& line) {
    const auto says = [&](const char* text) { return line.find(text) != std::string::npos; };
    return (scene == "prism" && says("dispersion is left out")) ||
           (scene == "magic-lamp" && says("all black; the likely reason: light comes by glass"));
}

struct Result {
    render::Image image;
    nlohmann::json stats;
    std::vector<std::string> warnings;
};

/// Two small passes. Of photons shot at an open ground of 4 km none would come near the picture:
/// the test's ground is 16 m wide.
Result render_small(const std::string& name, const std::string& options) {
    const render::Folder folder;
    auto scene = render::small_scene(name, folder, 64, 48);
    if (name == "open-ground") {
        scene = render::edited_scene(scene, folder,
                                     {{"-2000 -2000 0  2000 -2000 0  2000 2000 0  -2000 2000 0",
                                       "-8 -8 0  8 -8 0  8 8 0  -8 8 0"}});
    }
    const fs::path image = folder.path() / "out.exr", stats = folder.path() / "stats.json";
    const std::string said = render::output_of(
        std::string(LXSRENDER) + " '" + scene.string() + "' -o '" + image.string() + "' --stats '" +
        stats.string() + "' --passes 2 --seed 1 " + options + " 2>&1");
    Result result{render::read_image(image), nlohmann::json::parse(std::ifstream(stats)), {}};
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);) {
        if (line.find("warning:") != std::string::npos && !allowed_warning(name, line)) {
            result.warnings.push_back(line);
        }
    }
    return result;
}

void expect_sound(const Result& result) {
    EXPECT_EQ(result.warnings, std::vector<std::string>());
    EXPECT_EQ(result.stats.at("refused film samples"), 0);
    EXPECT_TRUE(std::ranges::all_of(result.image.rgb, [](float v) { return std::isfinite(v); }));
    EXPECT_TRUE(std::ranges::all_of(result.image.rgb, [](float v) { return v >= 0; }));
}

double total(const render::Image& image) {
    return std::accumulate(image.rgb.begin(), image.rgb.end(), 0.0);
}

std::set<std::string> rules_of_advice(const Result& result) {
    std::set<std::string> rules;
    for (const auto& advice : result.stats.at("advice"))
        rules.insert(advice.at("rule"));
    return rules;
}

/// Of which scenes/README.md says that `path` misses caustics or most light. It says so of hall,
/// car, still-life and summerhouse too, whose glass is a small part of the picture: a few rays
/// don't tell.
const std::set<std::string> kNeedPhotons{"bathroom",  "candle",     "chess",       "glass-ball",
                                         "jewellery", "magic-lamp", "open-ground", "pool",
                                         "prism",     "ring",       "room",        "sun-window"};
/// What `path` sees of these in two passes is black but for bright dots.
const std::set<std::string> kDarkInPath{"bathroom", "magic-lamp", "sun-window"};

class Scenes : public testing::TestWithParam<std::string> {};

TEST_P(Scenes, PhotonsReachThePictureUnguidedAndGuided) {
    for (const std::string guide : {"none", "paper", "adaptive"}) {
        const Result result =
            render_small(GetParam(), "--set aips.photonperpass=50000 --set aips.guide=" + guide);
        expect_sound(result);
        EXPECT_EQ(rules_of_advice(result), std::set<std::string>()) << guide;
        EXPECT_GT(total(result.image), 0) << guide;
        EXPECT_GT(result.stats.at("aips").at("photons_gathered"), 0) << guide;
    }
}

TEST_P(Scenes, PathRendersThem) {
    const Result result = render_small(GetParam(), "--integrator path");
    expect_sound(result);
    std::set<std::string> rules = rules_of_advice(result);
    EXPECT_EQ(rules.erase("path misses caustics"), kNeedPhotons.count(GetParam()));
    if (!kDarkInPath.contains(GetParam())) {
        EXPECT_EQ(rules, std::set<std::string>());
    }
    // Its flame is behind glass, out of reach of shadow rays, and too small for paths to meet.
    if (GetParam() != "magic-lamp") {
        EXPECT_GT(total(result.image), 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Folder, Scenes, testing::ValuesIn(scene_names()), test_name);

}  // namespace
}  // namespace scenes_test
