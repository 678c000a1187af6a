// Makes the lights of emissive surfaces.
#include "area_lights.h"

#include <stdexcept>

namespace lxs {

void append_area_lights(const std::vector<Primitive>& primitives, const Matrix& instance_to_world,
                        std::vector<std::unique_ptr<Light>>& lights,
                        std::vector<const AreaLight*>& table, Diagnostics& diagnostics) {
    for (const Primitive& primitive : primitives) {
        if (!primitive.emission) continue;
        std::unique_ptr<Light> light = make_area_light(primitive, instance_to_world);
        const auto* area_light = dynamic_cast<const AreaLight*>(light.get());
        if (!area_light) throw std::logic_error("make_area_light made no AreaLight");
        if (!area_light->has_area()) {
            diagnostics.warning(primitive.where,
                                "an area light needs a shape of non-zero, finite area: this one "
                                "stays dark");
        }
        table.push_back(area_light);
        lights.push_back(std::move(light));
    }
}

}  // namespace lxs
