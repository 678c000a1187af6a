// Protects: 10,000 passes of every radius policy leave radii that are normal numbers, above the
// floor, and where their formulas say: late passes shrink them too, by little, and extreme photon
// counts or probes do no harm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "image_of_pixels.h"
#include "radii/adaptive_radius.h"
#include "radii/ppm_radius.h"
#include "radii/radius_floor.h"
#include "radii/scheduled_radius.h"
#include "render_mock.h"
#include "stress_case.h"

namespace radii_test {
namespace {

using namespace aips;
using namespace stress;

constexpr int kPasses = 10000;
constexpr std::uint32_t kSize = 4;
constexpr std::size_t kPixels = std::size_t{kSize} * kSize;
constexpr double kFootprint = 0.05;

EyeImage eye_image(double footprint = kFootprint) {
    EyeImage image = mock::image_of_pixels(kSize, kSize, {});
    image.footprint_sum = footprint * double(image.visible_points.size());
    return image;
}

const mock::Scene& scene() {
    static const mock::Scene box = mock::lamp_box({}, {});
    return box;
}

double floor_radius() {
    return RadiusFloor(scene()).least();
}

void expect_usable(const GatherRadii& radii) {
    for (std::size_t i = 0; i < kPixels; ++i) {
        ASSERT_TRUE(std::isnormal(radii.of(i)));
        ASSERT_GE(double(radii.of(i)), floor_radius() * (1 - 1e-6));
        ASSERT_LE(radii.of(i), radii.largest);
    }
    ASSERT_TRUE(std::isnormal(radii.mean));
}

Settings settings_of(Mode mode, double alpha) {
    Settings settings = mock::small_settings(1, 0xFFFFFFFFu);
    settings.mode = mode;
    settings.alpha = alpha;
    settings.start_radius = 2;
    return settings;
}

TEST(StressRadius, OfTheSchedule) {
    float last = 0;
    for (const double footprint : {kFootprint, 1e-12}) {
        for (const double alpha : {1e-3, 0.1, 0.7, 1.0}) {
            for (const Mode mode : {Mode::Progressive, Mode::PhotonMap}) {
                ScheduledRadius policy(settings_of(mode, alpha), scene());
                PassPhotons photons{0, 0xFFFFFFFFu};
                last = 1e30f;
                for (int pass = 0; pass < kPasses; ++pass, photons.before += photons.paths) {
                    const GatherRadii radii = policy.before_pass(photons, eye_image(footprint));
                    ASSERT_NO_FATAL_FAILURE(expect_usable(radii));
                    ASSERT_LE(radii.largest, last);
                    last = radii.largest;
                    policy.after_pass({});
                }
            }
        }
    }
    record("schedule: 10,000 passes of 2^32 - 1 photon paths, alpha 0.001 to 1",
           "all radii normal, above " + std::to_string(floor_radius()));
}

/// As many photons in each pass; the formula of Hachisuka et al. in long double beside it.
TEST(StressRadius, OfPpmFollowsItsFormula) {
    PpmRadius policy(settings_of(Mode::Ppm, 0.7), scene());
    const EyeImage image = eye_image();
    const std::uint32_t late[] = {1, 3, 10, 1000};
    std::vector<long double> kept(4, 0), squares(4, 0);
    double error = 0;
    for (int pass = 0; pass < kPasses; ++pass) {
        const GatherRadii radii = policy.before_pass({}, image);
        ASSERT_NO_FATAL_FAILURE(expect_usable(radii));
        PhotonFlux flux;
        flux.reset(kPixels, 1);
        for (std::size_t i = 0; i < 4; ++i) {
            if (pass == 0) squares[i] = double(radii.of(i)) * double(radii.of(i));
            error =
                std::max(error, std::abs(double(radii.of(i)) / double(std::sqrt(squares[i])) - 1));
            // One rich pass, then few photons: each shrinks the radius by less than a float tells.
            const std::uint32_t more = pass == 0 ? 100'000'000 : late[i];
            flux.accepted[i] = more;
            const long double all = kept[i] + more;
            kept[i] += 0.7L * more;
            squares[i] *= kept[i] / all;
        }
        policy.after_pass(flux);
    }
    const double shrunk =
        1 - std::sqrt(double(squares[3] / (4 * 4 * kFootprint * kFootprint * 0.7)));
    EXPECT_GT(shrunk, 0.01);
    EXPECT_LE(error, 2 * 0x1p-24);
    std::ostringstream figure;
    figure << "off by " << error << " of at most " << 2 * 0x1p-24 << "; the last shrink by "
           << shrunk;
    record("ppm: 1e8 photons, then 1 to 1000 a pass for 10,000 passes", figure.str());
}

TEST(StressRadius, OfPpmKeepsItsFloor) {
    PpmRadius policy(settings_of(Mode::Ppm, 1e-3), scene());
    const EyeImage image = eye_image();
    double photons = 1;
    for (int pass = 0; pass < kPasses; ++pass) {
        ASSERT_NO_FATAL_FAILURE(expect_usable(policy.before_pass({}, image)));
        PhotonFlux flux;
        flux.reset(kPixels, 1);
        flux.accepted.assign(kPixels, std::uint32_t(photons));
        // As fast as can be: each pass brings far more than all before.
        photons = std::min(photons * 100, 4e9);
        policy.after_pass(flux);
    }
    const float last = policy.before_pass({}, image).largest;
    EXPECT_NEAR(double(last) / floor_radius(), 1, 1e-6);
    std::ostringstream figure;
    figure << "last radius " << last << ", the floor";
    record("ppm: alpha 0.001, photons times 100 in each pass", figure.str());
}

TEST(StressRadius, OfProbesStaysWithinBounds) {
    Settings settings = settings_of(Mode::Progressive, 0.7);
    settings.radius = RadiusKind::Adaptive;
    const EyeImage image = eye_image();
    const double odd[] = {0, 5e-324, 1e-300, 1, 1e30, 1e150, 1e300};
    for (int kind = 0; kind < 49; ++kind) {
        AdaptiveRadius policy(settings, scene(), kSize, kSize);
        PassPhotons photons{0, 1000000};
        const int passes = kind == 0 ? kPasses : sized(64, kPasses);
        for (int pass = 0; pass < passes; ++pass, photons.before += photons.paths) {
            const GatherRadii radii = policy.before_pass(photons, image);
            ASSERT_NO_FATAL_FAILURE(expect_usable(radii));
            const double schedule = double(
                scheduled_radius(settings, 4 * kFootprint, double(photons.before), floor_radius()));
            for (std::size_t i = 0; i < kPixels; ++i) {
                ASSERT_GE(double(radii.of(i)), 0.125 * schedule * (1 - 1e-6));
                ASSERT_LE(double(radii.of(i)), 2 * schedule * (1 + 1e-6));
            }
            ProbeSums sums;
            sums.squares = odd[kind / 7];
            sums.curvature.fill(kind % 2 ? -odd[kind % 7] : odd[kind % 7]);
            sums.uncertainty.fill(odd[kind % 7]);
            PhotonFlux flux;
            flux.wants_inner = true;
            flux.reset(kPixels, 1);
            flux.probes.assign(radii.probes.size(), sums);
            policy.after_pass(flux);
        }
    }
    record("adaptive: 49 pairs of probe sums of 0, denormal, 1e-300 to 1e300",
           "between an eighth and twice the schedule");
}

/// What the inner half of discs tells of blur, and the whole; both ways and by turns.
TEST(StressRadius, OfBlurStaysWithinBounds) {
    Settings settings = settings_of(Mode::Progressive, 0.7);
    settings.radius = RadiusKind::Adaptive;
    const EyeImage image = eye_image();
    const float odd[] = {0, 1e-45f, 1e-30f, 1, 1e30f, 3e38f};
    for (int kind = 0; kind < 36; ++kind) {
        AdaptiveRadius policy(settings, scene(), kSize, kSize);
        PassPhotons photons{0, 1000000};
        const int passes = sized(128, kPasses);
        for (int pass = 0; pass < passes; ++pass, photons.before += photons.paths) {
            const GatherRadii radii = policy.before_pass(photons, image);
            ASSERT_NO_FATAL_FAILURE(expect_usable(radii));
            const double schedule = double(
                scheduled_radius(settings, 4 * kFootprint, double(photons.before), floor_radius()));
            for (std::size_t i = 0; i < kPixels; ++i) {
                ASSERT_GE(double(radii.of(i)), kLeastNarrowing * schedule * (1 - 1e-6));
                ASSERT_LE(double(radii.of(i)), schedule * (1 + 1e-6));
            }
            PhotonFlux flux;
            flux.wants_inner = true;
            flux.reset(kPixels, 1, radii.probes.size());
            // Even pixels see the same in each pass, the others by turns.
            for (std::size_t i = 0; i < kPixels; ++i) {
                const bool turned = i % 2 && pass % 2;
                flux.flux[i] = kWhite * odd[turned ? kind % 6 : kind / 6];
                flux.inner[i] = kWhite * odd[turned ? kind / 6 : kind % 6];
                flux.squares[i] = odd[(i + std::size_t(pass)) % 6];
            }
            policy.after_pass(flux);
        }
    }
    record(
        "adaptive: 36 pairs of what discs and their inner halves bring, and its squares, 0 to 3e38",
        "between " + std::to_string(kLeastNarrowing) + " of the schedule and the schedule");
}

}  // namespace
}  // namespace radii_test
