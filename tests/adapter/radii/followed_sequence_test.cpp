// Protects: radii and edges that follow earlier photons do no harm to the mean though unguided
// emissions go on in one Sobol' sequence. Its points keep away from those before them, on which
// the radii depend. In a furnace the right value is known, and any radius gives it.
//
// Planted: emissions from a few places that come again in every pass. They are uniform over seeds,
// but where a pass finds many photons the next one does too.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "aips/core/sampling/random.h"
#include "render_mock.h"
#include "scene_with_lights.h"

namespace aips::followed_sequence_test {
namespace {

constexpr std::uint32_t kSize = 8, kPasses = 24;
constexpr unsigned kSeeds = 600;
/// Places that no two photons share: independent emissions.
constexpr double kSoMany = 1 << 24;
/// Two-sided, at 0.1 %.
constexpr double kMostDeviations = 3.29;

/// Emission 1, albedo 0.5, nothing absorbed of what goes on.
mock::Scene furnace() {
    mock::Scene scene;
    mock::Surface surface;
    surface.emitted = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, surface);
    scene.finish();
    return scene;
}

/// Emits from `places` places alone, which each seed draws anew.
class FewPlaces final : public mock::LightLike {
  public:
    FewPlaces(const Light& light, std::uint64_t seed, std::uint32_t number, double places)
        : LightLike(light), seed_(seed), number_(number), places_(places) {}
    bool emit(const PrimaryPoint& u, Emission& emission) const override {
        RandomStream random(seed_, number_, std::uint64_t(u[0] * places_), RandomDomain::Photon);
        PrimaryPoint place;
        for (double& coordinate : place)
            coordinate = double(random.next());
        return LightLike::emit(place, emission);
    }

  private:
    std::uint64_t seed_;
    std::uint32_t number_;
    double places_;
};

struct Sample {
    double mean = 0, error = 0;
    double deviations(double right) const { return (mean - right) / error; }
};

/// Over seeds: renders in a view as wide as `half`, the far wall being 2.
Sample sample(float half, double places, unsigned seeds) {
    const mock::Scene scene = furnace();
    const auto camera = mock::camera_along_y({0, -0.5f, 0}, half, kSize, kSize);
    double sum = 0, squares = 0;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        std::vector<std::unique_ptr<const Light>> few;
        std::vector<const Light*> lights(scene.lights().begin(), scene.lights().end());
        for (std::size_t i = 0; places > 0 && i < lights.size(); ++i) {
            few.push_back(std::make_unique<FewPlaces>(*lights[i], seed, std::uint32_t(i), places));
            lights[i] = few.back().get();
        }
        Settings settings = mock::small_settings(seed, 500);
        settings.alpha = 0.7;
        settings.radius = RadiusKind::Adaptive;
        settings.direct_light_sampling = false;
        settings.continue_eye_paths = false;
        settings.max_photon_depth = 8;
        const double mean = mock::render(mock::SceneWithLights(scene, lights), camera, kSize, kSize,
                                         settings, kPasses)
                                .film.mean();
        sum += mean;
        squares += mean * mean;
    }
    const double mean = sum / seeds;
    return {mean, std::sqrt((squares / seeds - mean * mean) / (seeds - 1))};
}

/// Up to eight scatterings.
constexpr double kRight = 2 - 1.0 / 256;

TEST(FollowedSequence, AdaptiveRadiiKeepTheMean) {
    const Sample going_on = sample(0.12f, 0, kSeeds);
    EXPECT_LT(std::abs(going_on.deviations(kRight)), kMostDeviations)
        << going_on.mean << " +- " << going_on.error;
    EXPECT_LT(going_on.error, 0.0025 * kRight);
    const Sample planted = sample(0.12f, 20, kSeeds);
    EXPECT_GT(std::abs(planted.deviations(kRight)), kMostDeviations)
        << planted.mean << " +- " << planted.error;
}

/// The view's rim is the wall's: discs are cut there, and corners are darker than they should be,
/// with independent emissions as much.
TEST(FollowedSequence, EdgesKeepTheMean) {
    const Sample going_on = sample(0.6667f, 0, kSeeds);
    const Sample independent = sample(0.6667f, kSoMany, kSeeds);
    const double error = std::hypot(going_on.error, independent.error);
    EXPECT_LT(std::abs(going_on.mean - independent.mean), kMostDeviations * error)
        << going_on.mean << " +- " << going_on.error << ", independent " << independent.mean
        << " +- " << independent.error;
    EXPECT_LT(error, 0.004 * kRight);
}

}  // namespace
}  // namespace aips::followed_sequence_test
