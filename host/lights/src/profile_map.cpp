// The image of emission by direction that a light's statement names: mapname, iesname, flipz.
#include "profile_map.h"

#include <algorithm>

#include "photometric_file.h"

namespace lxs {
namespace {

/// Intensities of a luminaire relative to its largest.
LatLongMap photometric_map(const ParameterReader& reader, const AssetResolver& resolve) {
    constexpr std::size_t kWidth = 720, kHeight = 360;  // half a degree, finer than files measure
    const SourceLocation& where = reader.where("iesname");
    const PhotometricWeb web =
        read_photometric_file(resolve(reader.string("iesname", ""), where), where);
    const double scale = web.largest() > 0 ? 1 / web.largest() : 0;
    return LatLongMap::of(kWidth, kHeight, [&](const Vec2& st) {
        return Rgb(
            static_cast<float>(scale * web.intensity(180 * double(st.y), 360 * double(st.x))));
    });
}

}  // namespace

bool names_profile(const ParameterReader& reader) {
    return !reader.string("mapname", "").empty() || !reader.string("iesname", "").empty();
}

LatLongMap read_map(const ParameterReader& reader, const AssetResolver& resolve) {
    const SourceLocation& where = reader.where("mapname");
    return LatLongMap::read(resolve(reader.string("mapname", ""), where),
                            static_cast<float>(reader.number("gamma", 1)), where,
                            reader.diagnostics());
}

LatLongMap sphere_map(const ParameterReader& reader, const AssetResolver& resolve) {
    const bool image = !reader.string("mapname", "").empty();
    const bool web = !reader.string("iesname", "").empty();
    LatLongMap map = image ? read_map(reader, resolve) : photometric_map(reader, resolve);
    if (image && web) {
        const LatLongMap shape = photometric_map(reader, resolve);
        map = LatLongMap::of(std::max(map.width(), shape.width()),
                             std::max(map.height(), shape.height()),
                             [&](const Vec2& st) { return map.lookup(st) * shape.lookup(st); });
    }
    if (!reader.boolean("flipz", false)) return map;
    return LatLongMap::of(map.width(), map.height(),
                          [&](const Vec2& st) { return map.lookup(Vec2(st.x, 1 - st.y)); });
}

}  // namespace lxs
