// Bumped surfaces: tangents along v against closed forms, and the tilted normal in the hit.
#include <gtest/gtest.h>

#include <cmath>
#include <memory_resource>

#include "fakes.h"

namespace lxs::test::bumped_hit_test {
namespace {

constexpr float kPi = 3.14159265f;

/// Remembers the tangent that it was handed and tilts the normal towards it.
class Leaning final : public Material {
  public:
    void bend(ShadingPoint& point) const override {
        dpdv = point.dpdv;
        point.ns = (point.ns + point.dpdv.normalized() * 0.5f).normalized();
        point.bent = true;
    }
    const Bsdf* scatter(const ShadingPoint& point, std::pmr::memory_resource&) const override {
        EXPECT_TRUE(point.bent);
        return nullptr;
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.bends = true;
        return facts;
    }
    mutable Vec3 dpdv{0.0f};
};

/// Remembers the tangent without bending anything.
class Woven final : public Material {
  public:
    explicit Woven(bool reads) : reads_(reads) {}
    const Bsdf* scatter(const ShadingPoint& point, std::pmr::memory_resource&) const override {
        dpdv = point.dpdv;
        return nullptr;
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.reads_dpdv = reads_;
        return facts;
    }
    mutable Vec3 dpdv{0.0f};

  private:
    bool reads_;
};

/// Traces one ray at `contents` made with the material; checks the normal and returns dpdv.
template <class Make>
Vec3 dpdv_at(const Ray& probe, const Make& make) {
    const auto leaning = std::make_shared<Leaning>();
    const std::unique_ptr<Scene> scene = trace(make(leaning));
    SurfaceHit result;
    EXPECT_TRUE(hit(*scene, probe, result));
    const Vec3 expected = (result.ng + leaning->dpdv.normalized() * 0.5f).normalized();
    EXPECT_LT((result.ns - expected).length(), 1e-5f);
    return leaning->dpdv;
}

void expect_close(const Vec3& a, const Vec3& b) {
    EXPECT_LT((a - b).length(), 2e-3f * b.length()) << a << " and " << b;
}

TEST(BumpedHit, TriangleTangentAlongV) {
    TriangleMesh mesh = triangle({0, 0, 0}, {2, 0, 0}, {1, 3, 0});
    mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
    const Ray down = ray({1, 1, 5}, {0, 0, -1});
    expect_close(dpdv_at(down, [&](const auto& m) { return std::vector{primitive(mesh, m)}; }),
                 {1, 3, 0});
    expect_close(
        dpdv_at(down,
                [&](const auto& m) { return instanced({primitive(mesh, m)}, {scaling(1, 2, 1)}); }),
        {1, 6, 0});
}

TEST(BumpedHit, TangentAlongVIsThereForThoseThatReadIt) {
    TriangleMesh mesh = triangle({0, 0, 0}, {2, 0, 0}, {1, 3, 0});
    mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
    for (const bool reads : {true, false}) {
        const auto woven = std::make_shared<Woven>(reads);
        const std::unique_ptr<Scene> scene = trace({primitive(mesh, woven)});
        SurfaceHit result;
        ASSERT_TRUE(hit(*scene, ray({1, 1, 5}, {0, 0, -1}), result));
        EXPECT_LT((woven->dpdv - (reads ? Vec3(1, 3, 0) : Vec3(0.0f))).length(), 1e-5f);
    }
}

TEST(BumpedHit, QuadricTangentAlongV) {
    // On a sphere it runs from the south pole to the north pole: pi r per unit of v.
    const float root = std::sqrt(0.5f);
    const Ray probe = ray(Vec3(5, 0, 5), Vec3(-root, 0, -root));
    const auto ball = [](const Matrix& matrix) {
        return [=](const auto& m) { return std::vector{primitive(sphere(2, matrix), m)}; };
    };
    const Vec3 found = dpdv_at(probe, ball(Matrix()));
    expect_close(found, Vec3(-root, 0, root) * (2 * kPi));
    const Vec3 twice = dpdv_at(probe, [&](const auto& m) {
        return instanced({primitive(sphere(1, Matrix()), m)}, {scaling(2, 2, 2)});
    });
    expect_close(twice, found);
    // A disk's v runs inwards.
    expect_close(
        dpdv_at(ray({1, 0, 5}, {0, 0, -1}),
                [](const auto& m) { return std::vector{primitive(disk(3, Matrix()), m)}; }),
        {-3, 0, 0});
}

TEST(BumpedHit, NoTangentAlongVWhereItHasNoDirection) {
    const auto woven = std::make_shared<Woven>(true);
    const Quadric bowl{Paraboloid{0.8f, 0, 1, 360}, Matrix()};
    for (const Quadric& quadric : {sphere(2, Matrix()), disk(3, Matrix()), bowl}) {
        const std::unique_ptr<Scene> scene = trace({primitive(quadric, woven)});
        woven->dpdv = Vec3(1.0f);
        SurfaceHit result;
        ASSERT_TRUE(hit(*scene, ray({0, 0, -5}, {0, 0, 1}), result));
        EXPECT_EQ(woven->dpdv, Vec3(0.0f));
    }
}

}  // namespace
}  // namespace lxs::test::bumped_hit_test
