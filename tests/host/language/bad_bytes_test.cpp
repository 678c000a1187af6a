// Damaged scenes end in an InputError or are read; nothing else comes out, nothing crashes.
#include <gtest/gtest.h>

#include <random>

#include "scene_fakes.h"

namespace lxs::test::bad_bytes_test {
namespace {

const std::string kScene = R"(# scene
LookAt 0 -5 2  0 0 1  0 0 1
Camera "perspective" "float fov" [38]
Film "fleximage" "integer xresolution" [120] "bool write_exr" ["true"]
WorldBegin
MakeNamedVolume "w" "clear" "float fresnel" [1.33]
Texture "t" "color" "constant" "color value" [.5 0.5 5e-1]
AttributeBegin
Interior "w" LightGroup "g"
AreaLightSource "area" "color L" [8 8 8]
MakeNamedMaterial "m" "string type" ["matte"] "texture Kd" ["t"]
NamedMaterial "m"
Shape "trianglemesh" "integer indices" [0 1 2] "point P" [-6 -6 0  6 -6 0  6 6 0]
AttributeEnd
ObjectBegin "o" Shape "sphere" "float radius" [0.9] ObjectEnd
MotionBegin [0 1] Translate 1 0 0 Rotate 9 0 0 1 MotionEnd
ObjectInstance "o"
LightSource "point" "point from" [1 2 3]
WorldEnd
)";

/// Replaces, removes, doubles or moves bytes, a few times.
std::string damaged(std::mt19937& random) {
    static const std::string bytes = "[]\"#\\ \n0-.e+\x01\x7f\xc3" + std::string(1, '\0');
    std::string text = kScene;
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    for (std::size_t i = 0; i <= below(4); ++i) {
        const std::size_t at = below(text.size());
        switch (below(4)) {
            case 0:
                text[at] = bytes[below(bytes.size())];
                break;
            case 1:
                text.erase(at, 1 + below(12));
                break;
            case 2:
                text.insert(at, text.substr(below(text.size()), 1 + below(40)));
                break;
            default:
                text.insert(at, 1, bytes[below(bytes.size())]);
        }
    }
    return text;
}

TEST(BadBytes, DamagedScenesGiveInputErrorsOnly) {
    std::mt19937 random(20140917);
    int refused = 0;
    constexpr int kRuns = 20000;
    for (int run = 0; run < kRuns; ++run) {
        const std::string text = damaged(random);
        try {
            refused += error_of_text(text).empty() ? 0 : 1;
        } catch (const std::exception& error) {
            FAIL() << error.what() << "\n" << text;
        }
    }
    EXPECT_GT(refused, kRuns / 10);
    EXPECT_LT(refused, kRuns);
}

TEST(BadBytes, EveryPrefixOfASceneIsRefused) {
    const std::size_t end = kScene.rfind("WorldEnd") + std::string("WorldEnd").size();
    for (std::size_t length = 0; length < end; ++length) {
        EXPECT_NE(error_of_text(kScene.substr(0, length)), "") << length;
    }
    EXPECT_EQ(error_of_text(kScene), "");
}

}  // namespace
}  // namespace lxs::test::bad_bytes_test
