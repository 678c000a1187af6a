// Where textures stand: four mappings of (u, v), and the spaces of three-dimensional textures.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shading_fixture.h"

namespace lxs::texture_mapping_test {
namespace {

/// Moves by (10, 0, 0) and doubles.
Matrix moved_and_doubled() {
    Matrix matrix;
    matrix.scale(Imath::V3d(2));
    matrix[3][0] = 10;
    return matrix;
}

class TextureMappingTest : public ::testing::Test {
  protected:
    /// What the texture "uv" shows, which is (s, t) itself, at a place in space.
    Vec2 st_at(const Vec3& p, std::vector<ParameterValue> values, const Matrix& to_world = {}) {
        TexturePoint point;
        point.p = p;
        point.uv = {0.125f, 0.25f};
        const Rgb value = scene_.make_color("uv", std::move(values), to_world)->evaluate(point);
        return {value.x, value.y};
    }
    void expect_st(const Vec2& found, const Vec2& expected) {
        EXPECT_NEAR(found.x, expected.x, 1e-6f);
        EXPECT_NEAR(found.y, expected.y, 1e-6f);
    }
    /// Height 0 of the texture "exponential" in its own space lies where this is 0.
    float height(std::vector<ParameterValue> values, const TexturePoint& point,
                 const Matrix& to_world = {}) {
        return -std::log(
            scene_.make_float("exponential", std::move(values), to_world)->evaluate(point));
    }

    ShadingFixture scene_;
};

TEST_F(TextureMappingTest, UvIsScaledThenShifted) {
    expect_st(st_at(Vec3(0.0f), {}), {0.125f, 0.25f});
    expect_st(st_at(Vec3(0.0f), {number("uscale", 2), number("vscale", -1), number("udelta", 0.5),
                                 number("vdelta", 0.375)}),
              {0.75f, 0.125f});
}

TEST_F(TextureMappingTest, SphericalMeasuresAnglesInTheTexturesSpace) {
    const auto at = [&](const Vec3& p) {
        return st_at(p, {text("mapping", "spherical")}, moved_and_doubled());
    };
    expect_st(at({13, 0, 0}), {0, 0.5f});
    expect_st(at({10, 5, 0}), {0.25f, 0.5f});
    expect_st(at({10, -5, 5}), {0.75f, 0.25f});
    expect_st(st_at({0, 1, 0}, {text("mapping", "spherical"), number("uscale", 3)}), {0.75f, 0.5f});
}

TEST_F(TextureMappingTest, CylindricalKeepsTheHeight) {
    expect_st(st_at({10, 5, 0.5f}, {text("mapping", "cylindrical")}, moved_and_doubled()),
              {0.25f, 0.25f});
}

TEST_F(TextureMappingTest, PolarHasTheAngleFromTheAxisFirst) {
    expect_st(st_at({10, -5, 5}, {text("mapping", "polar")}, moved_and_doubled()), {0.25f, 0.75f});
}

TEST_F(TextureMappingTest, TurnsBeginWhereTheyAreToldTo) {
    const auto begun = number("turnstart", 0.5);
    expect_st(st_at({-1, 1e-3f, 0.25f}, {text("mapping", "cylindrical"), begun}),
              {1 - 1e-3f / (2 * std::numbers::pi_v<float>), 0.25f});
    expect_st(st_at({0, 1, 0}, {text("mapping", "spherical"), begun}), {0.75f, 0.5f});
    expect_st(st_at({0, -1, 0}, {text("mapping", "spherical"), begun}), {0.25f, 0.5f});
}

TEST_F(TextureMappingTest, PlanarProjectsWorldPositions) {
    expect_st(st_at({0.5f, 9, 0.25f},
                    {text("mapping", "planar"), vector("v1", {0, 0, 2}), vector("v2", {0.5f, 0, 0}),
                     number("vdelta", 0.5)},
                    moved_and_doubled()),
              {0.5f, 0.75f});
}

TEST_F(TextureMappingTest, MappingsThatCannotBeAreErrors) {
    EXPECT_THROW(st_at(Vec3(0.0f), {text("mapping", "sherical")}), InputError);
    EXPECT_THROW(st_at(Vec3(0.0f), {text("mapping", "spherical")}, Matrix(0.0)), InputError);
    EXPECT_NO_THROW(st_at(Vec3(0.0f), {text("mapping", "uv")}, Matrix(0.0)));
}

TEST_F(TextureMappingTest, SpaceFollowsTheTransformInForce) {
    TexturePoint point;
    point.p = {0, 0, 4};
    EXPECT_NEAR(height({}, point), 4, 1e-5);
    EXPECT_NEAR(height({}, point, moved_and_doubled()), 2, 1e-5);
}

TEST_F(TextureMappingTest, OwnPlacementScalesTurnsThenMoves) {
    TexturePoint point;
    // The texture's z axis, tripled, is turned about x onto -y and moved up by 1.
    const std::vector<ParameterValue> placed{
        vector("scale", {1, 1, 3}), vector("rotate", {90, 0, 0}), vector("translate", {0, 1, 0})};
    point.p = {0, 1, 0};
    EXPECT_NEAR(height(placed, point), 0, 1e-5);
    point.p = {7, -5, 8};
    EXPECT_NEAR(height(placed, point), 2, 1e-5);
    EXPECT_THROW(height({vector("scale", {1, 0, 1})}, point), InputError);
}

TEST_F(TextureMappingTest, CoordinatesChooseWhatIsLookedUp) {
    Matrix to_object, to_shape;
    to_object[3][2] = 1;
    to_shape.scale(Imath::V3d(1, 1, 0.5));
    TexturePoint point;
    point.p = {0, 0, 3};
    point.n = Vec3(0, 1, 1).normalized();
    point.uv = {0.25f, 0.5f};
    point.world_to_object = &to_object;
    point.object_to_shape = &to_shape;
    EXPECT_NEAR(height({text("coordinates", "global")}, point), 3, 1e-5);
    EXPECT_NEAR(height({text("coordinates", "local")}, point), 2, 1e-5);
    EXPECT_NEAR(height({text("coordinates", "globalnormal")}, point), std::sqrt(0.5), 1e-5);
    // Squeezed along z, the normal leans towards it: (0, 1, 2) / sqrt(5).
    EXPECT_NEAR(height({text("coordinates", "localnormal")}, point), 2 / std::sqrt(5.0), 1e-5);
    EXPECT_NEAR(height({text("coordinates", "uv"), vector("updir", {0, 1, 0})}, point), 0.5, 1e-5);
    EXPECT_THROW(height({text("coordinates", "globe")}, point), InputError);
}

}  // namespace
}  // namespace lxs::texture_mapping_test
