// The image of emission by direction that a light's statement names: mapname, iesname, flipz.
#include "profile_map.h"

#include <algorithm>
#include <functional>

#include "environment_layout.h"
#include "photometric_file.h"

namespace lxs {
namespace {

using OverDirections = std::function<Rgb(const Vec2& st)>;

/// Intensities of a luminaire relative to its largest.
OverDirections photometric_intensity(const ParameterReader& reader, const AssetResolver& resolve) {
    const SourceLocation& where = reader.where("iesname");
    PhotometricWeb web = read_photometric_file(resolve(reader.string("iesname", ""), where), where);
    const double scale = web.largest() > 0 ? 1 / web.largest() : 0;
    return [web = std::move(web), scale](const Vec2& st) {
        return Rgb(
            static_cast<float>(scale * web.intensity(180 * double(st.y), 360 * double(st.x))));
    };
}

LatLongMap upright_map(const ParameterReader& reader, const AssetResolver& resolve) {
    constexpr std::size_t kWidth = 720, kHeight = 360;  // half a degree, finer than files measure
    const bool image = !reader.string("mapname", "").empty();
    if (reader.string("iesname", "").empty())
        return as_latlong(read_map(reader, resolve), reader.string("mapping", "latlong"));
    const OverDirections intensity = photometric_intensity(reader, resolve);
    if (!image) return LatLongMap::of(kWidth, kHeight, intensity);
    const LatLongMap map =
        as_latlong(read_map(reader, resolve), reader.string("mapping", "latlong"));
    return LatLongMap::of(std::max(map.width(), kWidth), std::max(map.height(), kHeight),
                          [&](const Vec2& st) { return map.lookup(st) * intensity(st); });
}

}  // namespace

bool names_profile(const ParameterReader& reader) {
    return !reader.string("mapname", "").empty() || !reader.string("iesname", "").empty();
}

StoredCurve map_curve(const ParameterReader& reader) {
    return {static_cast<float>(reader.number("gamma", 1)),
            reader.string("colorspace", "gamma") == "srgb"};
}

LatLongMap read_map(const ParameterReader& reader, const AssetResolver& resolve) {
    const SourceLocation& where = reader.where("mapname");
    LatLongMap map = LatLongMap::read(resolve(reader.string("mapname", ""), where),
                                      map_curve(reader), where, reader.diagnostics());
    return reader.boolean("plainvalues", false) ? map : map.filtering(Rgb(1.0f));
}

LatLongMap sphere_map(const ParameterReader& reader, const AssetResolver& resolve) {
    const LatLongMap map = upright_map(reader, resolve);
    return reader.boolean("flipz", false) ? map.upside_down() : map;
}

}  // namespace lxs
