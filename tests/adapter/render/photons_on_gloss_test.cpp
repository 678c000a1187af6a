// Protects indirect light on glossy lobes that bounce the eye path on as well: what photons bring
// and what they leave to the bounce add up, and bright places that bounces seldom meet are no dots.
#include <gtest/gtest.h>

#include <utility>

#include "render_mock.h"

namespace aips::photons_on_gloss_test {
namespace {

using Kind = mock::Material::Kind;

constexpr std::uint32_t kSize = 16;

const mock::Camera kAtFloor{{0, -1, 1}, {0, 0.6f, -0.8f}, {0.2f, 0, 0}, {0, 0.16f, 0.12f}, kSize,
                            kSize};

void add_quad(mock::Scene& scene, const mock::Quad& quad, const mock::Material& material,
              Rgb emitted = {}) {
    mock::Surface surface;
    surface.shape = quad;
    surface.material = material;
    surface.emitted = emitted;
    scene.add(surface);
}

mock::Material phong(float exponent) {
    mock::Material gloss;
    gloss.kind = Kind::Phong;
    gloss.exponent = exponent;
    return gloss;
}

/// Of a box with a lamp and a ball. With and without photons on gloss it differs, over seeds, by a
/// standard deviation below 0.1 %.
double mean_of(const mock::Material& walls, const mock::Material& ball, bool by_photons) {
    Settings settings = mock::small_settings(7, by_photons ? 5000 : 2000);
    settings.start_radius = 0.2f;
    settings.caustics_on_gloss = by_photons;
    const mock::Camera camera = mock::camera_along_y({0, -0.95f, 0}, 0.8f, kSize, kSize);
    return mock::render(mock::lamp_box(walls, ball), camera, kSize, kSize, settings, 400)
        .film.mean();
}

/// `L D G E` and `L G G E`, with lobes of all kinds on one surface too, in whose mirror lobe the
/// lamp is met as well.
TEST(PhotonsOnGloss, PhotonsAndBouncesAddUp) {
    mock::Material mixed = mock::sheet(true);
    mixed.exponent = 4;
    mock::Material mirror = mock::half_mirror();
    mirror.specular = {0.6f, 0.6f, 0.6f};
    mirror.reflectance = {0.2f, 0.2f, 0.2f};
    const mock::Material matte, gloss = phong(4);
    const std::pair<mock::Material, mock::Material> boxes[] = {
        {matte, gloss}, {gloss, matte}, {gloss, gloss}, {mixed, mixed}, {mirror, gloss}};
    for (const auto& [walls, ball] : boxes) {
        const double bounces = mean_of(walls, ball, false);
        EXPECT_NEAR(mean_of(walls, ball, true) / bounces, 1, 0.006);
    }
}

/// A small bright patch beside the lobe: few bounces meet it.
TEST(PhotonsOnGloss, BrightPlacesBesideTheLobeAreNoDots) {
    mock::Scene scene;
    add_quad(scene, {{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}}, phong(6));
    add_quad(scene, {{-1, 1.2f, 0}, {0.4f, 0, 0}, {0, 0, 0.3f}}, {});
    mock::Material black;
    black.reflectance = {0, 0, 0};
    add_quad(scene, {{-1, 1, 0.4f}, {0, 0, 0.2f}, {0.4f, 0, 0}}, black, {100, 100, 100});
    scene.finish();
    /// E[Y^2] / E[Y]^2 over pixels, which hardly differ in brightness.
    const auto second_moment = [&](bool by_photons) {
        Settings settings = mock::small_settings(7, 100'000);
        settings.start_radius = 0.3f;
        settings.caustics_on_gloss = by_photons;
        const auto film = mock::render(scene, kAtFloor, kSize, kSize, settings, 16).film;
        double squares = 0;
        for (const double value : mock::luminances(film))
            squares += value * value / (kSize * kSize);
        return squares / (film.mean() * film.mean());
    };
    EXPECT_LT(second_moment(true), 0.5 * second_moment(false));
}

}  // namespace
}  // namespace aips::photons_on_gloss_test
