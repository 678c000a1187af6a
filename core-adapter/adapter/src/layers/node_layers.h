// Debug views of the guide's kd-tree, at the surfaces that the pixels show.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "aips/adapter/camera.h"
#include "aips/adapter/guide.h"
#include "eye/eye_pass.h"
#include "photons/bounce_statistics.h"

namespace aips {

/// Node number of a pixel that has no visible point.
inline constexpr std::uint32_t kNoGuideNode = 0xFFFFFFFFu;

/// 1 where one of the four neighbours in an image of nodes (row by row) has another node, else 0;
/// pixels without a node are 0 and no neighbours.
void find_node_edges(std::span<const std::uint32_t> nodes, std::size_t width,
                     std::span<float> edges);

/// Layers nodeerror, nodeweight, nodeedges and guidedshare of docs/reference/layers.md: the state
/// of the guide after the last pass, at each pixel's latest visible point.
class NodeLayers {
  public:
    /// Both outlive the layers.
    NodeLayers(Film& film, const Guide& guide);

    /// Replaces the layers after a pass; `pixel_of_path` is the pixel of each of its eye paths.
    void show(const EyeImage& image, std::span<const std::uint32_t> pixel_of_path,
              const BounceStatistics& bounces);

    /// Saves the pixels' latest visible points, or restores them.
    void state(StateArchive& archive);

    std::size_t memory_bytes() const;
    static std::size_t memory_bound_bytes(std::size_t pixels);

  private:
    void find_nodes(const EyeImage& image, std::span<const std::uint32_t> pixel_of_path);
    /// Sets a layer to `value(node)`, 0 where there is none.
    template <class Value>
    void set_layer(std::string_view name, const Value& value);

    Film& film_;
    const Guide& guide_;
    std::vector<Vec3> points_;          // [pixel]: latest visible point, NaN before there is one
    std::vector<std::uint32_t> nodes_;  // [pixel]
    std::vector<float> values_;         // [pixel]: the layer being made
};

}  // namespace aips
