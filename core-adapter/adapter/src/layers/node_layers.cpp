// Debug views of the guide's nodes.
#include "layers/node_layers.h"

#include <algorithm>
#include <limits>

namespace aips {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Errors may be as large as a double; a layer ends where float does.
float to_float(double value) {
    return float(std::min(value, double(std::numeric_limits<float>::max())));
}

}  // namespace

void find_node_edges(std::span<const std::uint32_t> nodes, std::size_t width,
                     std::span<float> edges) {
    std::fill(edges.begin(), edges.end(), 0.0f);
    const auto compare = [&](std::size_t a, std::size_t b) {
        if (nodes[a] == nodes[b] || nodes[a] == kNoGuideNode || nodes[b] == kNoGuideNode) return;
        edges[a] = edges[b] = 1;
    };
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if ((i + 1) % width != 0) compare(i, i + 1);
        if (i + width < nodes.size()) compare(i, i + width);
    }
}

NodeLayers::NodeLayers(Film& film, const Guide& guide) : film_(film), guide_(guide) {
    const std::size_t pixels = std::size_t{film.width()} * film.height();
    points_.assign(pixels, {kNaN, kNaN, kNaN});
    nodes_.resize(pixels);
    values_.resize(pixels);
}

void NodeLayers::find_nodes(const EyeImage& image, std::span<const std::uint32_t> pixel_of_path) {
    for (const VisiblePoint& point : image.visible_points) {
        points_[pixel_of_path[point.sample]] = point.position;
    }
    std::transform(points_.begin(), points_.end(), nodes_.begin(),
                   [&](Vec3 p) { return is_finite(p) ? guide_.node_at(p) : kNoGuideNode; });
}

template <class Value>
void NodeLayers::set_layer(std::string_view name, const Value& value) {
    std::transform(nodes_.begin(), nodes_.end(), values_.begin(), [&](std::uint32_t node) {
        return node == kNoGuideNode ? 0.0f : to_float(value(node));
    });
    film_.set_layer(name, values_);
}

void NodeLayers::show(const EyeImage& image, std::span<const std::uint32_t> pixel_of_path,
                      const BounceStatistics& bounces) {
    find_nodes(image, pixel_of_path);
    set_layer("nodeerror", [&](std::uint32_t node) { return guide_.node(node).error; });
    set_layer("nodeweight", [&](std::uint32_t node) { return guide_.node(node).weight; });
    set_layer("guidedshare", [&](std::uint32_t node) { return bounces.guided_share(node); });
    find_node_edges(nodes_, film_.width(), values_);
    film_.set_layer("nodeedges", values_);
}

// No point is refused: the guide has a node for each.
void NodeLayers::state(StateArchive& archive) {
    for (Vec3& point : points_) {
        for (float* coordinate : {&point.x, &point.y, &point.z})
            archive.value(*coordinate);
    }
}

std::size_t NodeLayers::memory_bytes() const {
    return points_.capacity() * sizeof(Vec3) + nodes_.capacity() * sizeof(std::uint32_t) +
           values_.capacity() * sizeof(float);
}

std::size_t NodeLayers::memory_bound_bytes(std::size_t pixels) {
    return pixels * (sizeof(Vec3) + sizeof(std::uint32_t) + sizeof(float));
}

}  // namespace aips
