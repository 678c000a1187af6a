// Makes lights without geometry from their scene statements; sun and sky: make_sky_lights.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "directional_light.h"
#include "infinite_light.h"
#include "light_statement.h"
#include "make_sky_lights.h"
#include "point_light.h"

namespace lxs {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

/// Intensity of a light at a point whose falloff integrates to `solid_angle`: `color` times gain,
/// or gain times the flux that power and efficacy ask for.
Rgb intensity(const LightStatement& s, const Rgb& color, double solid_angle) {
    const double lumens = s.number("power", 0) * s.number("efficacy", 0);
    const double unscaled = luminance(color);
    if (!(lumens > 0) || !(unscaled > 0)) return color * s.number("gain", 1);
    return color * static_cast<float>(s.number("gain", 1) * lumens / (unscaled * solid_angle));
}

void make_point(const LightStatement& s, std::string_view color, Lights& lights) {
    const Vec3 position = s.world_point(s.reader.vector("from", Vec3(0.0f)));
    lights.push_back(std::make_unique<PointLight>(
        s.placement(), position, intensity(s, s.color(color), 4 * std::numbers::pi)));
}

void make_unrendered_profile(const LightStatement& s, Lights& lights) {
    s.reader.diagnostics().warning(
        s.reader.where(),
        fmt::format("light \"{}\" is rendered as a point light, its image is left out",
                    s.reader.plugin()));
    make_point(s, s.reader.given("I") ? "I" : "L", lights);
}

void make_spot(const LightStatement& s, Lights& lights) {
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

void make_distant(const LightStatement& s, Lights& lights) {
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

void make_infinite(const LightStatement& s, Lights& lights) {
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

void make_by_name(const LightStatement& s, Lights& lights) {
    const std::string& name = s.reader.plugin();
    if (name == "point") return make_point(s, "L", lights);
    if (name == "spot") return make_spot(s, lights);
    if (name == "distant") return make_distant(s, lights);
    if (name == "infinite" || name == "infinitesample") return make_infinite(s, lights);
    if (name == "goniometric" || name == "projection") return make_unrendered_profile(s, lights);
    make_sky_lights(s, lights);
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
