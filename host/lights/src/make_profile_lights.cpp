// Makes lights at a point whose intensity follows an image or a photometric file.
#include "make_profile_lights.h"

#include <cmath>
#include <numbers>

#include "emission_profile.h"
#include "point_intensity.h"
#include "profile_light.h"
#include "profile_map.h"
#include "warp.h"

namespace lxs {
namespace {

void add(const LightStatement& s, std::string_view kind, const Rgb& unit,
         std::unique_ptr<const EmissionProfile> profile, Lights& lights) {
    const Rgb intensity = point_intensity(s, unit, luminance(unit * profile->integral()));
    lights.push_back(std::make_unique<ProfileLight>(
        s.placement(), kind, s.world_point(s.reader.vector("from", Vec3(0.0f))), intensity,
        std::move(profile)));
}

}  // namespace

void make_goniometric(const LightStatement& s, Lights& lights) {
    auto profile = std::make_unique<SphereProfile>(s.rotation(), sphere_map(s.reader, s.resolve));
    // As LuxRender: the profile tells where light goes, L how much there is.
    const Rgb sum = profile->integral();
    const float mean = (sum.x + sum.y + sum.z) / 3;
    const bool plain = s.reader.boolean("plainvalues", false);
    const Rgb unit = plain ? s.color() : mean > 0 ? s.color() * (4 * kPi / mean) : Rgb(0.0f);
    add(s, "goniometric", unit, std::move(profile), lights);
}

void make_projection(const LightStatement& s, Lights& lights) {
    const auto fov = static_cast<float>(s.reader.number("fov", 45) * std::numbers::pi / 180);
    const Vec3 axis = s.unit(Imath::V3d(s.reader.vector("to", Vec3(0, 0, 1))) -
                                 Imath::V3d(s.reader.vector("from", Vec3(0.0f))),
                             s.reader.given("to") ? "to" : "from");
    // The image's rows and columns as Pharr & Humphreys 2010, section 2.2.4, complete an axis.
    const Vec3 rows = std::abs(axis.x) > std::abs(axis.y) ? Vec3(-axis.z, 0, axis.x).normalized()
                                                          : Vec3(0, axis.z, -axis.y).normalized();
    const Rotation rotation = s.rotation();
    Frame axes(rotation.to_world(axis));
    axes.s = rotation.to_world(rows);
    axes.t = rotation.to_world(axis % rows);
    LatLongMap image = s.reader.string("mapname", "").empty() ? LatLongMap(1, 1, {Rgb(1.0f)})
                                                              : read_map(s.reader, s.resolve);
    add(s, "projection", s.color(),
        std::make_unique<ScreenProfile>(axes, std::move(image), fov,
                                        s.reader.boolean("plainvalues", false)),
        lights);
}

}  // namespace lxs
