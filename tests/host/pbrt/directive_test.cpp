// Directives, the graphics state, included files, and what is said of bad input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lxs/pbrt/read_pbrt.h"
#include "scene_fakes.h"
#include "temporary_folder.h"

namespace lxs::test::pbrt_directive_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Read {
    SceneContents contents;
    std::vector<std::string> messages;
};

Read read(const std::string& text, const std::string& folder = ".") {
    Registry registry;
    register_shapes(registry);
    register_shading(registry);
    LenientDiagnostics diagnostics;
    Read result{read_pbrt_text(text, "test.pbrt", folder, registry, diagnostics), {}};
    result.messages = diagnostics.messages;
    return result;
}
Read read_pbrt_world(const std::string& world) {
    return read("WorldBegin\n" + world);
}
std::vector<std::string> messages_of(const std::string& world) {
    return read_pbrt_world(world).messages;
}

TEST(PbrtDirectives, AnEmptyWorldHasPbrtsDefaults) {
    const Read scene = read("WorldBegin\nLightSource \"point\"\n");
    EXPECT_THAT(scene.messages, IsEmpty());
    const auto& options = scene.contents.options;
    EXPECT_EQ(options.at("Film").parameters.plugin, "fleximage");
    EXPECT_EQ(options.at("Camera").parameters.plugin, "perspective");
    EXPECT_EQ(options.at("PixelFilter").parameters.plugin, "gaussian");
    EXPECT_EQ(options.at("SurfaceIntegrator").parameters.plugin, "path");
    EXPECT_EQ(scene.contents.lights.size(), 1u);
}

TEST(PbrtDirectives, MaterialsAreNamedByTheirPlaces) {
    const Read scene = read_pbrt_world(
        "MakeNamedMaterial \"wood\" \"string type\" \"diffuse\"\n"
        "NamedMaterial \"wood\" Shape \"sphere\"\n"
        "Material \"diffuse\" Shape \"sphere\"");
    EXPECT_THAT(scene.messages, IsEmpty());
    EXPECT_THAT(scene.contents.material_names, ElementsAre("wood", "diffuse (test.pbrt:4)"));
    EXPECT_EQ(scene.contents.primitives.at(0).material_index, 0u);
    EXPECT_EQ(scene.contents.primitives.at(1).material_index, 1u);
}

TEST(PbrtDirectives, AttributesAreRestored) {
    const Read scene = read_pbrt_world(
        "MakeNamedMaterial \"a\" \"string type\" \"diffuse\" NamedMaterial \"a\"\n"
        "AttributeBegin Material \"dielectric\" Translate 1 2 3 ReverseOrientation\n"
        "AreaLightSource \"diffuse\" Shape \"sphere\" AttributeEnd\nShape \"sphere\"");
    const auto& primitives = scene.contents.primitives;
    ASSERT_EQ(primitives.size(), 2u);
    EXPECT_TRUE(primitives[0].emission.has_value());
    EXPECT_TRUE(primitives[0].reverse_orientation);
    EXPECT_EQ(primitives[0].to_world[3][1], 2);
    EXPECT_FALSE(primitives[1].emission.has_value());
    EXPECT_FALSE(primitives[1].reverse_orientation);
    EXPECT_EQ(primitives[1].to_world, Matrix());
    EXPECT_EQ(scene.contents.material_names[primitives[1].material_index], "a");
}

TEST(PbrtDirectives, TransformsOfVersion3KeepTheRest) {
    const Read scene = read_pbrt_world(
        "TransformBegin Scale 2 2 2 Material \"diffuse\" Shape \"sphere\" TransformEnd Shape "
        "\"sphere\"");
    EXPECT_EQ(scene.contents.primitives.at(0).to_world[0][0], 2);
    EXPECT_EQ(scene.contents.primitives.at(1).to_world[0][0], 1);
    EXPECT_EQ(scene.contents.primitives[1].material_index,
              scene.contents.primitives[0].material_index);
}

TEST(PbrtDirectives, CoordinateSystems) {
    const Read scene = read(
        "Translate 0 0 5 Camera \"perspective\" WorldBegin\n"
        "Translate 1 0 0 CoordinateSystem \"here\" Identity Shape \"sphere\"\n"
        "CoordSysTransform \"here\" Shape \"sphere\"\n"
        "CoordSysTransform \"camera\" Shape \"sphere\"\nCoordSysTransform \"no\"");
    EXPECT_EQ(scene.contents.primitives.at(0).to_world[3][0], 0);
    EXPECT_EQ(scene.contents.primitives.at(1).to_world[3][0], 1);
    EXPECT_EQ(scene.contents.primitives.at(2).to_world[3][2], -5);
    EXPECT_THAT(
        scene.messages,
        ElementsAre(HasSubstr("test.pbrt:5:19: warning: unknown coordinate system \"no\"")));
}

TEST(PbrtDirectives, AttributeSetsDefaults) {
    const Read scene = read_pbrt_world(
        "Attribute \"shape\" \"float radius\" 3\nAttribute \"material\" \"float roughness\" 0.1\n"
        "Material \"diffuse\" Shape \"sphere\" Shape \"sphere\" \"float radius\" 2");
    EXPECT_THAT(scene.messages, IsEmpty()) << "a default that nobody asks for is no mistake";
    EXPECT_EQ(
        std::get<Sphere>(std::get<Quadric>(scene.contents.primitives.at(0).geometry).shape).radius,
        3);
    EXPECT_EQ(
        std::get<Sphere>(std::get<Quadric>(scene.contents.primitives.at(1).geometry).shape).radius,
        2);
}

TEST(PbrtDirectives, ActiveTransformMovesShapesAndInstances) {
    const Read scene = read(
        "TransformTimes 0 2\nWorldBegin\n"
        "ObjectBegin \"ball\" Shape \"sphere\" ObjectEnd\n"
        "AttributeBegin ActiveTransform EndTime Translate 0 3 0 ActiveTransform All\n"
        "ObjectInstance \"ball\" Shape \"sphere\" AttributeEnd\nShape \"sphere\"");
    EXPECT_THAT(scene.messages, IsEmpty());
    ASSERT_EQ(scene.contents.instances.size(), 2u);
    for (const Instance& instance : scene.contents.instances) {
        ASSERT_EQ(instance.motion.size(), 2u);
        EXPECT_EQ(instance.motion[0].time, 0);
        EXPECT_EQ(instance.motion[1].time, 2);
        EXPECT_EQ(instance.motion[1].matrix[3][1], 3);
        EXPECT_EQ(instance.motion[0].matrix, Matrix());
    }
    EXPECT_EQ(scene.contents.primitives.size(), 1u);
}

TEST(PbrtDirectives, LightsInObjectsAreOfTheWorld) {
    const Read scene = read_pbrt_world(
        "ObjectBegin \"o\" Translate 1 0 0 LightSource \"point\" AreaLightSource \"diffuse\" Shape "
        "\"sphere\" ObjectEnd\n"
        "ObjectInstance \"o\" Translate 2 0 0 ObjectInstance \"o\"");
    EXPECT_THAT(scene.messages,
                ElementsAre(HasSubstr("area lights in objects do not shine, as in pbrt")));
    ASSERT_EQ(scene.contents.lights.size(), 1u);
    EXPECT_EQ(scene.contents.lights[0].to_world[3][0], 1);
    EXPECT_EQ(scene.contents.instances.size(), 2u);
}

TEST(PbrtDirectives, IncludeAndImport) {
    const files::TemporaryFolder folder;
    folder.write("part.pbrt",
                 "Material \"diffuse\"\nTranslate 1 0 0\nShape \"sphere\"\nShape \"spere\"");
    const Read included =
        read("WorldBegin Include \"part.pbrt\" Shape \"sphere\"", folder.path().string());
    EXPECT_EQ(included.contents.primitives.at(1).to_world[3][0], 1);
    ASSERT_EQ(included.messages.size(), 1u);
    EXPECT_THAT(
        included.messages[0],
        HasSubstr("part.pbrt:4:7: error: unknown shape \"spere\"; did you mean \"sphere\"?"));
    const Read imported =
        read("WorldBegin Import \"part.pbrt\" Shape \"sphere\"", folder.path().string());
    EXPECT_EQ(imported.contents.primitives.at(0).to_world[3][0], 1);
    EXPECT_EQ(imported.contents.primitives.at(1).to_world[3][0], 0)
        << "an import has a state of its own";
}

TEST(PbrtDirectives, IncludesOfOtherFoldersAreNotTheSceneItself) {
    const files::TemporaryFolder folder;
    folder.write("hair.pbrt", "Camera \"perspective\"");
    EXPECT_THAT(
        read("WorldBegin Include \"models/hair.pbrt\"", folder.path().string()).messages,
        ElementsAre(AllOf(HasSubstr("test.pbrt:1:20: warning: no file \"models/hair.pbrt\", but"),
                          HasSubstr("which lies elsewhere; it is ignored"))));
}

TEST(PbrtDirectives, IncludesGoOnWithParameters) {
    const files::TemporaryFolder folder;
    folder.write("radius.pbrt", "# a comment\n \"float radius\" 3 \"float zmin\" -1\n");
    const Read scene = read(
        "WorldBegin Shape \"sphere\" Include \"radius.pbrt\" \"float zmax\" 2 Shape \"sphere\"",
        folder.path().string());
    EXPECT_THAT(scene.messages, IsEmpty());
    const auto sphere = [&](std::size_t i) {
        return std::get<Sphere>(std::get<Quadric>(scene.contents.primitives.at(i).geometry).shape);
    };
    EXPECT_EQ(sphere(0).radius, 3);
    EXPECT_EQ(sphere(0).z_min, -1);
    EXPECT_EQ(sphere(0).z_max, 2);
    EXPECT_EQ(sphere(1).radius, 1);
    folder.write("ball.pbrt", "Translate 1 0 0 Shape \"sphere\"");
    const Read behind = read("WorldBegin Include \"ball.pbrt\" \"float radius\" 4 Shape \"sphere\"",
                             folder.path().string());
    EXPECT_THAT(behind.messages, IsEmpty());
    EXPECT_EQ(
        std::get<Sphere>(std::get<Quadric>(behind.contents.primitives.at(0).geometry).shape).radius,
        4);
    folder.write("radius.pbrt", "\"float radius\" 3 Shape \"sphere\"");
    EXPECT_THAT(read("WorldBegin Shape \"sphere\" Include \"radius.pbrt\"", folder.path().string())
                    .messages,
                testing::Contains(HasSubstr("parameters and directives in one file")));
}

TEST(PbrtDirectives, WordsOfVersion3) {
    const Read scene = read(
        "Film \"image\" \"integer xresolution\" [40] \"integer yresolution\" [20]\n"
        "SurfaceIntegrator \"path\"\nPixelFilter \"gaussian\" \"float xwidth\" [2]\nWorldBegin\n"
        "LightSource \"infinite\" \"color L\" [1 1 1]\n"
        "Texture \"t\" \"color\" \"scale\" \"color tex1\" [1 0 0] \"float tex2\" [0.5]\n"
        "Material \"matte\" \"texture Kd\" \"t\"\n"
        "Material \"plastic\" \"color Kd\" [.1 .2 .3] \"color Ks\" [.5 .5 .5] \"float roughness\" "
        "[.1]\n"
        "Material \"uber\" \"color Kd\" [.1 .2 .3] Material \"substrate\" Material \"metal\" "
        "Material \"mirror\"\n"
        "Material \"glass\" \"float index\" [1.3] Material \"translucent\"\nMakeNamedMaterial "
        "\"m\" \"string type\" \"matte\"\n"
        "Material \"mix\" \"string namedmaterial1\" \"m\" \"string namedmaterial2\" \"m\" \"rgb "
        "amount\" [.5 .5 .5]\n"
        "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 0 0 0 1 0] "
        "\"float st\" [0 0 1 0 0 1]\n"
        "WorldEnd\n");
    EXPECT_THAT(scene.messages,
                ElementsAre(HasSubstr("material \"translucent\" of version 3 is read as")));
    EXPECT_EQ(scene.contents.options.at("Film").parameters.values.at(0).name, "xresolution");
}

TEST(PbrtDirectives, EveryShape) {
    const Read scene = read_pbrt_world(
        "Shape \"sphere\" \"float radius\" 2 \"float zmin\" -1\nShape \"disk\" \"float "
        "innerradius\" 0.5\n"
        "Shape \"cylinder\" \"float phimax\" 90\n"
        "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]\n"
        "Shape \"bilinearmesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 0]\n"
        "Shape \"loopsubdiv\" \"integer levels\" 1 \"integer indices\" [0 1 2 0 2 3 0 3 1 1 3 2] "
        "\"point3 P\" [0 0 0 1 0 0 0 1 0 0 0 1]\n"
        "Shape \"curve\" \"point3 P\" [0 0 0 1 0 0 2 1 0 3 1 0] \"float width\" 0.1\n"
        "Shape \"curve\" \"string basis\" \"bspline\" \"integer degree\" 2 \"point3 P\" [0 0 0 1 0 "
        "0 2 1 0 3 1 0]\n");
    EXPECT_EQ(scene.contents.primitives.size(), 7u) << "two curves are one mesh";
    EXPECT_THAT(scene.messages, ElementsAre(HasSubstr("curves are tubes")));
}

TEST(PbrtDirectives, BentPatchesLieOnTheirSurface) {
    // z = u v over the unit square; a flat patch stays two triangles.
    const Read scene = read_pbrt_world(
        "Shape \"bilinearmesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 1]\n"
        "Shape \"bilinearmesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 0]\n");
    const auto mesh = [&](std::size_t i) {
        return std::get<TriangleMesh>(scene.contents.primitives.at(i).geometry);
    };
    EXPECT_EQ(mesh(1).indices.size(), 6u);
    const TriangleMesh bent = mesh(0);
    EXPECT_GT(bent.indices.size(), 6u);
    ASSERT_EQ(bent.normals.size(), bent.positions.size());
    ASSERT_EQ(bent.uvs.size(), bent.positions.size());
    for (std::size_t i = 0; i < bent.positions.size(); ++i) {
        const Vec3& p = bent.positions[i];
        EXPECT_NEAR(p.z, p.x * p.y, 1e-6);
        EXPECT_NEAR(bent.uvs[i].x, p.x, 1e-6);
        const Vec3 normal = Vec3(-p.y, -p.x, 1).normalized();
        EXPECT_NEAR(bent.normals[i].dot(normal), 1, 1e-5);
    }
}

TEST(PbrtDirectives, CurvesOfOneStateAreOneMesh) {
    const std::string hair =
        "Shape \"curve\" \"point3 P\" [0 0 0 1 0 0 2 1 0 3 1 0] \"float width\" 0.1\n";
    const Read scene =
        read_pbrt_world(hair + hair + "Translate 1 0 0\n" + hair +
                        "Shape \"sphere\"\nMaterial \"diffuse\"\n" + hair + hair + hair);
    const auto triangles = [&](std::size_t i) {
        return std::get<TriangleMesh>(scene.contents.primitives.at(i).geometry).indices.size() / 3;
    };
    ASSERT_EQ(scene.contents.primitives.size(), 4u);
    EXPECT_EQ(triangles(0), 2 * triangles(1));
    EXPECT_EQ(triangles(3), 3 * triangles(1));
    EXPECT_EQ(scene.contents.primitives[0].to_world[3][0], 0);
    EXPECT_EQ(scene.contents.primitives[1].to_world[3][0], 1);
    // A straight tube: its points lie about half its width from its axis, its ends at the curve's.
    const Read straight = read_pbrt_world(
        "Shape \"curve\" \"point3 P\" [0 0 0 0 0 1 0 0 2 0 0 3] \"float width0\" 2 \"float "
        "width1\" 1\n");
    const auto& mesh = std::get<TriangleMesh>(straight.contents.primitives.at(0).geometry);
    for (const Vec3& p : mesh.positions)
        EXPECT_NEAR(std::hypot(p.x, p.y), 1 - p.z / 6, 0.01);
    EXPECT_NEAR(mesh.positions.back().z, 3, 1e-6);
    // One that turns from x to z does not twist: a corner's next one lies near it.
    const Read bent = read_pbrt_world(
        "Shape \"curve\" \"point3 P\" [-1 -0.5 0 -0.5 1.2 0.5 0.5 -1.2 0.5 1 0.6 0] \"float "
        "width\" 0.4\n");
    const auto& tube = std::get<TriangleMesh>(bent.contents.primitives.at(0).geometry);
    for (std::size_t i = 0; i + 1 < tube.indices.size(); i += 3)
        for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)})
            EXPECT_LT((tube.positions[tube.indices[i + a]] - tube.positions[tube.indices[i + b]])
                          .length(),
                      0.4f)
                << "a side as long as the tube is thick";
    const Read spline = read_pbrt_world(
        "Shape \"curve\" \"string basis\" \"bspline\" \"integer degree\" 2 \"point3 P\" [0 0 0 0 0 "
        "1 0 0 2] "
        "\"float width\" 0.01\n");
    const auto& middle =
        std::get<TriangleMesh>(spline.contents.primitives.at(0).geometry).positions;
    EXPECT_NEAR(middle.front().z, 0.5, 1e-6);
    EXPECT_NEAR(middle.back().z, 1.5, 1e-6);
}

TEST(PbrtDirectives, EveryTextureOfBothTypes) {
    std::string text;
    for (const char* type :
         {"bilerp", "checkerboard", "constant", "dots", "fbm", "mix", "scale", "windy", "wrinkled"})
        for (const char* of : {"float", "spectrum"})
            text += std::string("Texture \"") + type + of + "\" \"" + of + "\" \"" + type + "\"\n";
    text += "Texture \"m\" \"spectrum\" \"marble\"\n";
    for (const char* type : {"checkerboard", "marble", "mix"}) {
        const std::string name =
            std::string(type) == "marble" ? "m" : std::string(type) + "spectrum";
        text += "Material \"diffuse\" \"texture reflectance\" \"" + name + "\" Shape \"sphere\"\n";
    }
    EXPECT_THAT(messages_of(text), IsEmpty());
    EXPECT_THAT(messages_of("Texture \"p\" \"spectrum\" \"ptex\" \"string filename\" \"a.ptx\""),
                ElementsAre(HasSubstr("texture \"ptex\" is not rendered")));
}

TEST(PbrtDirectives, MistakesAreTold) {
    EXPECT_THAT(
        messages_of("Shap \"sphere\""),
        ElementsAre("test.pbrt:2:1: error: unknown directive \"Shap\"; did you mean Shape?"));
    EXPECT_THAT(messages_of("Shape \"sphere\" \"float radios\" 1"),
                ElementsAre(HasSubstr(
                    "test.pbrt:2:16: warning: unknown parameter \"radios\" of shape \"sphere\"")));
    EXPECT_THAT(messages_of("Material \"mate\" Shape \"sphere\""),
                ElementsAre(AllOf(HasSubstr("warning: unknown material \"mate\""),
                                  HasSubstr("; a grey of 0.5 is used"))));
    EXPECT_THAT(messages_of("NamedMaterial \"no\""),
                ElementsAre(HasSubstr("unknown material \"no\"; none is known; it is ignored")));
    EXPECT_THAT(messages_of("Material \"diffuse\" \"float reflectance\" \"a\""),
                ElementsAre(HasSubstr("takes a colour")));
    EXPECT_THAT(messages_of("LightSource \"point\" \"spectrum I\" \"metal-Xx-eta\""),
                ElementsAre(HasSubstr("unknown spectrum")));
    EXPECT_THAT(messages_of("AttributeBegin"),
                ElementsAre("test.pbrt:2:1: error: AttributeBegin is not closed"));
    EXPECT_THAT(messages_of("AttributeEnd"),
                ElementsAre("test.pbrt:2:1: error: AttributeEnd without AttributeBegin"));
    EXPECT_THAT(messages_of("Camera \"perspective\""),
                ElementsAre(HasSubstr("Camera stands before WorldBegin only")));
    EXPECT_THAT(messages_of("ColorSpace \"rgb\""),
                ElementsAre(HasSubstr("unknown colour space \"rgb\"")));
    EXPECT_THAT(messages_of("StartTime"),
                ElementsAre(HasSubstr("StartTime stands behind ActiveTransform only")));
    EXPECT_THAT(read("Shape \"sphere\"").messages,
                ElementsAre(HasSubstr("Shape stands after WorldBegin only"),
                            HasSubstr("the scene ends without WorldBegin"),
                            HasSubstr("the scene ends without WorldBegin")));
    EXPECT_THROW(read("WorldBegin {"), InputError);
}

TEST(PbrtDirectives, WhatHasNoEqualIsSaidOnce) {
    EXPECT_THAT(messages_of("Material \"hair\" Material \"hair\" Shape \"sphere\""),
                testing::SizeIs(1));
    EXPECT_THAT(messages_of("Material \"measured\" \"string filename\" \"a.bsdf\""),
                testing::SizeIs(1));
    EXPECT_THAT(messages_of("Material \"subsurface\" \"float mfp\" 1"), testing::SizeIs(1));
    EXPECT_THAT(
        read("Integrator \"mlt\" \"integer chains\" 5\nWorldBegin").messages,
        ElementsAre(HasSubstr(
            "test.pbrt:1:12: warning: Integrator \"mlt\" is not rendered; \"path\" is used")));
    EXPECT_THAT(read("Film \"spectral\" \"integer nbuckets\" 9\nWorldBegin").messages,
                testing::SizeIs(1));
    EXPECT_THAT(
        read("Camera \"realistic\" \"string lensfile\" \"wide.22mm.dat\"\nWorldBegin").messages,
        ElementsAre(HasSubstr("thin lens of 22 mm")));
}

TEST(PbrtDirectives, OurIntegratorsTakeTheirOwnParameters) {
    const Read scene =
        read("Integrator \"aips\" \"integer maxdepth\" 7 \"string guide\" \"none\"\nWorldBegin");
    const ParameterSet& set = scene.contents.options.at("SurfaceIntegrator").parameters;
    EXPECT_EQ(set.plugin, "aips");
    ASSERT_EQ(set.values.size(), 2u);
    EXPECT_EQ(set.values[1].name, "guide");
    const Read sppm =
        read("Integrator \"sppm\" \"integer iterations\" 9 \"float radius\" 0.5\nWorldBegin");
    EXPECT_EQ(sppm.contents.options.at("SurfaceIntegrator").parameters.plugin, "sppm");
}

}  // namespace
}  // namespace lxs::test::pbrt_directive_test
