// Protects what hits may leave out: that what is asked for is the same to the bit without the rest.
#include <gtest/gtest.h>

#include "fakes.h"

namespace lxs::test::partial_hit_test {
namespace {

/// Tells the Bsdf's maker what it was given.
class Watching final : public Material {
  public:
    Watching(LobeMask lobes, bool reads_uv) : lobes_(lobes), reads_uv_(reads_uv) {}
    const Bsdf* scatter(const ShadingPoint&, std::pmr::memory_resource&) const override {
        ++asked;
        return nullptr;
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.lobes = lobes_;
        facts.reads_uv = reads_uv_;
        return facts;
    }
    mutable int asked = 0;

  private:
    LobeMask lobes_;
    bool reads_uv_;
};

Matrix askew() {
    return rotation({1, 2, 3}, 0.7) * scaling(1, 2, 0.5) * translation(0.1, 0.2, 0.3);
}

TriangleMesh mesh_with_uvs() {
    TriangleMesh mesh = triangle(Vec3(-3, -3, 0.2f), Vec3(3, -3, 0), Vec3(0, 4, -0.2f));
    mesh.uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
    return mesh;
}

/// From all around, towards the middle.
std::vector<Ray> rays() {
    std::vector<Ray> all;
    for (int i = -4; i <= 4; ++i) {
        const auto x = static_cast<float>(i) * 0.1f;
        all.push_back(ray(Vec3(x, 0.3f * x, 5), Vec3(-x, 0.1f, -5).normalized()));
    }
    return all;
}

void expect_same_place(const SurfaceHit& a, const SurfaceHit& b) {
    EXPECT_EQ(a.p, b.p);
    EXPECT_EQ(a.p_error, b.p_error);
    EXPECT_EQ(a.ng, b.ng);
    EXPECT_EQ(a.ns, b.ns);
    EXPECT_EQ(a.distance, b.distance);
}

TEST(PartialHit, PlacesAreTheSameWithoutTextureCoordinates) {
    for (const Geometry& geometry :
         {Geometry(mesh_with_uvs()), Geometry(sphere(1, askew())), Geometry(disk(2, askew()))}) {
        const auto scene_with = [&](bool reads_uv) {
            return trace(instanced(
                {primitive(geometry, std::make_shared<Watching>(kDiffuse, reads_uv))}, {askew()}));
        };
        const auto whole = scene_with(true), part = scene_with(false);
        int met = 0;
        for (const Ray& r : rays()) {
            SurfaceHit a, b;
            if (!hit(*whole, r, a)) continue;
            ++met;
            ASSERT_TRUE(hit(*part, r, b));
            expect_same_place(a, b);
            EXPECT_NE(a.dpdu, Vec3(0.0f));
        }
        EXPECT_GT(met, 3);
    }
}

TEST(PartialHit, EmissionHasItsTextureCoordinates) {
    Primitive lamp = primitive(sphere(1, askew()), std::make_shared<Watching>(kDiffuse, false));
    const auto probe = ray(Vec3(0, 0, 9), Vec3(0, 0, -1));
    SurfaceHit dark, lit;
    ASSERT_TRUE(hit(*trace({lamp}), probe, dark));
    lamp.emission = emission(Rgb(1.0f));
    ASSERT_TRUE(hit(*trace({lamp}), probe, lit));
    expect_same_place(dark, lit);
    EXPECT_NE(lit.uv, dark.uv);
}

/// Meets the scene as paths do that look for lamps.
bool hit_smooth(const Scene& scene, const Ray& ray, SurfaceHit& result) {
    std::pmr::monotonic_buffer_resource memory;
    return scene.intersect_specular(ray, result, memory);
}

TEST(PartialHit, SearchesForLampsLeaveOutWhatIsNeitherSmoothNorLamp) {
    const auto probe = ray(Vec3(0, 0, 9), Vec3(0, 0, -1));
    for (const LobeMask lobes : {kDiffuse, kGlossy, kSpecular, LobeMask(kDiffuse | kSpecular)}) {
        for (const bool emits : {false, true}) {
            const auto material = std::make_shared<Watching>(lobes, true);
            Primitive ball = primitive(sphere(1, askew()), material);
            if (emits) ball.emission = emission(Rgb(1.0f));
            const auto scene = trace({ball});
            SurfaceHit whole, part;
            ASSERT_TRUE(hit(*scene, probe, whole));
            ASSERT_TRUE(hit_smooth(*scene, probe, part));
            EXPECT_EQ(part.distance, whole.distance);
            EXPECT_EQ(part.light, whole.light);
            const bool asked = emits || (lobes & kSpecular);
            EXPECT_EQ(material->asked, asked ? 2 : 1);
            if (asked) expect_same_place(whole, part);
        }
    }
    SurfaceHit none;
    EXPECT_FALSE(hit_smooth(*trace({primitive(sphere(1, Matrix()))}),
                            ray(Vec3(0, 9, 9), Vec3(0, 1, 0)), none));
}

}  // namespace
}  // namespace lxs::test::partial_hit_test
