// Mutations in primary sample space.
#include "path/metropolis_coordinates.h"

#include <algorithm>
#include <cmath>

namespace lxs {

float mutate(float value, float u, const MutationRange& range) {
    const bool up = u < 0.5f;
    const double within = 2 * (up ? double{u} : double{u} - 0.5);
    const double length =
        range.largest * std::exp(-std::log(range.largest / range.smallest) * within);
    const double moved = up ? value + length : value - length;
    // The difference may round up to 1, which is no value of the half-open interval.
    return std::min(static_cast<float>(moved - std::floor(moved)), std::nextafter(1.0f, 0.0f));
}

void MetropolisCoordinates::propose(const RandomStream& random, bool large) {
    random_ = random;
    large_ = large;
    proposed_.clear();
    drop_block();
}

void MetropolisCoordinates::state(StateArchive& archive) {
    archive.values(present_);
    const bool sound =
        std::all_of(present_.begin(), present_.end(), [](float u) { return u >= 0 && u < 1; });
    if (!sound) throw StateError("a coordinate of a chain is outside of the unit interval");
}

const MutationRange& MetropolisCoordinates::range(std::size_t dimension) const {
    if (dimension == 0) return film_x_;
    return dimension == 1 ? film_y_ : other_;
}

void MetropolisCoordinates::next_block(Block& block) {
    const std::size_t first = proposed_.size();
    for (std::size_t i = 0; i < block.size(); ++i) {
        const float u = random_.next();
        const bool anew = large_ || first + i >= present_.size();
        block[i] = anew ? u : mutate(present_[first + i], u, range(first + i));
    }
    if (first < kMostStored) proposed_.insert(proposed_.end(), block.begin(), block.end());
}

}  // namespace lxs
