// Protects the image from textures, lights and images of a scene that are no light: NaN, infinite
// or negative values are refused with each integrator, counted in the statistics under the material
// or the light that they came from, and reported at the end of the render, or where the file is
// read, with its place in the scene.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "stress_case.h"
#include "stressed_scene.h"

namespace refused_light_test {
namespace {

using stress::Outcome;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// An image with bad values all over it, few of each, and healthy ones between.
void write_bad_image(const render::Folder& folder, const std::string& name) {
    render::Image image{8, 4, std::vector<float>(96, 0.5f)};
    image.rgb[3] = kNan;
    image.rgb[31] = kInfinity;
    image.rgb[50] = -kInfinity;
    image.rgb[70] = -2;
    image.rgb[80] = 0;
    render::write_image(image, folder.path() / name);
}

/// A ball of a material with a texture `texture` for its colour.
std::string textured_ball(const std::string& texture) {
    return texture +
           "MakeNamedMaterial \"spoiled\" \"string type\" [\"matte\"] \"texture Kd\" [\"bad\"]\n"
           "AttributeBegin\nNamedMaterial \"spoiled\"\nShape \"sphere\" \"float radius\" [0.8]\n"
           "AttributeEnd\n";
}

void expect_sane(const Outcome& outcome, double clean_mean, const std::string& what) {
    ASSERT_EQ(outcome.exit_code, 0) << what << outcome.messages;
    EXPECT_EQ(outcome.bad_pixels(), 0u) << what;
    EXPECT_GT(outcome.mean(), 0.5 * clean_mean) << what;
    EXPECT_LT(outcome.mean(), 1.6 * clean_mean) << what;
    EXPECT_EQ(outcome.statistics.at("refused film samples"), 0) << what;
}

double clean_mean(const stress::RenderWay& way, const render::Folder& folder) {
    const Outcome clean = stress::render_scene(
        stress::room("Shape \"sphere\" \"float radius\" [0.8]\n"), way, folder, 8);
    EXPECT_EQ(clean.exit_code, 0) << clean.messages;
    EXPECT_TRUE(clean.statistics.at("refused").empty()) << clean.statistics.at("refused").dump();
    EXPECT_THAT(clean.messages, Not(HasSubstr("refused")));
    return clean.mean();
}

/// Textures whose sums, products and powers leave the numbers: at run time, so that only the
/// statistics and the end of the render can tell.
TEST(StressRefusedLight, TexturesByTheirMaterial) {
    const std::vector<std::pair<std::string, std::string>> textures{
        {"NaN and infinite sums",
         "Texture \"up\" \"color\" \"multimix\" \"float weights\" [3e38 3e38] \"texture tex1\" "
         "[\"squares\"] \"texture tex2\" [\"squares\"]\n"
         "Texture \"bad\" \"color\" \"subtract\" \"texture tex1\" [\"up\"] \"texture tex2\" "
         "[\"up\"]\n"},
        {"infinite products",
         "Texture \"bad\" \"color\" \"scale\" \"texture tex1\" [\"squares\"] \"color tex2\" [2e38 "
         "2e38 2e38]\n"},
        {"negative differences",
         "Texture \"bad\" \"color\" \"subtract\" \"color tex1\" [0.5 0.5 0.5] \"texture tex2\" "
         "[\"squares\"]\n"}};
    const std::string squares =
        "Texture \"grey\" \"float\" \"checkerboard\" \"float uscale\" [8] \"float vscale\" [8] "
        "\"float tex1\" [1] \"float tex2\" [0]\n"
        "Texture \"squares\" \"color\" \"mix\" \"color tex1\" [0.25 0.25 0.25] \"color tex2\" [2 2 "
        "2] \"texture amount\" [\"grey\"]\n";
    const render::Folder folder;
    std::size_t renders = 0;
    for (const stress::RenderWay& way : stress::all_ways()) {
        const double clean = clean_mean(way, folder);
        for (const auto& [what, texture] : textures) {
            SCOPED_TRACE(way.name + ": " + what);
            const Outcome outcome = stress::render_scene(
                stress::room(textured_ball(squares + texture)), way, folder, 4);
            expect_sane(outcome, clean, outcome.messages);
            EXPECT_THAT(outcome.origins("texture values"),
                        ElementsAre(R"(texture "bad" of material "spoiled")"));
            EXPECT_THAT(outcome.messages,
                        HasSubstr(R"(texture values of texture "bad" of material "spoiled")"));
            ++renders;
        }
    }
    stress::record("textures of NaN, infinity and below 0 in 8 integrators and modes",
                   std::to_string(renders) + " renders, all counted by material");
}

/// A lamp whose texture is no light in half of its squares.
TEST(StressRefusedLight, TexturesOfLampsByTheirLight) {
    const render::Folder folder;
    const std::string lamp =
        "Texture \"grey\" \"float\" \"checkerboard\" \"float uscale\" [4] \"float vscale\" [4] "
        "\"float tex1\" [1] \"float tex2\" [0]\n"
        "Texture \"L\" \"color\" \"mix\" \"color tex1\" [6 6 6] \"color tex2\" [-1 -1 -1] "
        "\"texture amount\" [\"grey\"]\n"
        "AttributeBegin\nAreaLightSource \"area\" \"texture L\" [\"L\"] \"float power\" [0] "
        "\"float efficacy\" [0]\nShape \"trianglemesh\" \"integer triindices\" [0 1 2 0 2 3] "
        "\"point P\" [-1 -1 1.9  -1 1 1.9  1 1 1.9  1 -1 1.9] \"float uv\" [0 0 0 1 1 1 1 0]\n"
        "AttributeEnd\nShape \"sphere\" \"float radius\" [0.8]\n";
    for (const stress::RenderWay& way : stress::main_ways()) {
        SCOPED_TRACE(way.name);
        const Outcome outcome = stress::render_scene(stress::room(lamp, false), way, folder, 8);
        expect_sane(outcome, clean_mean(way, folder), outcome.messages);
        EXPECT_THAT(outcome.origins("texture values"),
                    ElementsAre(R"(texture "L" of light 0 (area))"));
        EXPECT_THAT(outcome.messages,
                    HasSubstr(R"(texture values of texture "L" of light 0 (area))"));
    }
    stress::record("a lamp's texture below 0 in half of its squares", "counted by light");
}

/// Images are cleaned where they are read, with one message at the place that names them.
TEST(StressRefusedLight, ImagesWhereTheyAreRead) {
    const render::Folder folder;
    write_bad_image(folder, "bad.exr");
    const std::vector<std::pair<std::string, std::string>> worlds{
        {textured_ball("Texture \"bad\" \"color\" \"imagemap\" \"string filename\" [\"bad.exr\"] "
                       "\"float gamma\" [1]\n"),
         "4 values that are not finite or negative"},
        {"LightSource \"infinite\" \"string mapname\" [\"bad.exr\"]\n"
         "Shape \"sphere\" \"float radius\" [0.8]\n",
         "4 pixels that are not finite or negative"},
        {"LightSource \"projection\" \"string mapname\" [\"bad.exr\"] \"point from\" [0 0 1.5] "
         "\"point to\" [0 0 0]\nShape \"sphere\" \"float radius\" [0.8]\n",
         "4 pixels that are not finite or negative"}};
    for (const stress::RenderWay& way : stress::main_ways()) {
        const double clean = clean_mean(way, folder);
        for (const auto& [world, message] : worlds) {
            SCOPED_TRACE(way.name + ": " + world);
            const Outcome outcome = stress::render_scene(stress::room(world), way, folder, 4);
            expect_sane(outcome, clean, outcome.messages);
            EXPECT_THAT(outcome.messages, HasSubstr(message));
            EXPECT_THAT(outcome.messages, HasSubstr("scene.lxs:"));
        }
    }
    stress::record("NaN, +-inf and -2 in the image of a texture, sky and projector",
                   "one located message each");
}

/// A gamma takes a finite texel beyond the numbers after the file was checked; one that would
/// divide is an error.
TEST(StressRefusedLight, AnImageThatItsGammaSpoils) {
    const render::Folder folder;
    render::Image image{8, 4, std::vector<float>(96, 0.5f)};
    std::fill_n(image.rgb.begin(), 48, 1e30f);
    render::write_image(image, folder.path() / "bright.exr");
    const auto texture = [](const std::string& gamma) {
        return "Texture \"bad\" \"color\" \"imagemap\" \"string filename\" [\"bright.exr\"] "
               "\"float gamma\" [" +
               gamma + "]\n";
    };
    for (const stress::RenderWay& way : stress::main_ways()) {
        SCOPED_TRACE(way.name);
        const Outcome outcome =
            stress::render_scene(stress::room(textured_ball(texture("2.2"))), way, folder, 4);
        expect_sane(outcome, clean_mean(way, folder), outcome.messages);
        EXPECT_THAT(outcome.origins("texture values"),
                    ElementsAre(R"(texture "bad" of material "spoiled")"));
    }
    const Outcome divided = stress::render_scene(stress::room(textured_ball(texture("-1"))),
                                                 stress::strict_way(), folder, 1);
    EXPECT_EQ(divided.exit_code, 3);
    EXPECT_THAT(divided.messages, HasSubstr("scene.lxs:"));
    stress::record("texels of 1e30 to the power of 2.2, and of -1",
                   "counted by material; a located error");
}

/// Numbers that a scene can write, but no light can have; what a file can't even say is an error.
TEST(StressRefusedLight, LightsWithColoursThatAreNone) {
    const render::Folder folder;
    const std::vector<std::pair<std::string, std::string>> worlds{
        {"LightSource \"point\" \"point from\" [0 0 1] \"color L\" [1 -1 1]\n", "taken for 0"},
        {"LightSource \"infinite\" \"color L\" [1e38 1 1] \"float gain\" [100]\n", "taken for 0"},
        {"LightSource \"distant\" \"color L\" [-1 -1 -1]\n", "taken for 0"},
        {"LightSource \"point\" \"point from\" [0 0 1] \"color L\" [1e30 1e30 1e30] \"float gain\" "
         "[1e30]\n",
         "taken for 0"}};
    for (const stress::RenderWay& way : stress::main_ways()) {
        for (const auto& [world, message] : worlds) {
            SCOPED_TRACE(way.name + ": " + world);
            const Outcome outcome = stress::render_scene(stress::room(world), way, folder, 2);
            ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
            EXPECT_EQ(outcome.bad_pixels(), 0u);
            EXPECT_THAT(outcome.messages, HasSubstr(message));
            EXPECT_THAT(outcome.messages, HasSubstr("scene.lxs:"));
        }
    }
    for (const char* number : {"nan", "inf", "1e39", "-1e400"}) {
        const std::string world =
            stress::room("LightSource \"point\" \"color L\" [" + std::string(number) + " 1 1]\n");
        const Outcome outcome = stress::render_scene(world, stress::main_ways().front(), folder, 2);
        EXPECT_EQ(outcome.exit_code, 0) << number << ": the default in its place";
        EXPECT_EQ(outcome.bad_pixels(), 0u) << number;
        EXPECT_THAT(outcome.messages, HasSubstr("scene.lxs:")) << number;
        const Outcome strict = stress::render_scene(world, stress::strict_way(), folder, 1);
        EXPECT_EQ(strict.exit_code, 3) << number;
        EXPECT_THAT(strict.messages, HasSubstr("scene.lxs:")) << number;
    }
    stress::record("L below 0 and beyond 3.4e38, nan and inf in the file",
                   "located warning or error");
}

/// An area light whose L times gain is no number is the integrator's to refuse: by the light.
TEST(StressRefusedLight, AreaLightBeyondTheNumbers) {
    const render::Folder folder;
    const std::string lamp =
        "AttributeBegin\nAreaLightSource \"area\" \"color L\" [1e38 1e38 1e38] \"float gain\" "
        "[1000] \"float power\" [0] \"float efficacy\" [0]\n" +
        stress::quad("-1 -1 1.8  -1 1 1.8  1 1 1.8  1 -1 1.8") + "AttributeEnd\n";
    for (const stress::RenderWay& way : stress::main_ways()) {
        SCOPED_TRACE(way.name);
        const Outcome outcome = stress::render_scene(stress::room(lamp), way, folder, 4);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
        EXPECT_EQ(outcome.bad_pixels(), 0u);
        EXPECT_THAT(outcome.origins("contributions"), ElementsAre("light 1 (area)"));
        EXPECT_THAT(outcome.messages, HasSubstr("contributions of light 1 (area)"));
    }
    stress::record("an area light of L 1e38 and gain 1000", "refused by light");
}

}  // namespace
}  // namespace refused_light_test
