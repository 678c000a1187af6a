// Protects renders of meshes that are hard or wrong: triangles without area and needles, coincident
// surfaces, vertices and normals that are no numbers, of no length or turned round, glass inside
// out and nested, thin walls, and millions of triangles. Each is refused with one message at its
// place in the scene, or has the image of the same geometry in a clean form.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stress_case.h"
#include "stressed_scene.h"

namespace hard_meshes_test {
namespace {

using stress::Outcome;
using testing::HasSubstr;

std::size_t occurrences(const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size())
        ++count;
    return count;
}

/// The same mean in every way, and nothing refused. Returns the worst difference.
double expect_same(const std::string& hard, const std::string& clean, double bound,
                   const std::vector<stress::RenderWay>& ways, int passes = 6) {
    const render::Folder folder;
    double worst = 0;
    for (const stress::RenderWay& way : ways) {
        SCOPED_TRACE(way.name);
        const Outcome expected = stress::render_scene(stress::room(clean), way, folder, passes);
        const Outcome outcome = stress::render_scene(stress::room(hard), way, folder, passes);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
        EXPECT_EQ(expected.exit_code, 0) << expected.messages;
        if (outcome.exit_code != 0 || expected.exit_code != 0) continue;
        EXPECT_EQ(outcome.bad_pixels(), 0u);
        EXPECT_TRUE(outcome.statistics.at("refused").empty())
            << outcome.statistics.at("refused").dump();
        EXPECT_NEAR(outcome.mean(), expected.mean(), bound * expected.mean());
        worst = std::max(worst, std::abs(outcome.mean() / expected.mean() - 1));
    }
    return worst;
}

std::string difference(double worst, double bound) {
    return fmt::format("mean off by {:.4f} of at most {}", worst, bound);
}

const char* const kSheet = "-1 0.5 -1.5  1 0.5 -1.5  1 0.5 0.5  -1 0.5 0.5";

/// A sheet of `needles` pairs of triangles as long as it and as thin as they are many.
std::string needles(int count) {
    std::string points, indices;
    for (int i = 0; i <= count; ++i) {
        const double x = -1 + 2.0 * i / count;
        points += fmt::format("{} 0.5 -1.5 {} 0.5 0.5 ", x, x);
        if (i < count) {
            const int k = 2 * i;
            indices += fmt::format("{} {} {} {} {} {} ", k, k + 2, k + 3, k, k + 3, k + 1);
        }
    }
    return "Shape \"trianglemesh\" \"point P\" [" + points + "] \"integer triindices\" [" +
           indices + "]\n";
}

TEST(StressMeshes, TrianglesWithoutAreaAreLeftOutWithOneMessage) {
    const std::string mesh =
        "Shape \"trianglemesh\" \"point P\" [-1 0.5 -1.5  1 0.5 -1.5  1 0.5 0.5  -1 0.5 0.5  0 0 0 "
        " 1 1 1  2 2 2] \"integer triindices\" [0 1 2  0 2 3  4 5 6  0 0 1  5 5 5]\n";
    const double worst = expect_same(mesh, stress::quad(kSheet), 0.02, stress::main_ways());
    const render::Folder folder;
    const Outcome outcome =
        stress::render_scene(stress::room(mesh), stress::main_ways().front(), folder);
    EXPECT_THAT(outcome.messages, HasSubstr("3 triangles without area left out"));
    EXPECT_EQ(occurrences(outcome.messages, "warning"), 1u) << outcome.messages;
    EXPECT_THAT(outcome.messages, HasSubstr("scene.lxs:"));
    stress::record("3 of 5 triangles without area", difference(worst, 0.02));
}

TEST(StressMeshes, Needles) {
    const int count = stress::sized(2000, 200'000);
    const double worst =
        expect_same(needles(count), stress::quad(kSheet), 0.02, stress::main_ways());
    stress::record(fmt::format("a sheet of triangles 2 long and {} wide", 2.0 / count),
                   difference(worst, 0.02));
}

TEST(StressMeshes, CoincidentSurfaces) {
    const std::string sheet = stress::quad(kSheet);
    const double twice = expect_same(sheet + sheet, sheet, 0.02, stress::main_ways());
    const double turned =
        expect_same(sheet + "AttributeBegin\nReverseOrientation\n" + sheet + "AttributeEnd\n",
                    sheet, 0.02, stress::main_ways());
    stress::record("a sheet twice, and back to back", difference(std::max(twice, turned), 0.02));
}

/// A lamp in the very plane of a wall: which of both a ray meets is the tracer's choice, so that
/// light may be lost, but none is made.
TEST(StressMeshes, LampInTheWall) {
    const render::Folder folder;
    const std::string lamp =
        "AttributeBegin\nAreaLightSource \"area\" \"color L\" [3 3 3] \"float power\" [0] \"float "
        "efficacy\" [0]\n";
    const std::string in_wall =
        lamp + stress::quad("-1 -1 2  -1 1 2  1 1 2  1 -1 2") + "AttributeEnd\n";
    const std::string before =
        lamp + stress::quad("-1 -1 1.99  -1 1 1.99  1 1 1.99  1 -1 1.99") + "AttributeEnd\n";
    double worst = 0;
    for (const stress::RenderWay& way : stress::all_ways()) {
        SCOPED_TRACE(way.name);
        const Outcome hard = stress::render_scene(stress::room(in_wall, false), way, folder, 6);
        const Outcome clean = stress::render_scene(stress::room(before, false), way, folder, 6);
        ASSERT_EQ(hard.exit_code, 0) << hard.messages;
        EXPECT_EQ(hard.bad_pixels(), 0u);
        EXPECT_LT(hard.mean(), 1.1 * clean.mean());
        EXPECT_GT(hard.mean(), 0.5 * clean.mean());
        EXPECT_TRUE(hard.statistics.at("refused").empty());
        worst = std::max(worst, std::abs(hard.mean() / clean.mean() - 1));
    }
    stress::record("a lamp in the plane of the ceiling", difference(worst, 0.5));
}

std::string ply(const std::string& vertices, const std::string& normals = "") {
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
           "float z\n" +
           normals + "element face 2\nproperty list uchar int vertex_indices\nend_header\n" +
           vertices + "3 0 1 2\n3 0 2 3\n";
}

/// What is no number in a mesh file is one error at the statement that names the file.
TEST(StressMeshes, VerticesAndNormalsThatAreNoNumbers) {
    const render::Folder folder;
    const std::string normals = "property float nx\nproperty float ny\nproperty float nz\n";
    const std::vector<std::pair<std::string, std::string>> files{
        {ply("nan 0.5 -1\n1 0.5 -1\n1 0.5 1\n-1 0.5 1\n"), "vertex 0 of"},
        {ply("-1 0.5 -1\n1 inf -1\n1 0.5 1\n-1 0.5 1\n"), "vertex 1 of"},
        {ply("-1 0.5 -1\n1 0.5 -1\n1 0.5 -1e30\n-1 0.5 1\n"), "vertex 2 of"},
        {ply("-1 0.5 -1 0 0 1\n1 0.5 -1 0 nan 0\n1 0.5 1 0 0 1\n-1 0.5 1 0 0 1\n", normals),
         "normal 1 of"},
        {ply("-1 0.5 -1 0 0 1\n1 0.5 -1 0 1 0\n1 0.5 1 0 0 1\n-1 0.5 1 -inf 0 1\n", normals),
         "normal 3 of"}};
    for (const auto& [text, message] : files) {
        folder.write("bad.ply", text);
        const Outcome outcome = stress::render_scene(
            stress::room("Shape \"plymesh\" \"string filename\" [\"bad.ply\"]\n"),
            stress::strict_way(), folder, 1);
        EXPECT_EQ(outcome.exit_code, 3) << outcome.messages;
        EXPECT_THAT(outcome.messages, HasSubstr(message));
        EXPECT_EQ(occurrences(outcome.messages, "error:"), 1u) << outcome.messages;
        EXPECT_THAT(outcome.messages, HasSubstr("scene.lxs:"));
    }
    stress::record("PLY files with NaN, infinity and 1e30 in vertices and normals",
                   std::to_string(files.size()) + " located errors");
}

/// Normals of no length are those of the triangles; turned ones are turned back.
TEST(StressMeshes, NormalsOfNoLengthAndTurned) {
    const std::string sheet =
        "Shape \"trianglemesh\" \"integer triindices\" [0 1 2 0 2 3] \"point "
        "P\" [" +
        std::string(kSheet) + "] \"normal N\" [";
    const std::string zero = sheet + "0 0 0 0 0 0 0 0 0 0 0 0]\n";
    const std::string turned = sheet + "0 1 0 0 1 0 0 1 0 0 1 0]\n";
    const std::string tiny = sheet + "0 -1e-38 0 0 -1e-30 0 0 -1e-20 0 0 -1 0]\n";
    const std::string in_plane = sheet + "1 0 0 1 0 0 1 0 0 1 0 0]\n";
    const std::string opposed = sheet + "0 1 0 0 -1 0 0 1 0 0 -1 0]\n";
    const double none = expect_same(zero, stress::quad(kSheet), 0.02, stress::main_ways());
    const double back = expect_same(turned, stress::quad(kSheet), 0.02, stress::main_ways());
    const double short_ones = expect_same(tiny, stress::quad(kSheet), 0.02, stress::main_ways());
    // These bend the light, so that only its amount is that of the sheet.
    const double bent =
        std::max(expect_same(in_plane, stress::quad(kSheet), 0.3, stress::all_ways()),
                 expect_same(opposed, stress::quad(kSheet), 0.3, stress::all_ways()));
    stress::record(
        "normals of length 0 and 1e-38, turned; in the plane, opposed",
        difference(std::max({none, back, short_ones}), 0.02) + "; " + difference(bent, 0.3));
}

/// Glass under a sky of 1, seen alone: it absorbs nothing, so that everything shows 1.
std::string under_sky(const std::string& world) {
    return "LookAt 0 -4 0  0 0 0  0 0 1\nCamera \"perspective\" \"float fov\" [12]\n"
           "Film \"fleximage\" \"integer xresolution\" [16] \"integer yresolution\" [12]\n"
           "PixelFilter \"box\" \"float xwidth\" [0.5] \"float ywidth\" [0.5]\nWorldBegin\n"
           "LightSource \"infinite\" \"color L\" [1 1 1]\n"
           "MakeNamedMaterial \"white\" \"string type\" [\"matte\"] \"color Kd\" [1 1 1]\n"
           "MakeNamedMaterial \"glass\" \"string type\" [\"glass\"] \"color Kr\" [1 1 1] \"color "
           "Kt\" "
           "[1 1 1] \"float index\" [1.5]\n" +
           world + "WorldEnd\n";
}

std::string ball(const std::string& material, double radius, double x = 0, bool turned = false) {
    return fmt::format(
        "AttributeBegin\nTranslate {} 0 0\nNamedMaterial \"{}\"\n{}Shape "
        "\"sphere\" \"float radius\" [{}]\nAttributeEnd\n",
        x, material, turned ? "ReverseOrientation\n" : "", radius);
}

TEST(StressMeshes, GlassInsideOutNestedAndOverlapping) {
    const std::vector<std::pair<std::string, std::string>> worlds{
        {"inside out", ball("glass", 0.5, 0, true)},
        {"nested", ball("glass", 0.5) + ball("glass", 0.4)},
        {"nested, the inner inside out", ball("glass", 0.5) + ball("glass", 0.4, 0, true)},
        {"coincident", ball("glass", 0.5) + ball("glass", 0.5)},
        {"overlapping", ball("glass", 0.4, -0.2) + ball("glass", 0.4, 0.2)},
        {"white in glass", ball("glass", 0.5) + ball("white", 0.3, 0.05)}};
    const render::Folder folder;
    double worst = 0;
    for (stress::RenderWay way : stress::all_ways()) {
        const std::string name = way.name.starts_with("aips") ? "aips"
                                 : way.name == "sppm"         ? "sppm"
                                                              : "path";
        const std::string set = " --set " + name;
        way.arguments += set + (name == "path" ? ".maxdepth=200" : ".maxeyedepth=200");
        if (name != "path") way.arguments += set + ".maxphotondepth=200";
        for (const auto& [what, world] : worlds) {
            SCOPED_TRACE(way.name + ": " + what);
            const Outcome outcome = stress::render_scene(under_sky(world), way, folder, 12);
            ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
            EXPECT_EQ(outcome.bad_pixels(), 0u);
            EXPECT_TRUE(outcome.statistics.at("refused").empty());
            EXPECT_NEAR(outcome.mean(), 1, 0.12);
            worst = std::max(worst, std::abs(outcome.mean() - 1));
        }
    }
    stress::record("6 arrangements of glass under a sky of 1, 8 ways", difference(worst, 0.12));
}

/// The camera stands in a closed room whose walls have no thickness; a bright light shines on them
/// from outside. Whatever the radius, nothing may come in.
TEST(StressMeshes, NoLightThroughWallsWithoutThickness) {
    const render::Folder folder;
    const std::string light =
        "LightSource \"point\" \"point from\" [0 6 5] \"color L\" [1e6 1e6 1e6]\n"
        "LightSource \"point\" \"point from\" [5 -1 -6] \"color L\" [1e6 1e6 1e6]\n";
    double worst = 0;
    for (stress::RenderWay way : stress::all_ways()) {
        SCOPED_TRACE(way.name);
        if (way.name.starts_with("aips")) way.arguments += " --set aips.directlightsampling=false";
        if (way.name == "sppm") way.arguments += " --set sppm.directlightsampling=false";
        const Outcome outcome = stress::render_scene(stress::room(light, false), way, folder, 4);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
        for (const float value : outcome.image.rgb)
            EXPECT_EQ(value, 0);
        worst = std::max(worst, outcome.mean());
    }
    stress::record("a dark room of sheets under 1e6 W/sr from outside",
                   fmt::format("radiance {} of at most 0", worst));
}

/// Writes a floor of side * side quads as a binary PLY.
void write_floor(const render::Folder& folder, std::uint32_t side) {
    const std::uint64_t vertices = std::uint64_t{side + 1} * (side + 1);
    const std::uint64_t faces = std::uint64_t{2} * side * side;
    std::string file = fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float "
        "y\nproperty float z\nelement face {}\nproperty list uchar int "
        "vertex_indices\nend_header\n",
        vertices, faces);
    const auto put = [&](const auto& value) {
        file.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    for (std::uint32_t y = 0; y <= side; ++y) {
        for (std::uint32_t x = 0; x <= side; ++x) {
            put(-2 + 4 * float(x) / float(side));
            put(-2 + 4 * float(y) / float(side));
            put(-1.9f);
        }
    }
    const auto put_face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        put(std::uint8_t{3});
        for (const std::uint32_t corner : {a, b, c})
            put(static_cast<std::int32_t>(corner));
    };
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t corner = y * (side + 1) + x;
            put_face(corner, corner + 1, corner + side + 2);
            put_face(corner, corner + side + 2, corner + side + 1);
        }
    }
    folder.write("floor.ply", file);
}

TEST(StressMeshes, MillionsOfTriangles) {
    const render::Folder folder;
    const std::uint32_t side = stress::sized(300u, 1800u);
    write_floor(folder, side);
    const std::string many = "Shape \"plymesh\" \"string filename\" [\"floor.ply\"]\n";
    const std::string two = stress::quad("-2 -2 -1.9  2 -2 -1.9  2 2 -1.9  -2 2 -1.9");
    double worst = 0, bytes = 0;
    for (const stress::RenderWay& way : stress::main_ways()) {
        SCOPED_TRACE(way.name);
        const Outcome clean = stress::render_scene(stress::room(two), way, folder, 6);
        const Outcome outcome = stress::render_scene(stress::room(many), way, folder, 6);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
        EXPECT_EQ(outcome.bad_pixels(), 0u);
        EXPECT_TRUE(outcome.statistics.at("refused").empty());
        EXPECT_NEAR(outcome.mean(), clean.mean(), 0.02 * clean.mean());
        worst = std::max(worst, std::abs(outcome.mean() / clean.mean() - 1));
        const auto peak = [](const Outcome& o) {
            return o.statistics.at("peak memory bytes").get<double>();
        };
        bytes = std::max(bytes, (peak(outcome) - peak(clean)) / (2.0 * side * side));
    }
    EXPECT_LT(bytes, 1000) << "memory per triangle, file and build included";
    stress::record(
        fmt::format("a floor of {} triangles", 2 * side * side),
        difference(worst, 0.02) + fmt::format("; {:.0f} bytes a triangle of at most 1000", bytes));
}

}  // namespace
}  // namespace hard_meshes_test
