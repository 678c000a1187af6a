// sample_direct draws with the density that it states and that pdf_direct gives: next-event
// estimation and multiple importance sampling are unbiased only then.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "chi_square.h"
#include "light_cases.h"

namespace lxs::test::direct_density_test {
namespace {

constexpr std::size_t kCosines = 10, kAzimuths = 12;
constexpr int kSamples = 40000;

struct Basis {
    Vec3 x, y, z;
    explicit Basis(const Vec3& axis) : z(axis) {
        x = (std::abs(z.x) < 0.9f ? Vec3(1, 0, 0) : Vec3(0, 1, 0)) % z;
        x.normalize();
        y = z % x;
    }
};

float density(const ExtendedLight& c, const Vec3& wi) {
    const auto hit = c.meet(c.from, wi);
    return hit ? c.light->pdf_direct(c.from, Vec3(0, 0, 1), wi, hit->p, hit->n, 0) : 0.0f;
}

/// Expected share of each cell of the cone around the axis, by stratified integration.
std::vector<double> expected_shares(const ExtendedLight& c, const Basis& basis) {
    constexpr std::size_t kSub = 128;
    std::vector<double> shares(kCosines * kAzimuths + 1, 0.0);
    const double height = 1 - double(c.cos_min);
    const double solid_angle = 2 * std::numbers::pi * height / (kCosines * kAzimuths);
    Random random(7);
    double total = 0;
    for (std::size_t cell = 0; cell < kCosines * kAzimuths; ++cell) {
        const std::size_t row = cell / kCosines, column = cell % kCosines;
        for (std::size_t i = 0; i < kSub * kSub; ++i) {
            const std::size_t y = i / kSub, x = i % kSub;
            const double s = (double(column) + (double(x) + random()) / kSub) / kCosines;
            const double t = (double(row) + (double(y) + random()) / kSub) / kAzimuths;
            const double below_one = height * s;
            const double sine = std::sqrt(below_one * (2 - below_one));
            const double phi = 2 * std::numbers::pi * t;
            const Vec3 wi = basis.x * float(sine * std::cos(phi)) +
                            basis.y * float(sine * std::sin(phi)) + basis.z * float(1 - below_one);
            shares[cell] += density(c, wi.normalized()) * solid_angle / (kSub * kSub);
        }
        total += shares[cell];
    }
    shares.back() = 1 - total;  // of samples outside of the cone, or that find no light
    return shares;
}

std::size_t cell_of(const ExtendedLight& c, const Basis& basis, const Vec3& wi) {
    const double below_one = (wi - basis.z).length2() / 2;
    const auto i = static_cast<std::size_t>(below_one / (1 - double(c.cos_min)) * kCosines);
    const double t = std::atan2(wi ^ basis.y, wi ^ basis.x) / (2 * std::numbers::pi);
    const auto j =
        std::min(kAzimuths - 1, static_cast<std::size_t>((t < 0 ? t + 1 : t) * kAzimuths));
    return i < kCosines ? j * kCosines + i : kCosines * kAzimuths;
}

// Family-wise significance 1 % over all lights (Sidak); fixed seeds.
TEST(DirectDensity, SamplesFollowThePdf) {
    const std::vector<ExtendedLight> cases = extended_lights();
    const double threshold = one_of(cases.size());
    for (const ExtendedLight& c : cases) {
        SCOPED_TRACE(c.name);
        const Basis basis(c.axis);
        std::vector<double> counts(kCosines * kAzimuths + 1, 0.0);
        Random random(11);
        for (int i = 0; i < kSamples; ++i) {
            DirectSample s;
            const Vec2 u(random(), random());
            const bool found = c.light->sample_direct(c.from, Vec3(0, 0, 1), u, s);
            ++counts[found ? cell_of(c, basis, s.wi) : counts.size() - 1];
        }
        EXPECT_GT(chi_square_p(counts, expected_shares(c, basis), kSamples), threshold);
    }
}

// MIS weights compare the two: they must be the same function.
TEST(DirectDensity, StatedPdfEqualsPdfDirect) {
    for (const ExtendedLight& c : extended_lights()) {
        SCOPED_TRACE(c.name);
        Random random(3);
        int compared = 0, differing = 0;
        for (int i = 0; i < 2000; ++i) {
            DirectSample s;
            if (!c.light->sample_direct(c.from, Vec3(0, 0, 1), Vec2(random(), random()), s))
                continue;
            EXPECT_FALSE(s.delta);
            ++compared;
            // At the silhouette of a curved light rounding decides on the other side.
            if (std::abs(density(c, s.wi) / s.pdf - 1) > 0.01f) ++differing;
        }
        EXPECT_GT(compared, 500);
        EXPECT_LE(differing, compared / 100);
    }
}

// A scattered ray that meets the light sees what the shadow ray was promised.
TEST(DirectDensity, SampledRadianceIsWhatIsSeen) {
    for (const ExtendedLight& c : extended_lights()) {
        SCOPED_TRACE(c.name);
        Random random(5);
        for (int i = 0; i < 500; ++i) {
            DirectSample s;
            if (!c.light->sample_direct(c.from, Vec3(0, 0, 1), Vec2(random(), random()), s))
                continue;
            const auto* area = dynamic_cast<const AreaLight*>(c.light.get());
            const auto hit = c.meet(c.from, s.wi);
            if (!hit) continue;  // silhouette
            const Rgb seen =
                area ? area->radiance(hit->p, hit->n, Vec2(0.5f), -s.wi) : c.light->escaped(s.wi);
            if (is_black(seen)) continue;  // silhouette
            EXPECT_NEAR(luminance(seen) / luminance(s.radiance), 1, 2e-3);
            if (area) {
                EXPECT_NEAR((hit->p - c.from).length() / s.distance, 1, 2e-3);
            }
        }
    }
}

}  // namespace
}  // namespace lxs::test::direct_density_test
