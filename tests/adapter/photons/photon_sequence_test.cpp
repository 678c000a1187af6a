// Protects the numbers of photon emissions: one sequence over all passes where nothing is chosen by
// what photons bring, and a new one wherever something is, so that the choice does not move the
// expectation (optional stopping).
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <set>
#include <vector>

#include "render_mock.h"
#include "scene_with_lights.h"
#include "test_form.h"

namespace aips::photon_sequence_test {
namespace {

constexpr std::uint32_t kSize = 32;

using Point = std::array<double, 2>;

/// Notes the first two coordinates of emissions.
class NotedLight final : public mock::LightLike {
  public:
    using mock::LightLike::LightLike;
    bool emit(const PrimaryPoint& u, Emission& emission) const override {
        const std::size_t i = count_.fetch_add(1);
        if (i < noted_.size()) noted_[i] = {u[0], u[1]};
        return LightLike::emit(u, emission);
    }
    void start() { count_ = 0; }
    /// Those since start().
    std::set<Point> points() const {
        return {noted_.begin(), noted_.begin() + std::ptrdiff_t(count_.load())};
    }

  private:
    mutable std::atomic<std::size_t> count_{0};
    mutable std::vector<Point> noted_ = std::vector<Point>(1 << 17);
};

/// Renders `passes` passes of 30000 photon paths and notes the emissions of the last two.
class TwoPasses {
  public:
    TwoPasses(Settings settings, std::uint64_t passes)
        : scene_(mock::lamp_box({}, {})), light_(*scene_.lights()[0]) {
        settings.photons_per_pass = 30'000;
        const mock::SceneWithLights scene(scene_, {&light_});
        const auto camera = mock::camera_along_y({0, -0.9f, 0}, 0.5f, kSize, kSize);
        const mock::Sampler sampler(settings.seed);
        mock::Film film(kSize, kSize);
        mock::Log log;
        Engine engine({scene, camera, sampler, film, log}, settings);
        for (std::uint64_t pass = 0; pass < passes; ++pass) {
            if (pass + 2 == passes) light_.start();
            engine.render_pass(pass);
        }
    }
    std::set<Point> points() const { return light_.points(); }

  private:
    mock::Scene scene_;
    NotedLight light_;
};

/// In how many of 256 x 256 cells of the square.
std::size_t cells(const std::set<Point>& points) {
    std::set<std::uint32_t> found;
    for (const Point& u : points)
        found.insert(std::uint32_t(u[0] * 256) * 256 + std::uint32_t(u[1] * 256));
    return found.size();
}

// The first 2^16 points of a sequence are in as many cells.
TEST(PhotonSequence, IsOneWhereNothingIsChosen) {
    const TwoPasses passes(mock::small_settings(5, 0), 2);
    EXPECT_EQ(cells(passes.points()), 60'000u);
}

// The guide learns from 500 000 paths, and finds that nothing is to be gained where all is seen.
// What follows is one sequence, but not that of a render without a guide.
TEST(PhotonSequence, BeginsAnewWhereAGuideIsDisabled) {
    Settings settings = mock::small_settings(5, 0);
    const std::set<Point> unguided = TwoPasses(settings, 19).points();
    settings.guide = GuideKind::Adaptive;
    EXPECT_LT(cells(TwoPasses(settings, 17).points()), 50'000u) << "guided, in several sequences";
    const std::set<Point> disabled = TwoPasses(settings, 19).points();
    EXPECT_EQ(cells(disabled), 60'000u);
    std::size_t shared = 0;
    for (const Point& u : disabled)
        shared += unguided.count(u);
    EXPECT_EQ(shared, 0u);
}

/// Sends one photon path in 2^15, by its first coordinate, onto the wall that is seen, and the
/// others away from it.
class Slit final : public Light {
  public:
    std::uint32_t group() const override { return 0; }
    float power() const override { return 1; }
    bool at_infinity() const override { return false; }
    bool emit(const PrimaryPoint& u, Emission& emission) const override {
        const bool passes = u[0] < 0x1p-15;
        emission.ray.origin = {0, 0, 0};
        emission.ray.direction =
            passes ? normalize(Vec3{float(u[2]) - 0.5f, 1, float(u[3]) - 0.5f}) : Vec3{0, -1, 0};
        emission.power = kWhite * (passes ? 0x1p15f : 1.0f);
        return true;
    }
    bool sample_direct(const SurfacePoint& /*from*/, Vec2 /*u*/,
                       DirectSample& /*sample*/) const override {
        return false;
    }
    float pdf_direct(const SurfacePoint& /*from*/, Vec3 /*wi*/,
                     const SurfacePoint* /*at*/) const override {
        return 0;
    }
    Rgb escaped(Vec3 /*direction*/) const override { return {}; }
};

/// Sums what photons bring in the passes from number `first` on.
class LateFilm final : public Film {
  public:
    explicit LateFilm(std::uint32_t first) : first_(first) {}
    std::uint32_t width() const override { return kSize; }
    std::uint32_t height() const override { return kSize; }
    void add_pass(const FilmPass& pass) override {
        if (passes_++ < first_) return;
        for (const Rgb& photons : pass.photons)
            sum_ += double(luminance(photons));
    }
    void add_layer_pass(std::string_view /*name*/, std::span<const Vec2> /*positions*/,
                        std::span<const Rgb> /*values*/, double /*weight*/) override {}
    void set_layer(std::string_view /*name*/, std::span<const float> /*values*/) override {}
    double mean() const { return sum_ / (double(passes_ - first_) * kSize * kSize); }

  private:
    std::uint32_t first_, passes_ = 0;
    double sum_ = 0;
};

/// A wall that photons of the slit reach, and before half of it a bright board, whose edge is the
/// noise of the eye.
mock::Scene wall_with_board() {
    mock::Scene scene;
    mock::Surface wall;
    wall.shape = mock::Quad{{-1, 1, -1}, {2, 0, 0}, {0, 0, 2}};
    scene.add(wall);
    mock::Surface board;
    board.shape = mock::Quad{{-1, 0.9f, -0.2f}, {2, 0, 0.7f}, {0, 0, 2}};
    board.emitted = {1, 1, 1};
    scene.add(board);
    scene.finish();
    return scene;
}

/// What photons bring in passes `first` to `end`.
double late_light(const mock::Scene& walls, const Settings& settings, std::uint32_t first,
                  std::uint32_t end) {
    const Slit slit;
    const mock::SceneWithLights scene(walls, {&slit});
    const auto camera = mock::camera_along_y({0, -0.01f, 0}, 0.55f, kSize, kSize);
    const mock::Sampler sampler(settings.seed);
    LateFilm film(first);
    mock::Log log;
    Engine engine({scene, camera, sampler, film, log}, settings);
    for (std::uint32_t pass = 0; pass < end; ++pass)
        engine.render_pass(pass);
    return film.mean();
}

// Four passes of 4096 paths are half of 2^15, of which just one passes the slit. If it was among
// them, photons seem noisy, and the next two passes have seven times as many as otherwise; if not,
// it will be among the next in one sequence, which makes these passes brighter than passes
// are: 1.38, where the standard error is 0.07 (long form: 0.05).
TEST(PhotonSequence, WhatPhotonsDecideDoesNotMoveTheExpectation) {
    const auto seeds = statistics::sized<std::size_t>(500, 1000);
    const mock::Scene scene = wall_with_board();
    std::vector<double> light(seeds);
    tbb::parallel_for(std::size_t{0}, seeds, [&](std::size_t seed) {
        Settings settings = mock::small_settings(seed + 1, 0);
        settings.direct_light_sampling = false;
        settings.max_photon_depth = 1;
        light[seed] = late_light(scene, settings, 4, 6);
    });
    double sum = 0, squares = 0;
    for (const double x : light) {
        sum += x;
        squares += x * x;
    }
    // One path of 2^15 in each pass: an image without noise but for the place that it meets.
    Settings even = mock::small_settings(1, 1u << 15);
    even.direct_light_sampling = false;
    even.max_photon_depth = 1;
    const double expected = late_light(scene, even, 0, 100);
    const double mean = sum / seeds;
    const double error = std::sqrt((squares / seeds - mean * mean) / seeds);
    EXPECT_LT(error, statistics::sized(0.1, 0.07) * expected) << "too noisy to tell";
    EXPECT_LT(std::abs(mean - expected), 3.5 * error) << mean / expected;
}

}  // namespace
}  // namespace aips::photon_sequence_test
