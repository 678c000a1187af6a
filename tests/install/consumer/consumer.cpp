// A host of the engine in one file. A point light shines into a ring of mirrors; the caustic on the
// floor is rendered to caustic.ppm. docs/build-on/host-adapter.md walks through it.
#include <aips/adapter/engine.h>
#include <aips/adapter/host_validation.h>
#include <aips/parts/image_film.h>
#include <aips/parts/triangle_scene.h>
#include <aips/parts/uniform_sampler.h>

#include <cmath>
#include <fstream>
#include <iostream>

namespace {

using aips::Vec3;

constexpr std::uint32_t kWidth = 160, kHeight = 120, kPasses = 8;

/// A matte floor, and on it a ring of flat mirrors, fine enough to look round.
void build(aips::TriangleScene& scene) {
    using Kind = aips::TriangleMaterial::Kind;
    const auto floor = scene.add_material({.reflectance = {0.7f, 0.7f, 0.6f}, .name = "floor"});
    const auto mirror = scene.add_material(
        {.kind = Kind::Mirror, .reflectance = {0.9f, 0.8f, 0.5f}, .name = "ring"});
    scene.add_quad({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}, floor);
    constexpr int kSegments = 512;
    const auto rim = [](int i) {
        const float angle = 6.2831853f * float(i % kSegments) / kSegments;
        return Vec3{std::cos(angle), std::sin(angle), 0};
    };
    for (int i = 0; i < kSegments; ++i)
        scene.add_quad(rim(i), rim(i + 1) - rim(i), {0, 0, 0.5f}, mirror);
    scene.add_point_light({3, 0, 2}, {30, 30, 30});
    scene.finish();
}

/// A pinhole that looks down at the ring.
class Camera final : public aips::Camera {
  public:
    aips::CameraRay generate(const aips::CameraSample& sample, float time) const override {
        const Vec3 forward = normalize(Vec3{0, 2, -3}), right{1, 0, 0};
        const Vec3 down = cross(forward, right);
        const float pixel = 2 * kHalfWidth / kWidth;  // at distance 1 along `forward`
        const float x = pixel * (sample.film.x - 0.5f * kWidth);
        const float y = pixel * (sample.film.y - 0.5f * kHeight);
        aips::CameraRay camera_ray;
        camera_ray.ray.origin = {0, -2, 3.2f};
        camera_ray.ray.direction = normalize(forward + right * x + down * y);
        camera_ray.ray.time = time;
        camera_ray.spread = 0.5f * pixel;  // of the footprint's radius
        return camera_ray;
    }
    float shutter_open() const override { return 0; }
    float shutter_close() const override { return 0; }

  private:
    static constexpr float kHalfWidth = 0.4f;
};

class Log final : public aips::Log {
  public:
    void info(std::string_view message) override { std::cout << message << '\n'; }
    void warning(std::string_view message) override { std::cerr << message << '\n'; }
};

/// Linear radiance as 8-bit sRGB, about.
void write_ppm(const char* path, const aips::ImageFilm& film) {
    std::ofstream out(path, std::ios::binary);
    out << "P6\n" << film.width() << ' ' << film.height() << "\n255\n";
    const auto byte = [](float radiance) {
        return char(int(255 * std::pow(std::min(radiance, 1.0f), 1 / 2.2f) + 0.5f));
    };
    for (const aips::Rgb& pixel : film.image())
        out << byte(pixel.r) << byte(pixel.g) << byte(pixel.b);
    if (!out.flush()) throw std::runtime_error(std::string("cannot write ") + path);
}

}  // namespace

int main() try {
    aips::TriangleScene scene;
    build(scene);
    for (const aips::HostFinding& finding : aips::validate_host(scene))
        std::cerr << to_string(finding) << '\n';

    aips::Settings settings;
    settings.photons_per_pass = 50'000;
    const Camera camera;
    const aips::UniformSampler sampler(settings.seed);
    aips::ImageFilm film(kWidth, kHeight, scene.light_groups());
    Log log;
    aips::Engine engine({scene, camera, sampler, film, log}, settings);
    for (std::uint64_t pass = 0; pass < kPasses; ++pass)
        engine.render_pass(pass);
    write_ppm("caustic.ppm", film);
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
