// Debug views of guide=adaptive: the regions that its tables of directions divide the scene into.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aips/adapter/camera.h"
#include "aips/core/tables/bounce_tables.h"
#include "eye/eye_pass.h"

namespace aips {

/// Layers tableedges and tableshare of docs/reference/layers.md. They only read, and are of the
/// pass that was shown last alone: nothing of them need be saved.
class TableLayers {
  public:
    /// The film outlives the layers.
    explicit TableLayers(Film& film);

    /// Replaces the layers by what `tables` are at the visible points of a pass; `pixel_of_path` is
    /// the pixel of each of its eye paths.
    void show(const EyeImage& image, std::span<const std::uint32_t> pixel_of_path,
              const BounceTables& tables);

    std::size_t memory_bytes() const;
    static std::size_t memory_bound_bytes(std::size_t pixels);

  private:
    Film& film_;
    std::vector<std::uint32_t> regions_;  // [pixel]
    std::vector<float> values_;           // [pixel]: the layer being made
};

}  // namespace aips
