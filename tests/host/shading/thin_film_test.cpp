// Interference colours against direct integration over the spectrum, in all materials with films.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bsdf_statistics.h"
#include "bsdfs/thin_film.h"
#include "lxs/spectrum/colour_matching.h"
#include "shading_fixture.h"

namespace lxs::thin_film_test {
namespace {

using shading::ThinFilm;

Rgb integrated(const ThinFilm& film, float c) {
    Imath::V3d sum(0.0), total(0.0);
    for (double nm = 380; nm <= 780; nm += 0.25) {
        const Imath::V3d response = rgb_response(nm);
        sum += response * shading::film_share(film, c, nm);
        total += response;
    }
    Rgb mean;
    for (int i = 0; i < 3; ++i)
        mean[i] = static_cast<float>(std::clamp(sum[i] / total[i], 0.0, 1.0));
    return mean;
}

TEST(ThinFilm, TableIsTheIntegralOverTheSpectrum) {
    for (const float thickness : {1.0f, 80.0f, 233.0f, 500.0f, 1111.0f, 2500.0f}) {
        for (const float index : {1.1f, 1.33f, 1.9f}) {
            for (const float c : {1.0f, 0.6f, 0.05f}) {
                const ThinFilm film{thickness, index, nullptr};
                const Rgb expected = integrated(film, c), found = film.filter(c);
                for (int i = 0; i < 3; ++i)
                    EXPECT_NEAR(found[i], expected[i], 2e-3f) << thickness << " nm, " << index;
            }
        }
    }
}

TEST(ThinFilm, NoneAndVeryThickOnesHaveNoColour) {
    EXPECT_EQ(ThinFilm{}.filter(0.3f), Rgb(1.0f));
    EXPECT_EQ((ThinFilm{1e6f, 1.5f, nullptr}.filter(1)), Rgb(0.5f));
    // A film much thinner than light changes nothing.
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR((ThinFilm{1e-2f, 1.5f, nullptr}.filter(1)[i]), 1, 1e-4f);
}

// A quarter of the fringe's wavelength: what it extinguishes is known exactly.
TEST(ThinFilm, ExtinguishesAtOddHalfWaves) {
    const ThinFilm film{200, 1.4f, nullptr};  // 2 d n = 560 nm: 1 at 560 nm, 0 at 1120 / 3 nm
    EXPECT_NEAR(shading::film_share(film, 1, 560), 1, 1e-6);
    EXPECT_NEAR(shading::film_share(film, 1, 1120.0 / 3), 0, 1e-6);
    EXPECT_GT(film.filter(1).y, film.filter(1).z);
    // Under 60 degrees: the path 2 d sqrt(n^2 - 3 / 4).
    const double path = 400 * std::sqrt(1.4 * 1.4 - 0.75);
    EXPECT_NEAR(shading::film_share(film, 0.5, path), 1, 1e-6);
    EXPECT_NEAR(shading::film_share(film, 0.5, 2 * path), 0, 1e-6);
}

class FilmMaterialTest : public ::testing::Test {
  protected:
    Rgb reflected(const std::string& plugin, double film, const Vec3& wo) {
        const auto material =
            scene_.make_material(plugin, {number("film", film), number("filmindex", 1.8)});
        BsdfMemory memory;
        const Bsdf& bsdf = *memory.scatter(*material, shading_point());
        UniformSource u(1);
        Rgb sum(0.0f);
        constexpr int kSamples = 20000;
        for (int i = 0; i < kSamples; ++i) {
            BsdfSample sample;
            const Vec2 uv = u.pair();
            if (bsdf.sample(wo, uv, u(), Transport::Radiance, kSpecular, sample) &&
                !sample.transmitted)
                sum += sample.weight;
        }
        return sum / float{kSamples};
    }
    ShadingFixture scene_;
};

TEST_F(FilmMaterialTest, ColoursWhatIsReflected) {
    const Vec3 wo = Vec3(0.5f, 0, 1).normalized();
    const Rgb share = ThinFilm{230, 1.8f}.filter(wo.z);
    for (const char* plugin : {"mirror", "glass"}) {
        const Rgb plain = reflected(plugin, 0, wo), coloured = reflected(plugin, 230, wo);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(coloured[i], plain[i] * share[i], 0.03f * plain[i]) << plugin;
    }
    const Rgb plain = reflected("shinymetal", 0, wo), coloured = reflected("shinymetal", 230, wo);
    EXPECT_LT(max_component(coloured), max_component(plain) + 1e-3f);
    EXPECT_TRUE(scene_.diagnostics.warnings.empty());
}

}  // namespace
}  // namespace lxs::thin_film_test
