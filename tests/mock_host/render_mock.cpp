// Renders mock scenes with the engine.
#include "render_mock.h"

namespace mock {

using namespace aips;

Rendering render(const aips::Scene& scene, const Camera& camera, std::uint32_t width,
                 std::uint32_t height, const Settings& settings, std::uint32_t passes) {
    Rendering result{Film(width, height, scene.light_groups()), {}, {}};
    const Sampler sampler(settings.seed);
    Engine engine({scene, camera, sampler, result.film, result.log}, settings);
    for (std::uint32_t pass = 0; pass < passes; ++pass)
        engine.render_pass(pass);
    result.statistics = engine.statistics();
    return result;
}

std::vector<float> radii(const Scene& scene, const Settings& settings, unsigned passes) {
    const Camera camera = camera_along_y({0, -0.9f, 0}, 1, 16, 16);
    const Sampler sampler(settings.seed);
    Film film(16, 16);
    Log log;
    Engine engine({scene, camera, sampler, film, log}, settings);
    std::vector<float> result;
    for (unsigned pass = 0; pass < passes; ++pass)
        result.push_back(engine.render_pass(pass).radius);
    return result;
}

std::string name(GuideKind guide) {
    if (guide == GuideKind::None) return "none";
    return guide == GuideKind::Paper ? "paper" : "adaptive";
}

std::vector<double> luminances(const Film& film) {
    std::vector<double> values;
    for (const Rgb& pixel : film.image())
        values.push_back(luminance(pixel));
    return values;
}

double mean_luminance(const std::vector<Rgb>& image, std::uint32_t width, std::uint32_t x0,
                      std::uint32_t y0, std::uint32_t x1, std::uint32_t y1) {
    double sum = 0;
    for (std::uint32_t y = y0; y < y1; ++y) {
        for (std::uint32_t x = x0; x < x1; ++x)
            sum += luminance(image[y * width + x]);
    }
    return sum / (double(x1 - x0) * double(y1 - y0));
}

Settings small_settings(std::uint64_t seed, std::uint32_t photons) {
    Settings settings;
    settings.seed = seed;
    settings.guide = GuideKind::None;
    settings.pilot_pass = false;
    settings.photons_per_pass = photons;
    settings.alpha = 1;
    return settings;
}

Camera camera_along_y(Vec3 eye, float half, std::uint32_t width, std::uint32_t height) {
    const float aspect = float(height) / float(width);
    return {eye, {0, 1, 0}, {half, 0, 0}, {0, 0, -half * aspect}, width, height};
}

Scene lamp_box(const Material& wall, const Material& ball) {
    Scene scene;
    Surface walls;
    walls.material = wall;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, walls);
    Surface matte;
    matte.shape = Ball{{0.35f, 0.3f, -0.6f}, 0.4f, false};
    matte.material = ball;
    scene.add(matte);
    Surface lamp;
    lamp.shape = Quad{{-0.3f, -0.3f, 0.98f}, {0, 0.6f, 0}, {0.6f, 0, 0}};
    lamp.material.reflectance = {0, 0, 0};
    lamp.emitted = {10, 10, 10};
    scene.add(lamp);
    scene.finish();
    return scene;
}

Material half_mirror() {
    Material material;
    material.kind = Material::Kind::LambertAndMirror;
    material.specular = {0.3f, 0.3f, 0.3f};
    return material;
}

Material sheet(bool shiny) {
    Material material;
    material.kind = Material::Kind::Sheet;
    material.reflectance = {0.3f, 0.3f, 0.3f};
    material.transmittance = {0.45f, 0.45f, 0.45f};
    if (shiny) material.glossy = material.specular = {0.1f, 0.1f, 0.1f};
    return material;
}

View divided_view(std::uint32_t width, std::uint32_t height, const Material& divider,
                  float outshone) {
    Scene scene;
    Surface wall;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    Surface divided;
    divided.shape = Quad{{0, -1, -1}, {0, 2, 0}, {0, 0, 2}};
    divided.material = divider;
    divided.normal_tilt = {0, 0.0524f, 0};
    scene.add(divided);
    Surface lamp;
    lamp.shape = Quad{{-0.8f, -0.3f, 0.98f}, {0, 0.6f, 0}, {0.6f, 0, 0}};
    lamp.material.reflectance = {0, 0, 0};
    lamp.emitted = {10, 10, 10};
    scene.add(lamp);
    if (outshone > 0) {
        Surface black = wall;
        black.material.reflectance = {0, 0, 0};
        scene.add_box({2, -1, -1}, {4, 1, 1}, black);
        lamp.shape = Quad{{2.7f, -0.3f, 0.98f}, {0, 0.6f, 0}, {0.6f, 0, 0}};
        lamp.emitted = lamp.emitted * outshone;
        scene.add(lamp);
    }
    scene.finish();
    return {std::move(scene), camera_along_y({0.01f, -0.95f, 0}, 1, width, height)};
}

View half_mirror_view(std::uint32_t width, std::uint32_t height) {
    return {lamp_box({}, half_mirror()), camera_along_y({0, -0.95f, 0}, 1, width, height)};
}

View wide_view(float half, std::uint32_t width, std::uint32_t height) {
    Scene scene;
    Surface ground;
    ground.shape = Quad{{-half, -half, 0}, {2 * half, 0, 0}, {0, 2 * half, 0}};
    scene.add(ground);
    Surface wall;
    wall.shape = Quad{{0.6f, -1, 0}, {0, 2, 0}, {0, 0, 1}};
    scene.add(wall);
    Surface lamp;
    lamp.shape = Quad{{-half, -half, 3}, {0, 2 * half, 0}, {2 * half, 0, 0}};
    lamp.material.reflectance = {0, 0, 0};
    lamp.emitted = {1, 1, 1};
    scene.add(lamp);
    scene.finish();
    return {std::move(scene), {{0, 0, 1}, {0, 0, -1}, {0.4f, 0, 0}, {0, 0.3f, 0}, width, height}};
}

}  // namespace mock
