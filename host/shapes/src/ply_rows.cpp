// Places of values in rows of one length.
#include "ply_rows.h"

#include <algorithm>

namespace lxs {

PlyRows::PlyRows(const PlyElement& element, const char* first, PlyFormat format,
                 std::size_t list_length)
    : first_(first), format_(format), count_(element.count) {
    for (const PlyProperty& property : element.properties) {
        const PlyType type = property.is_list ? property.count_type : property.type;
        columns_.push_back({row_bytes_, type, property.type});
        row_bytes_ += size_of(type);
        if (property.is_list) row_bytes_ += list_length * size_of(property.type);
    }
}

std::optional<PlyRows> equal_rows(const PlyElement& element, const PlyValues& values,
                                  std::size_t list_length) {
    if (values.format() == PlyFormat::Ascii) return std::nullopt;
    const auto lists = std::ranges::count_if(element.properties, &PlyProperty::is_list);
    if (lists != (list_length > 0 ? 1 : 0)) return std::nullopt;
    const PlyRows one({element.name, 1, element.properties}, nullptr, values.format(), list_length);
    if (element.count > values.bytes_left() / one.bytes()) return std::nullopt;
    return PlyRows(element, values.ahead(), values.format(), list_length);
}

}  // namespace lxs
