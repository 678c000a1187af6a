// Makes the sun and the sky from their scene statements.
#include "make_sky_lights.h"

#include <fmt/format.h>

#include <algorithm>

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

void make_sky(const LightStatement& s, Lights& lights, float scale) {
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

void warn_of_preetham(const LightStatement& s) {
    s.reader.diagnostics().warning(
        s.reader.where(),
        fmt::format("light \"{}\" is rendered with the Preetham sky in place of the "
                    "Hosek-Wilkie sky",
                    s.reader.plugin()));
}

}  // namespace

void make_sky_lights(const LightStatement& s, Lights& lights) {
    const std::string& name = s.reader.plugin();
    const bool second = name == "sky2" || name == "sunsky2";
    if (second) warn_of_preetham(s);
    if (name != "sky" && name != "sky2") make_sun(s, lights);
    if (name != "sun") make_sky(s, lights, second ? kSky2Scale : kSkyScale);
}

}  // namespace lxs
