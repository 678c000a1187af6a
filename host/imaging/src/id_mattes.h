// Which share of each pixel surfaces with an id cover.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lxs/sdk/layers.h"
#include "lxs/sdk/state_archive.h"
#include "pixel_filter.h"
#include "sample_cells.h"

namespace lxs {

/// Ids of a pixel that a file tells: three layers of two.
inline constexpr std::size_t kMatteRanks = 6;

class IdMattes {
  public:
    /// `id_of` gives the id of what a sample saw, 0 for nothing. Weights are those of `filter`,
    /// none below zero.
    IdMattes(std::uint32_t width, std::uint32_t height, const PixelFilter& filter);

    /// Ids by index of a name; an index beyond is nothing.
    void set_ids(std::vector<std::uint32_t> ids) { ids_ = std::move(ids); }

    /// Adds a pass whose samples, which `cells` has sorted, saw `index_of(sample)`.
    void add(const SampleCells& cells, std::span<const Vec2> positions,
             const std::function<std::uint32_t(std::size_t)>& index_of);
    void clear();

    /// Id of rank `rank` in each pixel, as the float of its bits, or with `coverage` the share of
    /// the pixel; both 0 where there is none.
    std::vector<float> plane(std::size_t rank, bool coverage) const;

    void state(StateArchive& archive);
    std::size_t memory_bytes() const {
        return pixels_.capacity() * sizeof(Pixel) + ids_.capacity() * sizeof(std::uint32_t);
    }

  private:
    struct Share {
        std::uint32_t id = 0;
        float weight = 0;  ///< 0: no id
    };
    /// As many ids as are told and some more. In a pixel with more than these the least are told
    /// too low.
    struct Pixel {
        float weight = 0;  ///< of all samples
        std::array<Share, kMatteRanks + 2> shares;
    };

    void gather(const SampleCells& cells, std::span<const Vec2> positions, std::uint32_t x,
                std::uint32_t y, const std::function<std::uint32_t(std::size_t)>& index_of,
                std::vector<Share>& seen);
    static void add(Pixel& pixel, const Share& share);

    std::uint32_t width_, height_;
    PixelFilter filter_;
    std::vector<std::uint32_t> ids_;
    std::vector<Pixel> pixels_;
};

}  // namespace lxs
