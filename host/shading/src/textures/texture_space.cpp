// The space of a texture.
#include "texture_space.h"

#include <cmath>
#include <stdexcept>

namespace lxs::shading {

Imath::M44f inverse_or_fail(const ParameterReader& reader, std::string_view name,
                            const Matrix& to_world) {
    try {
        const Imath::M44f inverse(to_world.inverse(true));
        bool finite = true;
        for (int i = 0; i < 16; ++i)
            finite = finite && std::isfinite(inverse.getValue()[i]);
        if (finite) return inverse;
    } catch (const std::invalid_argument&) {
        // Reported below, as an inverse that overflows is.
    }
    reader.fail(name, reader.plugin() + ": the transform in force cannot be inverted");
}

}  // namespace lxs::shading
