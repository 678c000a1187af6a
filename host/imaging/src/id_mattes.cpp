// Which share of each pixel surfaces with an id cover.
#include "id_mattes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace lxs {

IdMattes::IdMattes(std::uint32_t width, std::uint32_t height, const PixelFilter& filter)
    : width_(width), height_(height), filter_(filter), pixels_(std::size_t{width} * height) {}

void IdMattes::add(const SampleCells& cells, std::span<const Vec2> positions,
                   const std::function<std::uint32_t(std::size_t)>& index_of) {
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, height_), [&](const auto& rows) {
        std::vector<Share> seen;
        for (std::uint32_t y = rows.begin(); y != rows.end(); ++y) {
            for (std::uint32_t x = 0; x < width_; ++x)
                gather(cells, positions, x, y, index_of, seen);
        }
    });
}

/// Sums a pass in the order of its samples, id by id, before what is kept may have to choose.
void IdMattes::gather(const SampleCells& cells, std::span<const Vec2> positions, std::uint32_t x,
                      std::uint32_t y, const std::function<std::uint32_t(std::size_t)>& index_of,
                      std::vector<Share>& seen) {
    seen.clear();
    Pixel& pixel = pixels_[std::size_t{y} * width_ + x];
    const CellRange rows(y, filter_.radius_y(), height_);
    const CellRange columns(x, filter_.radius_x(), width_);
    const Vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
        for (const std::uint32_t i : cells.samples(row, columns.first, columns.last)) {
            const float f = filter_.weight(positions[i].x - centre.x, positions[i].y - centre.y);
            if (!(f > 0)) continue;
            pixel.weight += f;
            const std::uint32_t index = index_of(i);
            if (index >= ids_.size()) continue;
            const auto same = std::find_if(seen.begin(), seen.end(), [&](const Share& share) {
                return share.id == ids_[index];
            });
            if (same == seen.end()) {
                seen.push_back({ids_[index], f});
            } else {
                same->weight += f;
            }
        }
    }
    for (const Share& share : seen)
        add(pixel, share);
}

void IdMattes::add(Pixel& pixel, const Share& share) {
    Share* least = &pixel.shares.front();
    for (Share& kept : pixel.shares) {
        if (kept.weight > 0 && kept.id == share.id) {
            kept.weight += share.weight;
            return;
        }
        if (kept.weight < least->weight) least = &kept;
    }
    // Where none is free, a new id and the least consume each other (Misra & Gries 1982): one that
    // comes late and often gets in, one that comes once costs the least no more than it has.
    if (least->weight > share.weight) {
        least->weight -= share.weight;
    } else {
        *least = {share.id, share.weight - least->weight};
    }
}

void IdMattes::clear() {
    std::fill(pixels_.begin(), pixels_.end(), Pixel{});
}

std::vector<float> IdMattes::plane(std::size_t rank, bool coverage) const {
    std::vector<float> values(pixels_.size());
    tbb::parallel_for(std::size_t{0}, pixels_.size(), [&](std::size_t i) {
        auto shares = pixels_[i].shares;
        std::sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) {
            return a.weight != b.weight ? a.weight > b.weight : a.id < b.id;
        });
        const Share& share = shares[rank];
        if (!(share.weight > 0)) return;
        values[i] = coverage ? std::min(share.weight / pixels_[i].weight, 1.0f)
                             : std::bit_cast<float>(share.id);
    });
    return values;
}

void IdMattes::state(StateArchive& archive) {
    const auto weight = [&](float& value) {
        archive.value(value);
        if (!(value >= 0) || !std::isfinite(value))
            throw StateError("a weight of the film's masks is no finite number");
    };
    for (Pixel& pixel : pixels_) {
        weight(pixel.weight);
        for (Share& share : pixel.shares) {
            archive.value(share.id);
            weight(share.weight);
        }
    }
}

}  // namespace lxs
