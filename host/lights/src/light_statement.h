// A light's scene statement in the terms in which lights are made.
#pragma once

#include <fmt/format.h>

#include <cmath>

#include "emitted_radiance.h"
#include "lxs/lights/lights.h"
#include "lxs/spectrum/rgb_spectra.h"
#include "rotation.h"

namespace lxs {

/// One light statement while its lights are made.
struct LightStatement {
    const ParameterReader& reader;
    const LightDescription& description;
    const SceneSphere& sphere;
    const AssetResolver& resolve;

    LightPlacement placement() const {
        return {description.group, description.hidden || reader.boolean("hidden", false)};
    }
    float number(std::string_view name, double fallback) const {
        return static_cast<float>(reader.number(name, fallback));
    }
    /// L, by whatever name.
    Rgb given_color() const { return cleaned(reader.color("L", Rgb(1.0f)), reader.spelling("L")); }
    /// The colour of the light that L stands for.
    Rgb color() const { return colour_of_illuminant(given_color()); }
    /// That times gain.
    Rgb emission() const { return cleaned(color() * number("gain", 1), "gain"); }
    /// `value` without what is not finite or negative, of which a warning at parameter `name` says.
    Rgb cleaned(const Rgb& value, std::string_view name) const {
        const Rgb usable = non_negative(value);
        if (!(usable == value)) {
            reader.diagnostics().warning(
                reader.given(name) ? reader.where(name) : reader.where(),
                fmt::format("\"{}\" makes the light's colour ({} {} {}): what is not finite or "
                            "negative is taken for 0",
                            name, value.x, value.y, value.z));
        }
        return usable;
    }
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

}  // namespace lxs
