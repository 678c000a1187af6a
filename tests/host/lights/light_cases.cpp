// Lights under test, made as the scene reader makes them, and their visible surfaces.
#include "light_cases.h"

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "lxs/scene/constant_texture.h"
#include "temporary_folder.h"

namespace lxs::test {
namespace {

using Meet = std::function<std::optional<LightHit>(const Vec3&, const Vec3&)>;

/// Flat light: `inside` says whether a point of the plane belongs to it.
Meet meet_plane(const Vec3& origin, const Vec3& normal,
                const std::function<bool(const Vec3&)>& inside) {
    return [=](const Vec3& p, const Vec3& wi) -> std::optional<LightHit> {
        const float t = ((origin - p) ^ normal) / (wi ^ normal);
        if (!(t > 0) || !inside(p + wi * t)) return std::nullopt;
        return LightHit{p + wi * t, normal};
    };
}

/// The nearest (or farthest) point of an ellipsoid with half axes `radii` around `center`.
Meet meet_ellipsoid(const Vec3& center, const Vec3& radii, bool nearest, float z_least) {
    return [=](const Vec3& p, const Vec3& wi) -> std::optional<LightHit> {
        const Imath::V3d o((p - center) / radii), d(wi / radii);
        const double a = d ^ d, b = o ^ d, c = (o ^ o) - 1;
        const double discriminant = b * b - a * c;
        if (discriminant < 0) return std::nullopt;
        const double t = (-b + (nearest ? -1 : 1) * std::sqrt(discriminant)) / a;
        if (t <= 0) return std::nullopt;
        const Vec3 q = p + wi * static_cast<float>(t);
        const Vec3 local = (q - center) / radii;
        if (local.z < z_least) return std::nullopt;
        const Vec3 n = (local / radii).normalized();
        return LightHit{q, nearest ? n : -n};
    };
}

/// Lights read its files while tests run.
const files::TemporaryFolder& folder() {
    static const files::TemporaryFolder made;
    return made;
}

Meet meet_everywhere() {
    return [](const Vec3&, const Vec3&) { return LightHit{}; };
}

/// A ball of radius 0.5 around (0, 0, 3).
Primitive ball() {
    return emissive(placed(Sphere{0.5f, -0.5f, 0.5f, 360}, translation(0, 0, 3)), Rgb(2.0f));
}

ExtendedLight sphere_case(const std::string& name, const Vec3& from, const Primitive& primitive) {
    const Vec3 center(0, 0, 3);
    const float radius = 0.5f;
    ExtendedLight result;
    result.name = name;
    result.light = make_area_light(primitive, Matrix());
    result.from = from;
    result.meet = meet_ellipsoid(center, Vec3(radius), true, -2);
    const float distance = (center - from).length();
    result.axis = (center - from) / distance;
    result.cos_min = std::sqrt(std::max(0.0f, 1 - radius * radius / (distance * distance))) - 1e-3f;
    if (distance > 10) result.cos_min = 1 - 0.6f * radius * radius / (distance * distance);
    return result;
}

void add_flat_lights(std::vector<ExtendedLight>& all) {
    const auto mesh = parallelogram(Vec3(-1, -0.5f, 2), Vec3(0, 1, 0), Vec3(2, 0, 0.5f));
    const Vec3 normal = (Vec3(0, 1, 0) % Vec3(2, 0, 0.5f)).normalized();
    const Meet meet = meet_plane(Vec3(-1, -0.5f, 2), normal, [](const Vec3& p) {
        return std::abs(p.x) <= 1 && std::abs(p.y) <= 0.5f;
    });
    const Primitive plain = emissive(mesh, Rgb(3, 2, 1));
    for (const auto& [name, primitive] :
         {std::pair("mesh", plain), std::pair("mesh with a photometric file",
                                              profiled(plain, {text("iesname", wall_washer())}))}) {
        all.push_back({name, make_area_light(primitive, Matrix()), Vec3(0.3f, 0.2f, 0), meet,
                       Vec3(0, 0, 1), 0.7f});
    }
    Primitive ring = emissive(placed(Disk{0, 0.8f, 0.3f, 360}, translation(0, 0, 2)), Rgb(1.0f));
    ring.reverse_orientation = true;
    all.push_back({"ring", make_area_light(ring, Matrix()), Vec3(0.2f, 0, 0),
                   meet_plane(Vec3(0, 0, 2), Vec3(0, 0, -1),
                              [](const Vec3& p) {
                                  const float r = std::hypot(p.x, p.y);
                                  return r <= 0.8f && r >= 0.3f;
                              }),
                   Vec3(0, 0, 1), 0.85f});
}

void add_curved_lights(std::vector<ExtendedLight>& all) {
    all.push_back(sphere_case("sphere", Vec3(0.4f, 0.3f, 0), ball()));
    all.push_back(sphere_case("sphere near", Vec3(0, 0, 2.45f), ball()));
    all.push_back(sphere_case("sphere far", Vec3(30, 20, 0), ball()));
    all.push_back(sphere_case("sphere with an image", Vec3(0.4f, 0.3f, 0),
                              profiled(ball(), {text("mapname", probe_image())})));
    Primitive hollow = emissive(placed(Sphere{1, -1, 1, 360}, translation(0, 0, 0.2)), Rgb(1.0f));
    hollow.reverse_orientation = true;
    all.push_back({"sphere from inside", make_area_light(hollow, Matrix()), Vec3(0.3f, 0, 0),
                   meet_ellipsoid(Vec3(0, 0, 0.2f), Vec3(1.0f), false, -2)});
    all.push_back(
        {"cut ellipsoid",
         make_area_light(
             emissive(placed(Sphere{1, 0.2f, 1, 360}, scaling(1, 0.5, 0.7) * translation(0, 0, 1)),
                      Rgb(1.0f)),
             Matrix()),
         Vec3(0.2f, 0.1f, 4), meet_ellipsoid(Vec3(0, 0, 1), Vec3(1, 0.5f, 0.7f), true, 0.2f),
         Vec3(0, 0, -1), 0.85f});
}

void add_lights_at_infinity(std::vector<ExtendedLight>& all) {
    const auto add = [&](const std::string& name, std::unique_ptr<Light> light, const Vec3& axis,
                         float cos_min) {
        all.push_back(
            {name, std::move(light), Vec3(0.0f), meet_everywhere(), axis.normalized(), cos_min});
    };
    const auto sun = numbers("vector", "sundir", {0.5, -0.6, 0.7});
    Matrix turned;
    turned.rotate(Imath::V3d(0.3, 0.5, 0.7));
    add("infinite", make_one("infinite", {}), Vec3(0, 0, 1), -1);
    add("infinite map", make_one("infinite", {text("mapname", probe_image())}, turned),
        Vec3(0, 0, 1), -1);
    add("sky", make_one("sky", {sun, numbers("float", "gain", {1e-4})}), Vec3(0, 0, 1), -1);
    add("sky2", make_one("sky2", {sun, numbers("float", "gain", {1e-4})}), Vec3(0, 0, 1), -1);
    add("sun", make_one("sun", {sun, numbers("float", "gain", {1e-8})}), Vec3(0.5f, -0.6f, 0.7f),
        0.99997f);
    add("distant disk",
        make_one("distant", {numbers("float", "theta", {10}), numbers("point", "from", {1, 2, 3}),
                             numbers("point", "to", {0, 0, 0})}),
        Vec3(1, 2, 3), 0.97f);
}

}  // namespace

void RecordedDiagnostics::warning(const SourceLocation& /*where*/, const std::string& message) {
    warnings.push_back(message);
}

void RecordedDiagnostics::unknown_parameter(const SourceLocation& where,
                                            const std::string& message) {
    warning(where, message);
}

ParameterValue numbers(const std::string& type, const std::string& name,
                       const std::vector<double>& values) {
    return {type, name, values, {}, {}};
}

ParameterValue text(const std::string& name, const std::string& value) {
    return {"string", name, std::vector<std::string>{value}, {}, {}};
}

SceneSphere scene_sphere() {
    return {Vec3(0.1f, -0.2f, 0.3f), 4.0f};
}

Lights make(const std::string& plugin, const std::vector<ParameterValue>& values,
            RecordedDiagnostics& diagnostics, const Matrix& to_world) {
    LightDescription description;
    description.parameters = {plugin, {}, values};
    description.to_world = to_world;
    return make_lights(
        description, scene_sphere(),
        [](const std::string& name, const SourceLocation&) { return name; }, diagnostics);
}

std::unique_ptr<Light> make_one(const std::string& plugin,
                                const std::vector<ParameterValue>& values, const Matrix& to_world) {
    RecordedDiagnostics diagnostics;
    Lights lights = make(plugin, values, diagnostics, to_world);
    if (lights.size() != 1) throw std::logic_error(plugin + " made not one light");
    return std::move(lights.front());
}

std::shared_ptr<const ColorTexture> constant_color(const Rgb& color) {
    return std::make_shared<ConstantTexture<Rgb>>(color);
}

Primitive emissive(Geometry geometry, const Rgb& radiance) {
    Primitive primitive;
    primitive.geometry = std::move(geometry);
    AreaEmission emission;
    emission.radiance = constant_color(radiance);
    emission.power = emission.efficacy = 0;
    primitive.emission = emission;
    return primitive;
}

Primitive profiled(Primitive primitive, const std::vector<ParameterValue>& values,
                   RecordedDiagnostics& diagnostics) {
    const ParameterSet set{"area", {}, values};
    const ParameterReader reader(set, area_light_parameters(), diagnostics);
    primitive.emission->profile = read_area_profile(
        reader, [](const std::string& name, const SourceLocation&) { return name; });
    return primitive;
}

Primitive profiled(Primitive primitive, const std::vector<ParameterValue>& values) {
    RecordedDiagnostics diagnostics;
    return profiled(std::move(primitive), values, diagnostics);
}

Quadric placed(decltype(Quadric::shape) shape, const Matrix& to_world) {
    return {std::move(shape), to_world};
}

std::vector<ExtendedLight> extended_lights() {
    std::vector<ExtendedLight> all;
    add_flat_lights(all);
    add_curved_lights(all);
    add_lights_at_infinity(all);
    return all;
}

std::string probe_image() {
    constexpr std::size_t kWidth = 64, kHeight = 32;
    std::vector<float> pixels(kWidth * kHeight * 3);
    for (std::size_t y = 0; y < kHeight; ++y) {
        for (std::size_t x = 0; x < kWidth; ++x) {
            float* c = &pixels[(y * kWidth + x) * 3];
            const bool spot = x >= 10 && x < 14 && y >= 6 && y < 9;
            c[0] = spot ? 40.0f : 0.2f + 0.01f * static_cast<float>(x);
            c[1] = spot ? 30.0f : 0.3f;
            c[2] = spot ? 20.0f : 0.1f + 0.02f * static_cast<float>(y);
        }
    }
    std::string path = folder() / "light_probe.exr";
    const auto file = OIIO::ImageOutput::create(path);
    if (!file ||
        !file->open(path, OIIO::ImageSpec(int(kWidth), int(kHeight), 3, OIIO::TypeDesc::FLOAT)) ||
        !file->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) || !file->close())
        throw std::runtime_error("cannot write " + path);
    return path;
}

std::string wall_washer() {
    return folder().write("wall_washer.ies",
                          "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 4 5 1 2 0 0 0\n1 1 60\n"
                          "0 30 60 90\n0 90 180 270 360\n"
                          "60 100 80 10\n60 40 20 5\n60 10 5 4\n60 70 30 8\n60 100 80 10\n");
}

}  // namespace lxs::test
