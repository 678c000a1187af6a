// Draws random scenes; those where the camera would see nothing lit are drawn again.
#include "random_scenes.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "aips/core/base/arena.h"
#include "aips/core/sampling/random.h"
#include "aips/core/sampling/sampling.h"

namespace mock {
namespace {

using namespace aips;

constexpr float kObjectMargin = 0.03f;  // free space around objects and lamps
constexpr float kCameraMargin = 0.12f;

/// Numbers of one scene and what has been placed so far.
class Drawing {
  public:
    Drawing(std::uint64_t number, std::uint64_t attempt, const RandomSceneKind& kind)
        : random_(number, attempt, 0, RandomDomain::Guide), kind_(kind) {}

    float between(float low, float high) { return low + (high - low) * random_.next(); }
    std::uint32_t below(std::uint32_t count) {
        return std::min(count - 1, std::uint32_t(random_.next() * float(count)));
    }
    bool chance(float probability) { return random_.next() < probability; }
    Vec3 direction() { return square_to_uniform_sphere(random_.next2()); }
    Vec3 inside(float margin) {
        return {between(-1 + margin, 1 - margin), between(-1 + margin, 1 - margin),
                between(-1 + margin, 1 - margin)};
    }
    Rgb tint(float low, float high) {
        return {between(low, high), between(low, high), between(low, high)};
    }

    /// A free place for something of this radius, which is kept free from then on.
    std::optional<Vec3> place(float radius) {
        for (int attempt = 0; attempt < 50; ++attempt) {
            const Vec3 center = inside(radius + kObjectMargin);
            if (!is_free(center, radius + kObjectMargin)) continue;
            taken_.push_back({center, radius});
            return center;
        }
        return {};
    }
    bool is_free(Vec3 center, float radius) const {
        for (const Ball& ball : taken_) {
            if (length(ball.center - center) < ball.radius + radius) return false;
        }
        return true;
    }

    void add_room(Scene& scene);
    void add_object(Scene& scene);
    void add_lights(Scene& scene);
    Camera camera(std::uint32_t width, std::uint32_t height);

  private:
    Material material(bool solid);
    Material half_mirror();
    void add_lamp(Scene& scene, Rgb watts);

    RandomStream random_;
    RandomSceneKind kind_;
    std::vector<Ball> taken_;
};

void Drawing::add_room(Scene& scene) {
    const Vec3 x{2, 0, 0}, y{0, 2, 0}, z{0, 0, 2}, low{-1, -1, -1}, high{1, 1, 1};
    const Quad walls[] = {{low, x, y},    {low, y, z},    {low, z, x},
                          {high, -z, -y}, {high, -x, -z}, {high, -y, -x}};
    const std::uint32_t missing = 1 + below(4);
    for (std::uint32_t i = 0; i < 6; ++i) {
        if (kind_.open && (i == missing || i == 5)) continue;
        Surface wall;
        wall.shape = walls[i];
        if (kind_.open && i == 0) wall.shape = Quad{{-4, -4, -1}, x * 4, y * 4};
        wall.material.reflectance = tint(0.2f, 0.8f);
        wall.material.hide_lambert = chance(0.3f);
        if (kind_.half_mirrors) wall.material = half_mirror();
        scene.add(wall);
    }
}

Material Drawing::material(bool solid) {
    using Kind = Material::Kind;
    if (kind_.half_mirrors) return half_mirror();
    Material m;
    m.reflectance = tint(0.1f, 0.8f);
    m.hide_lambert = chance(0.3f);
    switch (below(solid ? 6 : 5)) {  // glass has an inside
        case 2:
            return half_mirror();
        case 3:
            m.kind = kind_.accountable ? Kind::LambertAndMirror : Kind::Mirror;
            m.reflectance = kind_.accountable ? Rgb{} : tint(0.6f, 1.0f);
            m.specular = kWhite;
            break;
        case 4:
            if (kind_.accountable) break;
            m.kind = Kind::Phong;
            m.exponent = between(5, 40);
            break;
        case 5:
            if (kind_.accountable) break;
            m.kind = Kind::Glass;
            m.index = between(1.2f, 1.8f);
            break;
        default:
            break;
    }
    return m;
}

Material Drawing::half_mirror() {
    Material m;
    m.kind = Material::Kind::LambertAndMirror;
    m.reflectance = tint(0.1f, 0.5f);
    m.specular = tint(0.1f, 0.4f);
    return m;
}

void Drawing::add_object(Scene& scene) {
    const float radius = between(0.15f, 0.4f);
    const auto center = place(radius);
    if (!center) return;
    Surface surface;
    const std::uint32_t shape = below(4);
    surface.material = material(shape < 3);
    if (shape < 2) {
        surface.shape = Ball{*center, radius, false};
        scene.add(surface);
    } else if (shape == 2) {
        const float half = radius / std::sqrt(3.0f);
        const Vec3 corner{half, half, half};
        scene.add_box(*center + corner, *center - corner, surface);  // faces look outwards
    } else {
        const Frame frame(direction());
        const float half = radius / std::sqrt(2.0f);
        const Vec3 u = frame.to_world({2 * half, 0, 0}), v = frame.to_world({0, 2 * half, 0});
        surface.shape = Quad{*center - (u + v) * 0.5f, u, v};
        scene.add(surface);
    }
}

/// A ball, or a quad that looks into the room's middle.
void Drawing::add_lamp(Scene& scene, Rgb watts) {
    const float radius = between(0.05f, 0.25f);
    const auto center = place(radius);
    if (!center) return;
    Surface lamp;
    lamp.material.reflectance = {0, 0, 0};
    float area = 4 * kPi * radius * radius;
    if (chance(0.4f)) {
        lamp.shape = Ball{*center, radius, false};
    } else {
        const Frame frame(normalize(inside(0.5f) - *center));
        const Vec3 u = frame.to_world({radius, 0, 0}), v = frame.to_world({0, radius, 0});
        lamp.shape = Quad{*center - (u + v) * 0.5f, u, v};
        area = radius * radius;
    }
    lamp.emitted = watts / (kPi * area);
    scene.add(lamp);
}

void Drawing::add_lights(Scene& scene) {
    const std::uint32_t count = 1 + below(3);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Rgb watts = tint(0.5f, 1.0f) * (10 * std::pow(10.0f, between(-3, 0)));
        const std::uint32_t kind = below(kind_.open ? 5 : 3);
        if (kind < 2 || (kind == 2 && kind_.no_points)) {
            add_lamp(scene, watts);
        } else if (kind == 2) {
            if (const auto position = place(0.05f)) {
                scene.add_point_light(*position, watts / (4 * kPi));
            }
        } else if (kind == 3) {
            const Vec3 axis = normalize(Vec3{between(-1, 1), between(-1, 1), 1});
            const float cosine = between(0.9f, 0.999f);
            scene.add_distant_light({axis, cosine}, watts / (2 * kPi * (1 - cosine)));
        } else {
            scene.add_environment(watts / (4 * kPi));
        }
    }
}

Camera Drawing::camera(std::uint32_t width, std::uint32_t height) {
    Vec3 eye = inside(kCameraMargin);
    for (int attempt = 0; attempt < 50 && !is_free(eye, kCameraMargin); ++attempt)
        eye = inside(kCameraMargin);
    const Frame frame(normalize(inside(0.2f) - eye));
    const float half = between(0.25f, 0.7f);
    return {eye,
            frame.n,
            frame.to_world({half, 0, 0}),
            frame.to_world({0, half * float(height) / float(width), 0}),
            width,
            height};
}

bool in_direct_light(const Scene& scene, const SurfacePoint& point, Vec3 wo) {
    for (const Light* light : scene.lights()) {
        DirectSample sample;
        if (!light->sample_direct(point, {0.5f, 0.5f}, sample)) continue;
        if (is_black(point.bsdf->evaluate(wo, sample.wi, Transport::Radiance, kDiffuse))) continue;
        if (!is_black(scene.visibility(point, sample, 0))) return true;
    }
    return false;
}

/// Whether enough of the view is lit, and nothing in it shines by itself.
bool is_worth_seeing(const Scene& scene, const Camera& camera, std::uint32_t width,
                     std::uint32_t height) {
    constexpr int kSide = 6;
    int lit = 0;
    Arena arena;
    for (int i = 0; i < kSide * kSide; ++i) {
        const int column = i % kSide, row = i / kSide;
        const Vec2 film{(float(column) + 0.5f) * float(width) / kSide,
                        (float(row) + 0.5f) * float(height) / kSide};
        const Ray ray = camera.generate({film, {}}, 0).ray;
        SurfacePoint point;
        if (!scene.intersect(ray, point, arena)) continue;
        if (!is_black(point.emitted)) return false;
        if (!(point.bsdf->lobes() & kDiffuse)) continue;
        lit += in_direct_light(scene, point, -ray.direction) ? 1 : 0;
    }
    return 2 * lit >= kSide * kSide;
}

}  // namespace

View random_view(std::uint64_t number, const RandomSceneKind& kind, std::uint32_t width,
                 std::uint32_t height) {
    for (std::uint64_t attempt = 0; attempt < 100; ++attempt) {
        Drawing drawing(number, attempt, kind);
        Scene scene;
        drawing.add_room(scene);
        const std::uint32_t objects = 1 + drawing.below(3);
        for (std::uint32_t i = 0; i < objects; ++i)
            drawing.add_object(scene);
        drawing.add_lights(scene);
        if (kind.accountable) {
            Surface shell;
            shell.shape = Ball{{0, 0, 0}, 20, true};
            shell.material.reflectance = {0, 0, 0};
            scene.add(shell);
        }
        scene.finish();
        for (int i = 0; i < 20; ++i) {
            const Camera camera = drawing.camera(width, height);
            if (!is_worth_seeing(scene, camera, width, height)) continue;
            return {std::move(scene), camera};
        }
    }
    throw std::runtime_error("random_view: found no camera");
}

}  // namespace mock
