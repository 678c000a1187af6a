// AreaLightSource "area".
#include "area_emission.h"

#include <algorithm>

#include "lxs/language/read_scene.h"
#include "lxs/lights/lights.h"
#include "lxs/scene/constant_texture.h"

namespace lxs {

AreaEmission make_area_emission(const ParameterSet& set, const AssetContext& assets,
                                Diagnostics& diagnostics) {
    if (set.plugin != "area") {
        throw InputError(set.where,
                         unknown_name_message("area light", set.plugin,
                                              known_plugin_names().at("AreaLightSource")));
    }
    const ParameterReader parameters(set, area_light_parameters(), diagnostics);
    AreaEmission emission;
    if (const auto texture = parameters.texture_name("L")) {
        emission.radiance = assets.color_texture(*texture, parameters.where("L"));
        emission.radiance_texture = *texture;
    }
    if (!emission.radiance) {
        const Rgb radiance = parameters.color("L", Rgb(1.0f));
        if (std::min({radiance.x, radiance.y, radiance.z}) < 0) {
            parameters.fail("L", "an area light's L must not be negative");
        }
        emission.radiance = std::make_shared<ConstantTexture<Rgb>>(radiance);
    }
    emission.gain = static_cast<float>(parameters.number("gain", emission.gain));
    // LuxRender's defaults: a lamp of 100 W at 17 lm/W unless the scene sets both to 0.
    emission.power = static_cast<float>(parameters.number("power", 100));
    emission.efficacy = static_cast<float>(parameters.number("efficacy", 17));
    emission.profile =
        read_area_profile(parameters, [&](const std::string& name, const SourceLocation& where) {
            return assets.resolve(name, where);
        });
    emission.hidden = parameters.boolean("hidden", false);
    emission.where = set.where;
    return emission;
}

}  // namespace lxs
