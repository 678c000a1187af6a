// Makes lights without geometry from their scene statements; sun and sky: make_sky_lights.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "directional_light.h"
#include "environment_layout.h"
#include "infinite_light.h"
#include "light_statement.h"
#include "lxs/scene/registry.h"
#include "make_profile_lights.h"
#include "make_sky_lights.h"
#include "point_intensity.h"
#include "point_light.h"
#include "profile_map.h"

namespace lxs {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

void make_point(const LightStatement& s, Lights& lights) {
    if (names_profile(s.reader)) return make_goniometric(s, lights);
    const Rgb unit = s.color();
    lights.push_back(std::make_unique<PointLight>(
        s.placement(), s.world_point(s.reader.vector("from", Vec3(0.0f))),
        point_intensity(s, unit, 4 * std::numbers::pi * luminance(unit))));
}

void make_spot(const LightStatement& s, Lights& lights) {
    const double outer = s.reader.number("coneangle", 30);
    if (!(outer > 0)) s.reader.fail("coneangle", "a spot light needs a cone angle above 0");
    const double inner = std::max(0.0, outer - s.reader.number("conedeltaangle", 5));
    const SpotCone cone{static_cast<float>(inner * kRadians), static_cast<float>(outer * kRadians),
                        s.reader.string("falloff", "fourthpower") == "smoothstep"};
    const Vec3 axis = s.from_to_direction();
    const Rgb color = s.color();
    // LuxRender 1.9 rates the cone's rim as half lit; its falloff passes a fifth.
    const double rated = 2 - std::cos(cone.inner) - std::cos(cone.outer);
    lights.push_back(std::make_unique<SpotLight>(
        s.placement(), s.world_point(s.reader.vector("from", Vec3(0.0f))), axis,
        point_intensity(s, color, std::numbers::pi * rated * luminance(color)), cone));
}

void make_distant(const LightStatement& s, Lights& lights) {
    // The irradiance is L over the cone's solid angle; LuxRender 1.9 takes a theta of 0 as a cone
    // of 1 - cosine = 2^-16. Measured, its distant light of L = 2 gives 20840 lx.
    constexpr double kParallel = 0x1p-16;
    constexpr double kLeastAngle = 1e-5;  // radians; below it the disk has no size in float
    const Vec3 wi = -s.from_to_direction();
    const double theta = s.reader.number("theta", 0) * kRadians;
    const bool parallel = theta < kLeastAngle;
    const double one_minus_cos = parallel ? kParallel : 1 - std::cos(theta);
    const Rgb irradiance = s.emission() / static_cast<float>(2 * std::numbers::pi * one_minus_cos);
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
    const SourceLocation& where = s.reader.where("mapname");
    LatLongMap map = as_latlong(LatLongMap::read(s.resolve(name, where), map_curve(s.reader), where,
                                                 s.reader.diagnostics()),
                                s.reader.string("mapping", "latlong"));
    Rgb gain = s.cleaned(Rgb(s.number("gain", 1)), "gain");
    if (s.reader.boolean("plaincolors", false)) {
        gain *= s.color();
    } else {
        map = map.filtering(s.given_color());
    }
    if (const double wanted = s.number("illuminance", 0); wanted > 0) {
        const double found = luminance(map.irradiance());
        if (found > 0) gain = s.cleaned(gain * static_cast<float>(wanted / found), "illuminance");
    }
    lights.push_back(std::make_unique<MappedEnvironment>(s.placement(), s.sphere, s.rotation(),
                                                         std::move(map), gain));
}

void make_by_name(const LightStatement& s, Lights& lights) {
    const std::string& name = s.reader.plugin();
    if (name == "point" || name == "goniometric") return make_point(s, lights);
    if (name == "spot") return make_spot(s, lights);
    if (name == "distant") return make_distant(s, lights);
    if (name == "infinite" || name == "infinitesample") return make_infinite(s, lights);
    if (name == "projection") return make_projection(s, lights);
    make_sky_lights(s, lights);
}

bool declares(const LightPlugin& plugin, std::string_view name) {
    return std::any_of(plugin.parameters.begin(), plugin.parameters.end(),
                       [&](const ParameterDeclaration& d) { return d.name == name; });
}

constexpr const char* kShinesWithout = "the light shines without it";

/// Passes on each message once, although a statement is read again.
class ToldOnce final : public Diagnostics {
  public:
    explicit ToldOnce(Diagnostics& next) : next_(next) {}
    void warning(const SourceLocation& where, const std::string& message) override {
        if (is_new(where, message)) next_.warning(where, message);
    }
    void unknown_parameter(const SourceLocation& where, const std::string& message) override {
        if (is_new(where, message)) next_.unknown_parameter(where, message);
    }
    void fallback(const SourceLocation& where, const std::string& message,
                  const std::string& instead) override {
        if (is_new(where, message)) next_.fallback(where, message, instead);
    }
    void error(const InputError& error) override {
        if (is_new(error.where(), error.message())) next_.error(error);
    }

  private:
    bool is_new(const SourceLocation& where, const std::string& message) {
        return told_.emplace(where.line, where.column, message).second;
    }

    Diagnostics& next_;
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::string>> told_;
};

/// A resolver that asks `resolve` once for each name.
AssetResolver remembering(const AssetResolver& resolve) {
    return [&resolve, paths = std::make_shared<std::map<std::string, std::string>>()](
               const std::string& name, const SourceLocation& where) {
        const auto known = paths->find(name);
        if (known != paths->end()) return known->second;
        return paths->emplace(name, resolve(name, where)).first->second;
    };
}

bool is_file_parameter(const ParameterValue& value, const LightPlugin& plugin) {
    return (value.name == "mapname" || value.name == "iesname") && declares(plugin, value.name);
}

/// Whether the light can do with a value: one that names a missing file is reported.
bool has_file(const ParameterValue& value, const AssetResolver& resolve, Diagnostics& diagnostics) {
    const auto* names = std::get_if<std::vector<std::string>>(&value.values);
    if (!names || names->size() != 1 || names->front().empty()) return true;
    try {
        resolve(names->front(), value.where);
        return true;
    } catch (const InputError& error) {
        diagnostics.fallback(error.where(), error.message(), kShinesWithout);
        return false;
    }
}

/// Leaves out images and photometric files that are missing.
void drop_missing_files(LightDescription& description, const LightPlugin& plugin,
                        const AssetResolver& resolve, Diagnostics& diagnostics) {
    std::erase_if(description.parameters.values, [&](const ParameterValue& value) {
        return is_file_parameter(value, plugin) && !has_file(value, resolve, diagnostics);
    });
}

/// Leaves out the image or photometric file that is given at `where`; false if there is none.
bool drop_file_at(const SourceLocation& where, LightDescription& description,
                  const LightPlugin& plugin) {
    return std::erase_if(description.parameters.values, [&](const ParameterValue& value) {
               return is_file_parameter(value, plugin) && value.where.line == where.line &&
                      value.where.column == where.column;
           }) > 0;
}

/// The lights of a statement, without files that are damaged: LuxRender's shine without them.
Lights make_without_damaged_files(LightDescription description, const LightPlugin& plugin,
                                  const SceneSphere& sphere, const AssetResolver& resolve,
                                  Diagnostics& diagnostics) {
    for (;;) {
        try {
            const ParameterReader reader(description.parameters, plugin.parameters, diagnostics);
            Lights lights;
            make_by_name({reader, description, sphere, resolve}, lights);
            return lights;
        } catch (const EndOfReading&) {
            throw;
        } catch (const InputError& error) {
            if (!drop_file_at(error.where(), description, plugin)) throw;
            diagnostics.fallback(error.where(), error.message(), kShinesWithout);
        }
    }
}

std::vector<std::string> known_names() {
    std::vector<std::string> names;
    for (const LightPlugin& plugin : light_plugins())
        names.push_back(plugin.name);
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
        throw InputError(description.parameters.where,
                         unknown_name_message("light source", name, known_names()));
    }
    ToldOnce told_once(diagnostics);
    const AssetResolver remembered = remembering(resolve);
    LightDescription usable = description;
    drop_missing_files(usable, *plugin, remembered, told_once);
    return make_without_damaged_files(std::move(usable), *plugin, sphere, remembered, told_once);
}

}  // namespace lxs
