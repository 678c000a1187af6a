// Debug views of guide=adaptive.
#include "layers/table_layers.h"

#include <algorithm>

#include "eye/surface_normals.h"
#include "layers/node_layers.h"

namespace aips {

TableLayers::TableLayers(Film& film) : film_(film) {
    const std::size_t pixels = std::size_t{film.width()} * film.height();
    regions_.resize(pixels);
    values_.resize(pixels);
}

void TableLayers::show(const EyeImage& image, std::span<const std::uint32_t> pixel_of_path,
                       const BounceTables& tables) {
    std::fill(regions_.begin(), regions_.end(), kNoGuideNode);
    std::fill(values_.begin(), values_.end(), 0.0f);
    for (const VisiblePoint& point : image.visible_points) {
        const Vec3 normal = normal_towards(point.wo, point);
        const std::uint32_t pixel = pixel_of_path[point.sample];
        regions_[pixel] = tables.region_at(point.position, normal);
        const BounceTable table = tables.at(point.position, normal);
        values_[pixel] = table.table ? table.share : 0;
    }
    film_.set_layer("tableshare", values_);
    find_node_edges(regions_, film_.width(), values_);
    film_.set_layer("tableedges", values_);
}

std::size_t TableLayers::memory_bytes() const {
    return regions_.capacity() * sizeof(std::uint32_t) + values_.capacity() * sizeof(float);
}

std::size_t TableLayers::memory_bound_bytes(std::size_t pixels) {
    return pixels * (sizeof(std::uint32_t) + sizeof(float));
}

}  // namespace aips
