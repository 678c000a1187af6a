// Photons and shadow rays carry the same light: the power that a light's photons bring to a small
// plane equals the irradiance that direct sampling finds there. A photon mapper that mixes both
// strategies is right only then.
#include <gtest/gtest.h>

#include <cmath>

#include "light_cases.h"

namespace lxs::test::photon_agreement_test {
namespace {

/// Mean and its standard error.
struct Estimate {
    double sum = 0, squares = 0;
    long n = 0;
    void add(double x) {
        sum += x;
        squares += x * x;
        ++n;
    }
    double mean() const { return sum / static_cast<double>(n); }
    double error() const {
        const double variance = squares / static_cast<double>(n) - mean() * mean();
        return std::sqrt(std::max(0.0, variance) / static_cast<double>(n));
    }
    /// A difference of 5 % shows in a comparison of two estimates that are not.
    bool too_noisy() const {
        constexpr long kLeast = 20000, kMost = 6000000;
        if (n % kLeast != 0 || n == 0) return true;
        return n < kMost && !(error() < 0.008 * mean());
    }
};

/// Square in the scene: centre, normal, and half the side length.
struct Patch {
    Vec3 center, normal;
    float half = 0.5f;
    Vec3 x() const {
        const Vec3 side = std::abs(normal.x) < 0.9f ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        return (side % normal).normalized();
    }
    Vec3 y() const { return normal % x(); }
};

Estimate flux_of_photons(const Light& light, const Patch& patch) {
    Random random(17);
    Estimate flux;
    while (flux.too_noisy()) {
        EmissionSample s;
        double power = 0;
        if (light.sample_emission({random(), random(), random(), random()}, s)) {
            const float cosine = s.ray.direction ^ patch.normal;
            const float t = ((patch.center - s.ray.origin) ^ patch.normal) / cosine;
            const Vec3 d = s.ray.origin + s.ray.direction * t - patch.center;
            if (cosine < 0 && t > 0 && std::abs(d ^ patch.x()) < patch.half &&
                std::abs(d ^ patch.y()) < patch.half)
                power = luminance(s.power);
        }
        flux.add(power);
    }
    return flux;
}

Estimate flux_of_direct_light(const Light& light, const Patch& patch) {
    Random random(19);
    Estimate flux;
    const double area = 4.0 * patch.half * patch.half;
    while (flux.too_noisy()) {
        const Vec3 p = patch.center + patch.x() * (patch.half * (2 * random() - 1)) +
                       patch.y() * (patch.half * (2 * random() - 1));
        DirectSample s;
        double value = 0;
        if (light.sample_direct(p, patch.normal, Vec2(random(), random()), s))
            value = area * luminance(s.radiance) * std::max(0.0f, s.wi ^ patch.normal) / s.pdf;
        flux.add(value);
    }
    return flux;
}

/// z test at |z| < 4 (p 6e-5 a test, below 0.2 % over all).
void expect_agreement(const Light& light, const Patch& patch) {
    const Estimate direct = flux_of_direct_light(light, patch);
    const Estimate photons = flux_of_photons(light, patch);
    ASSERT_GT(direct.mean(), 0);
    const double error = std::hypot(direct.error(), photons.error());
    EXPECT_LT(error / direct.mean(), 0.0125) << "too noisy to tell";
    EXPECT_LT(std::abs(direct.mean() - photons.mean()) / error, 4)
        << "direct " << direct.mean() << ", photons " << photons.mean();
}

TEST(PhotonAgreement, LightsWithExtent) {
    for (const ExtendedLight& c : extended_lights()) {
        SCOPED_TRACE(c.name);
        if (c.name == "sphere far") continue;  // its photons would need billions
        Patch patch{c.from, c.axis, 0.7f};
        if (c.name == "sphere near") patch = {Vec3(0.1f, 0, 2.3f), Vec3(0, 0, 1), 0.1f};
        if (c.name == "sphere from inside") patch.half = 0.4f;
        if (c.light->at_infinity()) patch.half = 1;
        expect_agreement(*c.light, patch);
    }
}

TEST(PhotonAgreement, LightsAtInfinityFromBelow) {
    for (const char* plugin : {"infinite", "sky"}) {
        SCOPED_TRACE(plugin);
        const auto light = make_one(plugin, {numbers("vector", "sundir", {0.3, 0.2, 0.5})});
        expect_agreement(*light, {Vec3(0.5f, 0.5f, 0), Vec3(0.6f, 0, -0.8f), 1.0f});
    }
}

TEST(PhotonAgreement, PointLikeLights) {
    const auto from = numbers("point", "from", {0.5, 0.2, 2});
    const auto to = numbers("point", "to", {0, 0, 0});
    const Patch patch{Vec3(0, 0, 0), Vec3(0, 0, 1), 0.7f};
    expect_agreement(*make_one("point", {from, numbers("color", "L", {3, 2, 1})}), patch);
    // Half of the patch lies in the falloff.
    const auto image = text("mapname", probe_image());
    expect_agreement(*make_one("goniometric", {from, image}), patch);
    expect_agreement(*make_one("projection", {from, to, image, numbers("float", "fov", {60})}),
                     patch);
    expect_agreement(*make_one("spot", {from, to, numbers("float", "coneangle", {25}),
                                        numbers("float", "conedeltaangle", {20})}),
                     patch);
    expect_agreement(*make_one("distant", {from, to}), {patch.center, patch.normal, 1.0f});
}

// Shape transforms and instances: the photon side and the direct side use different formulas.
TEST(PhotonAgreement, InstancedAndMirroredShapes) {
    const Matrix instance = scaling(-1, 0.6, 0.8) * translation(0.1, 0, 0.2);
    Primitive mesh =
        emissive(parallelogram(Vec3(-1, -1, 2), Vec3(0, 2, 0), Vec3(2, 0, 0.3f)), Rgb(1.0f));
    expect_agreement(*make_area_light(mesh, instance), {Vec3(0.0f), Vec3(0, 0, 1), 0.5f});
    Primitive disk = emissive(placed(Disk{0.1f, 1, 0.2f, 200}, translation(0, 0, 2)), Rgb(1.0f));
    disk.reverse_orientation = true;
    expect_agreement(*make_area_light(disk, instance), {Vec3(0.0f), Vec3(0, 0, 1), 0.5f});
}

}  // namespace
}  // namespace lxs::test::photon_agreement_test
