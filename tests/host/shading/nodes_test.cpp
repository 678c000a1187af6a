// Texture "nodes": programs, their errors, and formulas whose values are known. How whole graphs
// look beside Cycles: tests/blender/nodes_test.py.
#include <gtest/gtest.h>

#include <cmath>

#include "lxs/spectrum/reflectance_colour.h"
#include "shading_fixture.h"

namespace lxs::nodes_test {
namespace {

class NodesTest : public ::testing::Test {
  protected:
    std::shared_ptr<const ColorTexture> make(const std::vector<std::string>& program) {
        ParameterValue lines = text("program", "");
        lines.values = program;
        return scene_.make_color("nodes", {lines});
    }
    Rgb value(const std::vector<std::string>& program, const TexturePoint& point = {}) {
        return make(program)->evaluate(point);
    }
    void expect(const std::vector<std::string>& program, const Rgb& wanted) {
        const Rgb found = value(program);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], wanted[c], 1e-5f) << program.back();
    }
    std::string error(const std::vector<std::string>& program) {
        try {
            make(program);
        } catch (const InputError& error) {
            return error.message();
        }
        return "";
    }

    ShadingFixture scene_;
};

TEST_F(NodesTest, Formulas) {
    const std::string red = "value 0.8 0.2 0.1";
    expect({"math multiply_add 2 3 4"}, Rgb(10.0f));
    expect({"math divide 2 0 0"}, Rgb(0.0f));
    expect({"math pingpong 2.7 1 0"}, Rgb(0.7f));
    expect({"math logarithm 8 2 0"}, Rgb(3.0f));
    expect({red, "vector dot_product r0 r0 0 0"}, Rgb(0.69f));
    expect({red, "channel y r0"}, Rgb(0.2f));
    expect({red, "luminance r0"}, Rgb(0.8f * 0.2126f + 0.2f * 0.7152f + 0.1f * 0.0722f));
    expect({red, "tohsv r0", "fromhsv r1"}, {0.8f, 0.2f, 0.1f});
    expect({red, "invert 1 r0"}, {0.2f, 0.8f, 0.9f});
    expect({red, "gamma r0 2"}, {0.64f, 0.04f, 0.01f});
    expect({red, "huesaturation 0.5 0 1 1 r0"}, Rgb(0.8f));
    expect({"ramp linear 0.75 0 0 0 0 1 1 2 4"}, {0.75f, 1.5f, 3});
    expect({"ramp constant 0.75 0 5 5 5 1 1 2 4"}, Rgb(5.0f));
    expect({"curves 2 0 1 0 0 0 1 2 3"}, {2, 4, 6});  // on beyond its ends
    expect({"maprange stepped 0.6 0 1 0 10 4"}, Rgb(7.5f));
    expect({red, "mix screen 1 r0 0.5"}, {0.9f, 0.6f, 0.55f});
    expect({red, "affine r0 0 1 0 5 1 0 0 0 0 0 2 0"}, {5.2f, 0.8f, 0.2f});
}

TEST_F(NodesTest, ConstantProgramsAreConstant) {
    EXPECT_EQ(make({"value 1 2 3"})->constant(), Rgb(1, 2, 3));
    EXPECT_FALSE(make({"position"})->constant());
    EXPECT_FALSE(make({"uv"})->reads_image());
}

TEST_F(NodesTest, ReadsTheSurface) {
    TexturePoint point;
    point.p = {1, 2, 3};
    point.uv = {0.25f, 0.5f};
    Matrix half;
    half.setScale(Imath::V3d(0.5));
    point.object_to_shape = &half;
    EXPECT_EQ(value({"position"}, point), Rgb(1, 2, 3));
    EXPECT_EQ(value({"local"}, point), Rgb(0.5f, 1, 1.5f));
    EXPECT_EQ(value({"uv"}, point), Rgb(0.25f, 0.5f, 0));
}

TEST_F(NodesTest, TexturesAreReadHereOrElsewhere) {
    scene_.colors["where"] = scene_.make_color("uv", {});
    ParameterValue lines = text("program", "texture 1");
    lines.values = std::vector<std::string>{"texture 1", "uv", "vector add r1 0.25 0 0",
                                            "textureat 1 r2", "vector subtract r3 r0 0 0"};
    const auto made = scene_.make_color("nodes", {lines, texture("tex1", "where")});
    TexturePoint point;
    point.uv = {0.5f, 0.25f};
    EXPECT_EQ(made->evaluate(point), Rgb(0.25f, 0.25f, 0));
    EXPECT_FALSE(made->constant());
}

TEST_F(NodesTest, ValuesAreFinite) {
    expect({"value 1e30 0 0", "vector multiply r0 r0 0 0", "math subtract r1 r1 0"}, Rgb(0.0f));
    TexturePoint far;
    far.p = Vec3(3e38f);
    for (const char* pattern :
         {"noise color 4d r0 1e30 1e9 15 1 2 5",
          "voronoi 3d smooth_f1 minkowski position r0 1e9 1 1 1e-9",
          "brick color r0 1e9 1 0 0 .1 .1 0 1e-9 1e-9 .5 2 1 2", "magic color r0 1e9 10 1e9",
          "wave rings diagonal saw r0 1e9 5 15 3 1 0", "checker r0 1e9 1 0"}) {
        const Rgb found = value({"position", pattern}, far);
        EXPECT_TRUE(std::isfinite(found.x + found.y + found.z)) << pattern;
    }
}

TEST_F(NodesTest, NoiseIsThatOfCycles) {
    TexturePoint point;
    point.p = {0.3f, 1.7f, -2.4f};
    EXPECT_NEAR(value({"position", "noise fac 3d r0 0 1 0 0.5 2 0"}, point).x,
                value({"position", "noise fac 3d r0 0 1 0 0.9 3 0"}, point).x, 1e-6f);
    EXPECT_FLOAT_EQ(value({"noise fac 3d 3 0 1 4 0.5 2 0"}).x, 0.5f);  // at corners of the lattice
}

TEST_F(NodesTest, PlainColorsAreSeenAsTheyAre) {
    ParameterValue lines = text("program", "value 0.7 0.2 0.1");
    const auto plain = scene_.make_color("nodes", {lines, flag("plaincolors", true)});
    EXPECT_LT((colour_of_reflectance(plain->evaluate({})) - Rgb(0.7f, 0.2f, 0.1f)).length(), 1e-4f);
}

TEST_F(NodesTest, ErrorsNameTheInstruction) {
    EXPECT_EQ(error({"value 1 2 3", "vakue 1 2 3"}),
              "nodes: instruction 1: there is no instruction \"vakue\"");
    EXPECT_EQ(error({"value 1 2"}), "nodes: instruction 0: \"value\" takes 3 words, not 2");
    EXPECT_EQ(error({"luminance r0"}),
              "nodes: instruction 0: \"r0\" names no instruction before this one");
    EXPECT_EQ(error({"value 1 2 three"}), "nodes: instruction 0: \"three\" is no number");
    EXPECT_EQ(error({"channel w 1"}), "nodes: instruction 0: \"w\" is none of x, y, z");
    EXPECT_EQ(error({"texture 1"}),
              "nodes: instruction 0: \"texture\" takes the number of a texture that is given");
    EXPECT_EQ(error({"ramp linear 1 1 0 0 0 0 0 0 0"}),
              "nodes: instruction 0: the stops of \"ramp\" must rise");
    EXPECT_EQ(error(std::vector<std::string>(257, "uv")),
              "nodes: it has 257 instructions, more than 256");
}

}  // namespace
}  // namespace lxs::nodes_test
