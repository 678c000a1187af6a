// The engine's half of the shim for LuxRender, without LuxRender.
#include <gtest/gtest.h>

#include <cmath>

#include "aips/core/sampling/random.h"
#include "emission_numbers.h"
#include "engine_run.h"
#include "film_shim.h"
#include "pass_wavelengths.h"
#include "scene_shim.h"
#include "sphere_view.h"

namespace aips::luxrender {
namespace {

// Protects the mean over passes: the sum over wavelengths of a spectrum over their densities is its
// integral, and after 64 passes, a whole net of offsets, within half a percent for any seed.
class LuxRenderShimSeeds : public testing::TestWithParam<std::uint64_t> {};
TEST_P(LuxRenderShimSeeds, WavelengthsIntegrateSpectra) {
    const SphereView view;
    const PassWavelengths wavelengths(view, GetParam());
    constexpr unsigned kPasses = 64;
    double flat = 0, sloped = 0;
    for (unsigned pass = 0; pass < kPasses; ++pass) {
        const auto drawn = wavelengths.of_pass(pass);
        EXPECT_GT(drawn.nanometres.v[0], drawn.nanometres.v[1]);
        EXPECT_GT(drawn.nanometres.v[1], drawn.nanometres.v[2]);
        for (unsigned k = 0; k < 3; ++k) {
            const double value =
                view.sensitivity(drawn.nanometres.v[k]) * drawn.per_density.v[k] / kPasses;
            flat += value;
            sloped += value * drawn.nanometres.v[k];
        }
    }
    const double area = std::sqrt(5000 * M_PI);  // the tails beyond 380 and 720 nm are 1e-3 of it
    EXPECT_NEAR(flat / area, 1, 5e-3);
    EXPECT_NEAR(sloped / area / 550, 1, 5e-3);
}
INSTANTIATE_TEST_SUITE_P(Seeds, LuxRenderShimSeeds,
                         testing::Values(0, 1, 7, std::uint64_t{1} << 40));

// Protects means over seeds: renders of other seeds have other tints, also where seeds differ in
// high bits alone.
TEST(LuxRenderShim, WavelengthsGoBySeed) {
    const SphereView view;
    const auto first = [&](std::uint64_t seed) {
        return PassWavelengths(view, seed).of_pass(0).nanometres.v[1];
    };
    EXPECT_EQ(first(1), first(1));
    EXPECT_NE(first(1), first(2));
    EXPECT_NE(first(1), first((std::uint64_t{1} << 40) + 1));
}

/// With a second light of which no photon tells anything, as lamps of one line may be, and at
/// choice a first one that is as dark.
class DarkView final : public SphereView {
  public:
    explicit DarkView(bool all) : all_(all) {}
    unsigned light_count() const override { return 2; }
    bool emit(unsigned light, const float place[3], const float direction[3],
              ViewEmission& emission) const override {
        return light == 0 && !all_ && SphereView::emit(light, place, direction, emission);
    }

  private:
    bool all_;
};

// Protects light: the engine leaves out lights of power 0, which a few photons may seem to have.
TEST(LuxRenderShim, NoLightIsLeftOutByChance) {
    DarkView one(false), both(true);
    const SceneShim lit(one, PassWavelengths(one, 1)), dark(both, PassWavelengths(both, 1));
    const float bright = lit.lights()[0]->power();
    EXPECT_NEAR(lit.lights()[1]->power(), 0.5e-3f * bright, 1e-6f * bright);
    EXPECT_EQ(dark.lights()[0]->power(), 1);
    EXPECT_EQ(dark.lights()[1]->power(), 1);
}

// Protects emission: nine or so numbers out of four must be uniform and unrelated, and the choice
// must be the coordinate's first digits.
TEST(LuxRenderShim, EmissionNumbersAreUniform) {
    constexpr unsigned kBits = 3, kPaths = 40'000;
    std::array<double, 6> sum{};
    std::array<double, 6> with_choice{};
    for (unsigned i = 0; i < kPaths; ++i) {
        RandomStream random(1, 0, i, RandomDomain::Photon);
        std::array<std::uint32_t, 4> bits;
        for (auto& b : bits)
            b = random.next_uint();
        const PrimaryPoint u = primary_point(bits);
        const EmissionNumbers n = emission_numbers(u, kBits);
        EXPECT_EQ(unsigned(n.place[2] * 8), unsigned(u[0] * 8));
        const std::array<float, 6> all{n.place[0],     n.place[1],     n.place[2],
                                       n.direction[0], n.direction[1], n.direction[2]};
        for (unsigned k = 0; k < 6; ++k) {
            ASSERT_GE(all[k], 0);
            ASSERT_LT(all[k], 1);
            sum[k] += all[k];
            with_choice[k] += (all[k] - 0.5) * (n.place[2] - 0.5);
        }
    }
    // Five standard deviations: 5 sqrt(1/12 / n), and 5 / 12 / sqrt(n).
    for (unsigned k = 0; k < 6; ++k) {
        EXPECT_NEAR(sum[k] / kPaths, 0.5, 5 * std::sqrt(1.0 / 12 / kPaths)) << k;
        if (k != 2) {
            EXPECT_NEAR(with_choice[k] / kPaths, 0, 5.0 / 12 / std::sqrt(kPaths)) << k;
        }
    }
}

// Protects radii: footprints are half a pixel wide at distance 1, seen from the front.
TEST(LuxRenderShim, FootprintsAreHalfAPixel) {
    const SphereView view;
    const CameraShim camera(view);
    const CameraRay ray = camera.generate({{4, 4}, {0.5f, 0.5f}}, 0);
    EXPECT_NEAR(ray.spread, 0.5f * SphereView::pixel_size(), 0.02f * SphereView::pixel_size());
    EXPECT_EQ(ray.width, 0);
}

// Protects the film's means: eye paths count alike, photons by their pass's weight, splats once,
// and the passes are counted.
TEST(LuxRenderShim, FilmKeepsThreeMeans) {
    SphereView view;
    FilmShim film(view);
    const std::array<Vec2, 2> at{{{1, 1}, {2, 2}}};
    const std::array<Rgb, 2> eye{{{1, 1, 1}, {3, 3, 3}}}, photons{{{2, 0, 0}, {4, 0, 0}}};
    const std::array<Rgb, 2> splats{{{1, 0, 0}, {1, 0, 0}}};
    FilmPass pass{
        .positions = at, .groups = 1, .eye = eye, .photons = photons, .photon_weight = 0.25};
    pass.splats = FilmSplats{at, splats};
    film.add_pass(pass);
    EXPECT_EQ(view.film_passes, 1u);
    EXPECT_DOUBLE_EQ(view.parts[FilmPart::Eye].radiance[0], 4);
    EXPECT_DOUBLE_EQ(view.parts[FilmPart::Eye].weight, 2);
    EXPECT_DOUBLE_EQ(view.parts[FilmPart::Photons].radiance[0], 1.5);
    EXPECT_DOUBLE_EQ(view.parts[FilmPart::Photons].weight, 0.5);
    EXPECT_DOUBLE_EQ(view.parts[FilmPart::Splats].radiance[0], 2);
}

/// What the film's three buffers add up to.
std::array<double, 3> image_of(SphereView& view) {
    std::array<double, 3> image{};
    for (unsigned i = 0; i < 3; ++i) {
        for (const FilmPart part : {FilmPart::Eye, FilmPart::Photons})
            if (view.parts[part].weight > 0)
                image[i] += view.parts[part].radiance[i] / view.parts[part].weight;
        image[i] += view.parts[FilmPart::Splats].radiance[i] / view.film_passes /
                    (SphereView::kPixels * SphereView::kPixels);
    }
    return image;
}

// Protects the whole: by photons alone and with paths, the glowing sphere is as bright as it must
// be, and each pass has wavelengths of its own.
TEST(LuxRenderShim, GlowingSphere) {
    for (const bool direct : {true, false}) {
        SphereView view;
        using Type = GivenParameter::Type;
        const auto run = start_engine(view,
                                      {{Type::Bool, "directlightsampling", double(direct), {}},
                                       {Type::Bool, "continueeyepaths", double(direct), {}},
                                       {Type::Integer, "photonperpass", 20'000, {}},
                                       {Type::Integer, "maxphotondepth", 30, {}},
                                       {Type::Integer, "maxeyedepth", 30, {}}},
                                      0);
        view.wavelengths.clear();
        for (unsigned pass = 0; pass < 16; ++pass)
            run->render_pass(2);
        EXPECT_EQ(view.wavelengths.size(), 16u);
        EXPECT_EQ(view.film_passes, 16u);
        EXPECT_TRUE(run->refused().empty());
        const auto image = image_of(view);
        for (unsigned i = 0; i < 3; ++i) {
            const double expected =
                SphereView::kEmitted.v[i] / (1 - double(SphereView::kReflectance));
            EXPECT_NEAR(image[i] / expected, 1, 0.02) << i << (direct ? " with paths" : "");
        }
    }
}

// Protects users: what is misspelt is told, what contradicts itself refused.
TEST(LuxRenderShim, TellsWhatIsWrong) {
    SphereView view;
    using Type = GivenParameter::Type;
    EXPECT_THROW(start_engine(view, {{Type::String, "mode", 0, "photonmap"}}, 0),
                 std::invalid_argument);
    EXPECT_ANY_THROW(start_engine(view, {{Type::String, "guide", 0, "adaptiv"}}, 0));
}

}  // namespace
}  // namespace aips::luxrender
