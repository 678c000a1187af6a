// Makes lights without geometry from their scene statements.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "directional_light.h"
#include "emitted_radiance.h"
#include "infinite_light.h"
#include "lxs/lights/lights.h"
#include "point_light.h"
#include "sky_light.h"
#include "solar_spectrum.h"

namespace lxs {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

using Lights = std::vector<std::unique_ptr<Light>>;

/// One light statement while its lights are made.
struct Statement {
    const ParameterReader& reader;
    const LightDescription& description;
    const SceneSphere& sphere;
    const AssetResolver& resolve;

    LightPlacement placement() const { return {description.group, description.medium}; }
    float number(std::string_view name, double fallback) const {
        return static_cast<float>(reader.number(name, fallback));
    }
    Rgb color(std::string_view name) const { return non_negative(reader.color(name, Rgb(1.0f))); }
    /// L times gain.
    Rgb emission() const { return non_negative(color("L") * number("gain", 1)); }
    Vec3 world_point(const Vec3& p) const {
        Imath::V3d q;
        description.to_world.multVecMatrix(Imath::V3d(p), q);
        return Vec3(q);
    }
    /// Unit direction of a non-zero vector in world space; throws at the parameter `name`.
    Vec3 unit(const Imath::V3d& v, std::string_view name) const {
        const double length = v.length();
        if (!(length > 0) || !std::isfinite(length))
            reader.fail(name, fmt::format("\"{}\" gives the light no direction", name));
        return Vec3(v / length);
    }
    Vec3 from_to_direction() const {
        const Vec3 from = world_point(reader.vector("from", Vec3(0.0f)));
        const Vec3 to = world_point(reader.vector("to", Vec3(0, 0, 1)));
        return unit(Imath::V3d(to) - Imath::V3d(from), reader.given("to") ? "to" : "from");
    }
    Rotation rotation() const { return Rotation(description.to_world, reader.where()); }
};

/// Intensity of a light at a point whose falloff integrates to `solid_angle`: `color` times gain,
/// or gain times the flux that power and efficacy ask for.
Rgb intensity(const Statement& s, const Rgb& color, double solid_angle) {
    const double lumens = s.number("power", 0) * s.number("efficacy", 0);
    const double unscaled = luminance(color);
    if (!(lumens > 0) || !(unscaled > 0)) return color * s.number("gain", 1);
    return color * static_cast<float>(s.number("gain", 1) * lumens / (unscaled * solid_angle));
}

void make_point(const Statement& s, Lights& lights) {
    const Vec3 position = s.world_point(s.reader.vector("from", Vec3(0.0f)));
    lights.push_back(std::make_unique<PointLight>(
        s.placement(), position, intensity(s, s.color("L"), 4 * std::numbers::pi)));
}

void make_unrendered_profile(const Statement& s, Lights& lights) {
    s.reader.diagnostics().warning(
        s.reader.where(),
        fmt::format("light \"{}\" is rendered as a point light, its image is left out",
                    s.reader.plugin()));
    const std::string_view color = s.reader.given("I") ? "I" : "L";
    lights.push_back(std::make_unique<PointLight>(
        s.placement(), s.world_point(s.reader.vector("from", Vec3(0.0f))),
        intensity(s, s.color(color), 4 * std::numbers::pi)));
}

void make_spot(const Statement& s, Lights& lights) {
    const double outer = s.reader.number("coneangle", 30);
    if (!(outer > 0)) s.reader.fail("coneangle", "a spot light needs a cone angle above 0");
    const double inner = std::max(0.0, outer - s.reader.number("conedeltaangle", 5));
    const SpotCone cone{static_cast<float>(inner * kRadians), static_cast<float>(outer * kRadians)};
    const Vec3 axis = s.from_to_direction();
    const SpotLight unit(s.placement(), Vec3(0.0f), axis, Rgb(1.0f), cone);
    lights.push_back(std::make_unique<SpotLight>(
        s.placement(), s.world_point(s.reader.vector("from", Vec3(0.0f))), axis,
        intensity(s, s.color("L"), unit.power()), cone));
}

void make_distant(const Statement& s, Lights& lights) {
    // LuxRender 1.9 takes a theta of 0 as a cone of 1 - cosine 4.8e-5, and its irradiance is
    // L / (2 (1 - cosine)): measured, its distant light of L = 2 gives 20840 lx.
    constexpr double kParallel = 4.8e-5;
    constexpr double kLeastAngle = 1e-5;  // radians; below it the disk has no size in float
    const Vec3 wi = -s.from_to_direction();
    const double theta = s.reader.number("theta", 0) * kRadians;
    const bool parallel = theta < kLeastAngle;
    const double one_minus_cos = parallel ? kParallel : 1 - std::cos(theta);
    const Rgb irradiance = s.emission() / static_cast<float>(2 * one_minus_cos);
    if (parallel) {
        lights.push_back(std::make_unique<ParallelLight>(s.placement(), s.sphere, wi, irradiance));
        return;
    }
    const float sin_max = static_cast<float>(std::sin(theta));
    lights.push_back(std::make_unique<ConeLight>(s.placement(), "distant", s.sphere, wi, sin_max,
                                                 irradiance / ConeLight::solid_angle(sin_max)));
}

void make_infinite(const Statement& s, Lights& lights) {
    const std::string name = s.reader.string("mapname", "");
    if (name.empty()) {
        lights.push_back(
            std::make_unique<ConstantEnvironment>(s.placement(), s.sphere, s.emission()));
        return;
    }
    const std::string mapping = s.reader.string("mapping", "latlong");
    if (mapping != "latlong") {
        s.reader.diagnostics().warning(
            s.reader.where("mapping"),
            fmt::format("mapping \"{}\" is not rendered, the image is read as latlong", mapping));
    }
    const SourceLocation& where = s.reader.where("mapname");
    LatLongMap map = LatLongMap::read(s.resolve(name, where), s.number("gamma", 1), where);
    lights.push_back(std::make_unique<MappedEnvironment>(s.placement(), s.sphere, s.rotation(),
                                                         std::move(map), s.emission()));
}

Vec3 sun_direction(const Statement& s) {
    return s.unit(Imath::V3d(s.reader.vector("sundir", Vec3(0, 0, 1))), "sundir");
}

void make_sun(const Statement& s, Lights& lights) {
    // Radius of the sun over its mean distance (NASA planetary fact sheet).
    constexpr double kSineOfRadius = 695500.0 / 149600000.0;
    const Vec3 sun = sun_direction(s);
    const double size = s.reader.number("relsize", 1);
    const double turbidity = s.reader.number("turbidity", 2);
    const Rgb radiance = sun_radiance(sun.z, turbidity) * s.number("gain", 1);
    if (is_black(radiance) && sun.z <= 0) {
        s.reader.diagnostics().warning(s.reader.where("sundir"),
                                       "the sun stands below the horizon and sends no light");
    }
    lights.push_back(std::make_unique<ConeLight>(
        s.placement(), "sun", s.sphere, s.rotation().to_world(sun),
        static_cast<float>(std::min(1.0, size * kSineOfRadius)), radiance));
}

/// LuxRender 1.9's images over those of the published models, measured with the sun 40 to 50
/// degrees high: its sky is brighter than Preetham's by 8 % (turbidity 3) to 14 % (2.2), its sky2
/// darker.
constexpr float kSkyScale = 1.11f;
constexpr float kSky2Scale = 0.57f;

void make_sky(const Statement& s, Lights& lights, float scale) {
    const auto factor = [&s](std::string_view name, std::string_view old_name) {
        return s.reader.number(name, s.reader.number(old_name, 1));
    };
    double turbidity = s.reader.number("turbidity", 2);
    if (turbidity < SkyModel::kLeastTurbidity) {
        turbidity = SkyModel::kLeastTurbidity;
        s.reader.diagnostics().warning(
            s.reader.where("turbidity"),
            fmt::format("the sky is rendered with turbidity {}, its model's least", turbidity));
    }
    const SkyModel model(sun_direction(s), turbidity,
                         {factor("horizonbrightness", "aconst"), factor("horizonsize", "bconst"),
                          factor("sunhalobrightness", "cconst"), factor("sunhalosize", "dconst"),
                          factor("backscattering", "econst")});
    lights.push_back(std::make_unique<SkyLight>(s.placement(), s.sphere, s.rotation(), model,
                                                s.number("gain", 1) * scale));
}

void warn_of_preetham(const Statement& s) {
    s.reader.diagnostics().warning(
        s.reader.where(),
        fmt::format("light \"{}\" is rendered with the Preetham sky in place of the "
                    "Hosek-Wilkie sky",
                    s.reader.plugin()));
}

void make_by_name(const Statement& s, Lights& lights) {
    const std::string& name = s.reader.plugin();
    if (name == "point") return make_point(s, lights);
    if (name == "spot") return make_spot(s, lights);
    if (name == "distant") return make_distant(s, lights);
    if (name == "infinite" || name == "infinitesample") return make_infinite(s, lights);
    if (name == "goniometric" || name == "projection") return make_unrendered_profile(s, lights);
    const bool second = name == "sky2" || name == "sunsky2";
    if (second) warn_of_preetham(s);
    if (name != "sky" && name != "sky2") make_sun(s, lights);
    if (name != "sun") make_sky(s, lights, second ? kSky2Scale : kSkyScale);
}

std::string known_names() {
    std::string names;
    for (const LightPlugin& plugin : light_plugins())
        names += (names.empty() ? "" : ", ") + plugin.name;
    return names;
}

}  // namespace

Lights make_lights(const LightDescription& description, const SceneSphere& sphere,
                   const AssetResolver& resolve, Diagnostics& diagnostics) {
    const std::vector<LightPlugin>& plugins = light_plugins();
    const std::string& name = description.parameters.plugin;
    const auto plugin = std::find_if(plugins.begin(), plugins.end(),
                                     [&](const LightPlugin& p) { return p.name == name; });
    if (plugin == plugins.end()) {
        throw InputError(
            description.parameters.where,
            fmt::format("unknown light source \"{}\"; known: {}", name, known_names()));
    }
    const ParameterReader reader(description.parameters, plugin->parameters, diagnostics);
    Lights lights;
    make_by_name({reader, description, sphere, resolve}, lights);
    return lights;
}

}  // namespace lxs
