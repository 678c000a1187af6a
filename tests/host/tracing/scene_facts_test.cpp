// What a scene says of itself, and what it refuses.
#include <gtest/gtest.h>

#include "fakes.h"

namespace lxs::test::scene_facts_test {
namespace {

TEST(SceneFacts, MatteOnly) {
    const auto scene = trace({primitive(parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)))});
    const SceneFacts facts = scene->facts();
    EXPECT_TRUE(facts.has_diffuse);
    EXPECT_FALSE(facts.has_glossy);
    EXPECT_FALSE(facts.has_specular);
    EXPECT_FALSE(facts.has_transmission);
    EXPECT_FALSE(facts.has_media);
    EXPECT_FALSE(facts.has_motion);
    EXPECT_FALSE(facts.has_image_textures);
    EXPECT_EQ(facts.triangles, 2u);
    EXPECT_EQ(facts.max_bsdf_bytes, matte()->facts().max_bsdf_bytes);
}

TEST(SceneFacts, SeesIntoObjects) {
    Primitive ball = primitive(sphere(1, Matrix()), straight(Rgb(1.0f)));
    ball.interior = std::make_shared<Medium>(Rgb(0.1f), 1);
    const auto scene = trace(instanced({ball}, {Matrix()}));
    const SceneFacts facts = scene->facts();
    EXPECT_FALSE(facts.has_diffuse);
    EXPECT_TRUE(facts.has_specular);
    EXPECT_TRUE(facts.has_transmission);
    EXPECT_TRUE(facts.has_media);
    EXPECT_EQ(facts.triangles, 0u);
}

TEST(SceneFacts, ClearMediumIsNoMedium) {
    Primitive ball = primitive(sphere(1, Matrix()));
    ball.interior = std::make_shared<Medium>(Rgb(0.0f), 1.5f);
    EXPECT_FALSE(trace({ball})->facts().has_media);
}

/// LuxRender's default VolumeIntegrator only dims light.
TEST(SceneFacts, MediaScatterWhereTheVolumeIntegratorSaysSo) {
    Primitive ball = primitive(sphere(1, Matrix()));
    ball.interior =
        std::make_shared<Medium>(MediumCoefficients{Rgb(0.0f), Rgb(1.0f), Rgb(0.0f)}, IndexCurve{});
    const SceneFacts dimmed = trace({ball})->facts();
    EXPECT_TRUE(dimmed.has_media);
    EXPECT_FALSE(dimmed.has_scattering_media);
    SceneContents contents;
    contents.primitives = {ball};
    contents.options["VolumeIntegrator"].parameters.plugin = "multi";
    EXPECT_TRUE(trace(std::move(contents))->facts().has_scattering_media);
}

TEST(SceneFacts, BoundsCoverInstancesAndLeaveOutUnusedVertices) {
    TriangleMesh mesh = parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    mesh.positions.emplace_back(99, 99, 99);
    const Bounds box =
        trace(instanced({primitive(mesh)}, {Matrix(), translation(5, 0, 2)}))->bounds();
    EXPECT_EQ(box.min, Vec3(0, 0, 0));
    EXPECT_EQ(box.max, Vec3(6, 1, 2));
}

TEST(SceneFacts, NamesArePassedOn) {
    SceneContents contents;
    contents.light_groups = {"default", "sun"};
    contents.material_names = {"wall"};
    const auto scene = trace(std::move(contents));
    EXPECT_EQ(scene->light_groups()[1], "sun");
    EXPECT_EQ(scene->material_names()[0], "wall");
    EXPECT_TRUE(scene->lights().empty());
}

TEST(SceneFacts, FlattenedInstanceIsAnError) {
    Primitive plate = primitive(parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
    try {
        trace(instanced({plate}, {scaling(1, 0, 1)}));
        FAIL() << "a singular instance transform was accepted";
    } catch (const InputError& error) {
        EXPECT_NE(
            std::string(error.what())
                .find("an instance of object \"object\" has a transform that can't be inverted"),
            std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace lxs::test::scene_facts_test
