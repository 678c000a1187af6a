// Protects what the lens does beyond a round aperture and a given distance: blades and autofocus.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "aperture.h"
#include "lxs/imaging/imaging.h"
#include "scene_options.h"

namespace lxs::test::focus_test {
namespace {

TEST(Aperture, APolygonIsFilledUniformly) {
    constexpr int kBlades = 5, kSide = 200;
    // Uniform points of a regular polygon: each of its triangles gets its share, the mean squared
    // distance from the centre is that of the figure, none lies beyond a side.
    std::array<int, kBlades> counts{};
    double squares = 0;
    const double apothem = std::cos(std::numbers::pi / kBlades);
    for (int i = 0; i < kSide * kSide; ++i) {
        const int column = i % kSide, row = i / kSide;
        const Vec2 u((float(column) + 0.5f) / kSide, (float(row) + 0.5f) / kSide);
        const Imath::V2d p = aperture_point(u, kBlades);
        double angle = std::atan2(p.y, p.x) / (2 * std::numbers::pi) * kBlades;
        if (angle < 0) angle += kBlades;
        const int side = std::min(int(angle), kBlades - 1);
        ++counts[std::size_t(side)];
        const double normal = 2 * std::numbers::pi * (side + 0.5) / kBlades;
        ASSERT_LE(p.x * std::cos(normal) + p.y * std::sin(normal), apothem + 1e-9);
        squares += p.length2();
    }
    for (const int count : counts)
        EXPECT_NEAR(count, kSide * kSide / double(kBlades), kSide);
    // Mean over a triangle with corners 0, a, b of |p|^2: (|a|^2 + |b|^2 + a b) / 6.
    const double expected = (2 + std::cos(2 * std::numbers::pi / kBlades)) / 6;
    EXPECT_NEAR(squares / (kSide * kSide), expected, 0.002);
}

TEST(Aperture, FewerThanThreeBladesAreRound) {
    const Vec2 u(0.9f, 0.3f);
    EXPECT_EQ(aperture_point(u, 2), aperture_point(u, 0));
    EXPECT_NE(aperture_point(u, 3), aperture_point(u, 0));
}

/// A plane y = `at` that only x in the given range belongs to.
class Wall final : public Scene {
  public:
    Wall(float at, float x0, float x1) : at_(at), x0_(x0), x1_(x1) {}
    bool intersect(const Ray& ray, SurfaceHit& hit, std::pmr::memory_resource&) const override {
        const float t = (at_ - ray.origin.y) / ray.direction.y;
        hit.p = ray.origin + ray.direction * t;
        hit.distance = t;
        return t > 0 && hit.p.x >= x0_ && hit.p.x <= x1_;
    }
    Rgb transmittance(const Ray&) const override { return Rgb(1.0f); }
    const Medium* medium(const EnteredMedia&) const override { return nullptr; }
    std::span<const Light* const> lights() const override { return {}; }
    std::span<const std::string> light_groups() const override { return {}; }
    std::span<const std::string> material_names() const override { return {}; }
    Bounds bounds() const override { return {}; }
    SceneFacts facts() const override { return {}; }

  private:
    float at_, x0_, x1_;
};

/// A camera at the origin that looks along +y.
std::unique_ptr<SceneCamera> camera(std::vector<ParameterValue> values,
                                    const std::vector<double>& crop = {0, 1, 0, 1}) {
    SceneContents contents = scene_of_size(200, 100);
    contents.options["Film"].parameters.values.push_back(numbers("float", "cropwindow", crop));
    values.push_back(real("lensradius", 0.2));
    values.push_back(real("focaldistance", 7));
    set_option(contents, "Camera", "perspective", std::move(values)).transform =
        Matrix(1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1);
    RecordedDiagnostics diagnostics;
    const auto film = make_film(contents, diagnostics);
    return make_camera(contents, *film, diagnostics);
}

TEST(Autofocus, IsSharpWhereTheMiddleMeetsTheScene) {
    // The crop window looks at the left; the middle of the whole image counts.
    const auto focused = camera({flag("autofocus", true)}, {0, 0.25, 0, 1});
    focused->focus(Wall(3, -0.1f, 0.1f));
    EXPECT_NEAR(focused->focal_distance(), 3, 1e-5);
    // All rays of a film position now meet at depth 3.
    const auto at_depth = [&](const Vec2& lens) {
        const Ray ray = focused->generate({Vec2(10, 20), lens}, 0).ray;
        return ray.origin + ray.direction * ((3 - ray.origin.y) / ray.direction.y);
    };
    EXPECT_LT((at_depth(Vec2(0.1f, 0.2f)) - at_depth(Vec2(0.9f, 0.7f))).length(), 1e-5f);
}

TEST(Autofocus, NothingMetLeavesTheGivenDistance) {
    const auto missed = camera({flag("autofocus", true)});
    missed->focus(Wall(3, 5, 6));
    EXPECT_EQ(missed->focal_distance(), 7);
    const auto fixed = camera({});
    fixed->focus(Wall(3, -1, 1));
    EXPECT_EQ(fixed->focal_distance(), 7) << "not asked for";
}

}  // namespace
}  // namespace lxs::test::focus_test
