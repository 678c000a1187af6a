// Protects the one-sample mixture: whatever the guide says, the mean of the weights is the same.
#include <gtest/gtest.h>

#include "aips/core/chains/primary_path.h"
#include "aips/core/sampling/sampling.h"
#include "mock_bsdf.h"
#include "photons/scatter_photon.h"
#include "render_mock.h"

namespace aips::scatter_photon_test {
namespace {

/// A guide with one fixed, lopsided density: cosine-distributed around a tilted axis.
class TiltedDirections final : public GuidedDirections {
  public:
    TiltedDirections(float share, Vec3 axis) : GuidedDirections(share), axis_(axis) {}
    Vec3 sample(Vec2 u) const override {
        return Frame(axis_).to_world(square_to_cosine_hemisphere(u));
    }
    float pdf(Vec3 d) const override { return std::max(0.0f, dot(d, axis_)) * kInvPi; }

  private:
    Vec3 axis_;
};

class TiltedGuide final : public DirectionGuide {
  public:
    explicit TiltedGuide(float share) : directions_(share, normalize(Vec3{0.8f, 0.1f, 0.4f})) {}
    const GuidedDirections* directions(const GuideVertex&,
                                       std::pmr::memory_resource&) const override {
        return &directions_;
    }

  private:
    TiltedDirections directions_;
};

/// Mean of weight * g(direction) over many scatterings, with its standard error.
struct Estimate {
    double mean = 0, standard_error = 0;
};

Estimate estimate(const mock::Material& material, const DirectionGuide* guide) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const Settings settings;
    const DiscreteDistribution lights;
    const PhotonInput input{scene, settings, lights, guide, nullptr, 0, 0};
    Arena arena;
    SurfacePoint point;
    point.geometric_normal = {0, 0, 1};
    point.shading_normal = normalize(Vec3{0.2f, 0, 1});
    PhotonCounts counts;
    constexpr int kSamples = 400000;
    double sum = 0, squares = 0;
    for (int i = 0; i < kSamples; ++i) {
        arena.reset();
        point.bsdf = mock::make_bsdf(material, point.geometric_normal, point.shading_normal, arena);
        RandomStream random(7, guide ? 1 : 0, std::uint32_t(i), RandomDomain::Photon);
        ScatteredPhoton s;
        double value = 0;
        if (scatter_photon(input, point, normalize(Vec3{-0.5f, 0.2f, 0.9f}), random, arena, counts,
                           s)) {
            value = luminance(s.weight) * (1 + s.direction.x + 0.5 * s.direction.y);
        }
        sum += value;
        squares += value * value;
    }
    const double mean = sum / kSamples;
    return {mean, std::sqrt((squares / kSamples - mean * mean) / kSamples)};
}

TEST(ScatterPhoton, GuideLeavesTheMeanAlone) {
    using Kind = mock::Material::Kind;
    for (const Kind kind :
         {Kind::Lambert, Kind::Phong, Kind::LambertAndMirror, Kind::Mirror, Kind::Sheet}) {
        mock::Material material;
        material.kind = kind;
        material.specular = {0.3f, 0.3f, 0.3f};
        material.transmittance = {0.2f, 0.2f, 0.2f};
        material.glossy = {0.1f, 0.1f, 0.1f};
        material.exponent = 5;
        const Estimate plain = estimate(material, nullptr);
        for (const float share : {0.0f, 0.5f, 0.9f}) {
            const TiltedGuide guide(share);
            const Estimate guided = estimate(material, &guide);
            const double error = std::hypot(plain.standard_error, guided.standard_error);
            // 15 comparisons; 4 standard errors keep the chance of a false alarm below 1e-3.
            EXPECT_LE(std::abs(guided.mean - plain.mean), 4 * error + 1e-6)
                << "material " << int(kind) << " share " << share;
        }
    }
}

/// Numbers drawn beyond a bounce's coordinates would be missing in the sequence of those that
/// follow.
void expect_no_more_than_a_bounce(const mock::Material& material, float tilt,
                                  const DirectionGuide* guide) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const Settings settings;
    const DiscreteDistribution lights;
    const PhotonInput input{scene, settings, lights, guide, nullptr, 0, 0};
    Arena arena;
    PhotonCounts counts;
    SurfacePoint point;
    point.geometric_normal = {0, 0, 1};
    point.shading_normal = normalize(Vec3{tilt, 0, 1});
    for (std::uint32_t i = 0; i < 100; ++i) {
        arena.reset();
        point.bsdf = mock::make_bsdf(material, point.geometric_normal, point.shading_normal, arena);
        RandomStream random(9, 0, i, RandomDomain::UniformPath);
        std::vector<Coordinate> used;
        PrimaryPath path(random, {}, 1, used);
        path.bounce(1).next();  // roulette
        ScatteredPhoton s;
        scatter_photon(input, point, normalize(Vec3{-0.5f, 0.2f, 0.9f}), path, arena, counts, s);
        path.bounce(2).next();
        for (std::size_t k = 0; k < max_coordinates(1); ++k)
            random.next_uint();
        ASSERT_EQ(used.size(), max_coordinates(1) + 1);
        ASSERT_EQ(used.back(), random.next_uint()) << int(material.kind) << " tilted by " << tilt;
    }
}

/// The longest has a choice of the density, one of the lobe, and before them a specular lobe.
TEST(ScatterPhoton, ABounceDrawsNoMoreThanItsCoordinates) {
    using Kind = mock::Material::Kind;
    const TiltedGuide guide(0.5f);
    for (const Kind kind : {Kind::Lambert, Kind::Glass, Kind::LambertAndMirror, Kind::Sheet}) {
        mock::Material material;
        material.kind = kind;
        material.specular = material.transmittance = material.glossy = {0.2f, 0.2f, 0.2f};
        for (const float tilt : {0.0f, 0.05f}) {
            expect_no_more_than_a_bounce(material, tilt, nullptr);
            expect_no_more_than_a_bounce(material, tilt, &guide);
        }
    }
}

/// The defensive share of Bsdf sampling bounds the weight: f cos / p <= f cos / ((1-a) p_bsdf).
TEST(ScatterPhoton, DefensiveShareBoundsTheWeight) {
    const TiltedGuide guide(0.75f);
    const mock::Scene scene = mock::lamp_box({}, {});
    const Settings settings;
    const DiscreteDistribution lights;
    const PhotonInput input{scene, settings, lights, &guide, nullptr, 0, 0};
    Arena arena;
    SurfacePoint point;
    point.geometric_normal = point.shading_normal = {0, 0, 1};
    PhotonCounts counts;
    for (std::uint32_t i = 0; i < 100000; ++i) {
        arena.reset();
        point.bsdf = mock::make_bsdf({}, point.geometric_normal, point.shading_normal, arena);
        RandomStream random(8, 0, i, RandomDomain::Photon);
        ScatteredPhoton s;
        if (scatter_photon(input, point, {0, 0, 1}, random, arena, counts, s)) {
            ASSERT_LE(s.weight.r, 0.5f / 0.25f * 1.0001f);
        }
    }
    EXPECT_NEAR(double(counts.guided_bounces) / double(counts.bounces), 0.75, 0.01);
}

/// What guides learn from: the density told is the one drawn from, so that the mean of the plain
/// density over it is 1, and that of its half over it a half.
TEST(ScatterPhoton, TellsTheDensitiesOfItsDirections) {
    const TiltedGuide guide(0.75f);
    const mock::Scene scene = mock::lamp_box({}, {});
    const Settings settings;
    const DiscreteDistribution lights;
    const PhotonInput input{scene, settings, lights, &guide, nullptr, 0, 0};
    Arena arena;
    SurfacePoint point;
    point.geometric_normal = point.shading_normal = {0, 0, 1};
    point.bsdf = mock::make_bsdf({}, point.geometric_normal, point.shading_normal, arena);
    PhotonCounts counts;
    constexpr int kSamples = 200000;
    double all = 0, half = 0, squares = 0;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        RandomStream random(10, 0, i, RandomDomain::Photon);
        ScatteredPhoton s;
        if (!scatter_photon(input, point, {0, 0, 1}, random, arena, counts, s)) continue;
        ASSERT_FLOAT_EQ(s.plain_pdf, s.direction.z * kInvPi);
        const double ratio = double(s.plain_pdf) / double(s.pdf);
        all += ratio / kSamples;
        half += s.direction.x > 0 ? ratio / kSamples : 0;
        squares += ratio * ratio / kSamples;
    }
    const double error = std::sqrt(squares / kSamples);
    EXPECT_NEAR(all, 1, 4 * error);
    EXPECT_NEAR(half, 0.5, 4 * error);
}

/// Scatters by `material`, whose lobes reflect and let through so much each, where the shading
/// normal is tilted by an eighth of a turn. A share of directions about the geometric normal keeps
/// the mean that the Bsdf's own samples have with Veach's factor, and bounds what those leave
/// without bound: f cos / p <= K / pi |wi.ng| |wo.ns| / |wo.ng| / (|wi.ng| / (2 sides pi)).
void expect_bounded(const mock::Material& material, double reflected, double let_through) {
    const mock::Scene scene = mock::lamp_box({}, {});
    const Settings settings;
    const DiscreteDistribution lights;
    const PhotonInput input{scene, settings, lights, nullptr, nullptr, 0, 0};
    Arena arena;
    SurfacePoint point;
    point.geometric_normal = {0, 0, 1};
    point.shading_normal = normalize(Vec3{1, 0, 1});
    point.bsdf = mock::make_bsdf(material, point.geometric_normal, point.shading_normal, arena);
    const Vec3 wo = normalize(Vec3{0.5f, 0.2f, 0.9f});
    const double ratio =
        double(abs_dot(wo, point.shading_normal)) / double(abs_dot(wo, point.geometric_normal));
    const double sides = let_through > 0 ? 2 : 1;
    const double bound = 2 * sides * std::max(reflected, let_through) * ratio;
    PhotonCounts counts;
    constexpr int kSamples = 400000;
    double sum = 0, squares = 0;
    for (int i = 0; i < kSamples; ++i) {
        RandomStream random(9, 0, std::uint32_t(i), RandomDomain::Photon);
        ScatteredPhoton s;
        double value = 0;
        if (scatter_photon(input, point, wo, random, arena, counts, s)) {
            ASSERT_LE(s.weight.r, 1.0001 * bound);
            value = double(s.weight.r) * (1 + s.direction.x);
        }
        sum += value;
        squares += value * value;
    }
    // The integral of K / pi |wi.ng| |wo.ns| / |wo.ng| (1 + wi.x) over both hemispheres about ng:
    // the mean of the x of a cosine-distributed direction is 0.
    const double mean = sum / kSamples;
    const double error = std::sqrt((squares / kSamples - mean * mean) / kSamples);
    EXPECT_NEAR(mean, (reflected + let_through) * ratio, 4 * error);
}

TEST(ScatterPhoton, TiltedNormalKeepsTheMeanAndBoundsTheWeight) {
    const mock::Material material;
    expect_bounded(material, double(material.reflectance.r), 0);
}

/// A curtain: one photon that it let through along its shading normal's plane had ten million
/// times its power.
TEST(ScatterPhoton, TiltedNormalBoundsWhatIsLetThrough) {
    mock::Material curtain;
    curtain.kind = mock::Material::Kind::Sheet;
    curtain.transmittance = {0.4f, 0.4f, 0.4f};
    expect_bounded(curtain, double(curtain.reflectance.r), double(curtain.transmittance.r));
}

}  // namespace
}  // namespace aips::scatter_photon_test
