// What vertices carry for textures reaches the material, interpolated.
#include <gtest/gtest.h>

#include "fakes.h"

namespace lxs::test::vertex_values_test {
namespace {

/// Lets through what the texture point says: colour times opacity.
class ShowsVertexValues final : public Material {
  public:
    const Bsdf* scatter(const ShadingPoint&, std::pmr::memory_resource&) const override {
        return nullptr;
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.transmits = facts.straight = true;
        return facts;
    }
    Rgb straight_transmittance(const ShadingPoint& point, const Vec3&) const override {
        return point.texture.color * point.texture.alpha;
    }
};

Rgb seen(const TriangleMesh& mesh) {
    const auto scene = trace({primitive(mesh, std::make_shared<ShowsVertexValues>())});
    return scene->transmittance(ray(Vec3(0.5f, 0.25f, 1), Vec3(0, 0, -1)));
}

TEST(VertexValues, AreInterpolated) {
    TriangleMesh mesh = triangle(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    EXPECT_EQ(seen(mesh), Rgb(1.0f)) << "white and opaque where a mesh says nothing";
    mesh.colors = {Rgb(0, 0, 1), Rgb(1, 0, 0), Rgb(0, 1, 0)};
    const Rgb color = seen(mesh);
    EXPECT_NEAR(color.x, 0.5f, 1e-6f);
    EXPECT_NEAR(color.y, 0.25f, 1e-6f);
    EXPECT_NEAR(color.z, 0.25f, 1e-6f);
    mesh.alphas = {0, 1, 0};
    EXPECT_NEAR(seen(mesh).x, 0.25f, 1e-6f);
}

}  // namespace
}  // namespace lxs::test::vertex_values_test
