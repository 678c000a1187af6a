// Makes the sun and the sky from their scene statements.
#include "make_sky_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "directional_light.h"
#include "sky_light.h"
#include "solar_spectrum.h"

namespace lxs {
namespace {

Vec3 sun_direction(const LightStatement& s) {
    return s.unit(Imath::V3d(s.reader.vector("sundir", Vec3(0, 0, 1))), "sundir");
}

void make_sun(const LightStatement& s, Lights& lights) {
    // Radius of the sun over its mean distance (NASA planetary fact sheet).
    constexpr double kSineOfRadius = 695500.0 / 149600000.0;
    const Vec3 sun = sun_direction(s);
    const double size = s.reader.number("relsize", 1);
    const double turbidity = s.reader.number("turbidity", 2);
    // As LuxRender: the air that the light passes is that of the sun's height in the world, and the
    // disk grows dimmer as it grows larger.
    const Vec3 in_world = s.rotation().to_world(sun);
    const Rgb radiance = sun_radiance(in_world.z, turbidity) *
                         static_cast<float>(s.number("gain", 1) / (size * size));
    if (is_black(radiance) && in_world.z < 0) {
        s.reader.diagnostics().warning(s.reader.where("sundir"),
                                       "the sun stands below the horizon and sends no light");
    }
    lights.push_back(std::make_unique<ConeLight>(
        s.placement(), "sun", s.sphere, in_world,
        static_cast<float>(std::min(1.0, size * kSineOfRadius)), radiance));
}

/// The sky's models take the sun's direction as it is given, of any length: LuxRender 1.9 does not
/// normalise it there (it does for the sun's disk, and for its height in the Preetham sky). A
/// vector longer than 1, as in light-sky, brightens the sun's side. Scenes whose sundir is a unit
/// vector, as exporters write it, are the published models' skies.
Vec3 given_sun_direction(const LightStatement& s) {
    sun_direction(s);  // refuses the zero vector
    return s.reader.vector("sundir", Vec3(0, 0, 1));
}

double turbidity_within(const LightStatement& s, double least, double most) {
    const double given = s.reader.number("turbidity", 2);
    const double used = std::clamp(given, least, most);
    if (used != given) {
        s.reader.diagnostics().warning(
            s.reader.where("turbidity"),
            fmt::format("the sky is rendered with turbidity {}, its model's {}", used,
                        given < least ? "least" : "most"));
    }
    return used;
}

SkyModel preetham_sky(const LightStatement& s) {
    const auto factor = [&s](std::string_view name) { return s.reader.number(name, 1); };
    constexpr double kNoMost = std::numeric_limits<double>::infinity();
    return {given_sun_direction(s),
            turbidity_within(s, SkyModel::kLeastTurbidity, kNoMost),
            {factor("horizonbrightness"), factor("horizonsize"), factor("sunhalobrightness"),
             factor("sunhalosize"), factor("backscattering")}};
}

HosekWilkieSky hosek_wilkie_sky(const LightStatement& s) {
    return {given_sun_direction(s),
            turbidity_within(s, HosekWilkieSky::kLeastTurbidity, HosekWilkieSky::kMostTurbidity)};
}

void make_sky(const LightStatement& s, Lights& lights, const AnySky& sky) {
    lights.push_back(std::make_unique<SkyLight>(s.placement(), s.sphere, s.rotation(), sky,
                                                s.number("gain", 1)));
}

}  // namespace

void make_sky_lights(const LightStatement& s, Lights& lights) {
    const std::string& name = s.reader.plugin();
    if (name != "sky" && name != "sky2") make_sun(s, lights);
    if (name == "sky" || name == "sunsky") make_sky(s, lights, preetham_sky(s));
    if (name == "sky2" || name == "sunsky2") make_sky(s, lights, hosek_wilkie_sky(s));
}

}  // namespace lxs
