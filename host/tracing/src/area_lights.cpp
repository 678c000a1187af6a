// Makes the lights of emissive surfaces.
#include "area_lights.h"

namespace lxs {

void append_area_lights(const std::vector<Primitive>& primitives, const Matrix& instance_to_world,
                        std::vector<std::unique_ptr<PlacedLight>>& lights,
                        std::vector<const AreaLight*>& table, Diagnostics& diagnostics) {
    for (const Primitive& primitive : primitives) {
        if (!primitive.emission) continue;
        std::unique_ptr<AreaLight> light = make_area_light(primitive, instance_to_world);
        if (!light->has_area()) {
            diagnostics.warning(primitive.where,
                                "an area light needs a shape of non-zero, finite area: this one "
                                "stays dark");
        }
        table.push_back(light.get());
        lights.push_back(std::move(light));
    }
}

}  // namespace lxs
