// Makes lights at a point whose intensity follows an image or a photometric file.
#include "make_profile_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "emission_profile.h"
#include "photometric_file.h"
#include "point_intensity.h"
#include "profile_light.h"

namespace lxs {
namespace {

LatLongMap read_map(const LightStatement& s) {
    const SourceLocation& where = s.reader.where("mapname");
    return LatLongMap::read(s.resolve(s.reader.string("mapname", ""), where), s.number("gamma", 1),
                            where, s.reader.diagnostics());
}

/// Intensities of a luminaire relative to its largest; vertical angle 0 along +z.
LatLongMap photometric_map(const LightStatement& s) {
    constexpr std::size_t kWidth = 720, kHeight = 360;  // half a degree, finer than files measure
    const SourceLocation& where = s.reader.where("iesname");
    const PhotometricWeb web =
        read_photometric_file(s.resolve(s.reader.string("iesname", ""), where), where);
    const double scale = web.largest() > 0 ? 1 / web.largest() : 0;
    return LatLongMap::of(kWidth, kHeight, [&](const Vec2& st) {
        return Rgb(
            static_cast<float>(scale * web.intensity(180 * double(st.y), 360 * double(st.x))));
    });
}

LatLongMap sphere_map(const LightStatement& s) {
    const bool image = !s.reader.string("mapname", "").empty();
    const bool web = !s.reader.string("iesname", "").empty();
    LatLongMap map = image ? read_map(s) : photometric_map(s);
    if (image && web) {
        const LatLongMap shape = photometric_map(s);
        map = LatLongMap::of(std::max(map.width(), shape.width()),
                             std::max(map.height(), shape.height()),
                             [&](const Vec2& st) { return map.lookup(st) * shape.lookup(st); });
    }
    if (!s.reader.boolean("flipz", false)) return map;
    return LatLongMap::of(map.width(), map.height(),
                          [&](const Vec2& st) { return map.lookup(Vec2(st.x, 1 - st.y)); });
}

void add(const LightStatement& s, std::string_view kind, std::string_view color,
         std::unique_ptr<const EmissionProfile> profile, Lights& lights) {
    const Rgb unit = s.color(color);
    const Rgb intensity = point_intensity(s, unit, luminance(unit * profile->integral()));
    lights.push_back(std::make_unique<ProfileLight>(
        s.placement(), kind, s.world_point(s.reader.vector("from", Vec3(0.0f))), intensity,
        std::move(profile)));
}

}  // namespace

bool has_profile(const LightStatement& s) {
    return !s.reader.string("mapname", "").empty() || !s.reader.string("iesname", "").empty();
}

void make_goniometric(const LightStatement& s, std::string_view color, Lights& lights) {
    add(s, "goniometric", color, std::make_unique<SphereProfile>(s.rotation(), sphere_map(s)),
        lights);
}

void make_projection(const LightStatement& s, std::string_view color, Lights& lights) {
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
    constexpr std::size_t kBlank = 64;  // fine enough to follow the solid angle of its pixels
    LatLongMap image = s.reader.string("mapname", "").empty()
                           ? LatLongMap::of(kBlank, kBlank, [](const Vec2&) { return Rgb(1.0f); })
                           : read_map(s);
    add(s, "projection", color, std::make_unique<ScreenProfile>(axes, std::move(image), fov),
        lights);
}

}  // namespace lxs
