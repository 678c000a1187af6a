// Saves and restores the sums of a film.
#include <algorithm>
#include <array>
#include <cmath>

#include "film_accumulator.h"

namespace lxs {

void FilmAccumulator::state(StateArchive& archive) {
    check_size(archive);
    archive.fixed(first_.sums);
    bool has_second = !second_.sums.empty();
    archive.value(has_second);
    if (has_second) {
        begin_second();
        archive.fixed(second_.sums);
    } else if (archive.restoring()) {
        second_ = {};
    }
    bool has_splats = filter_integral_.has_value();
    archive.value(has_splats);
    if (has_splats) {
        begin_splats();
        archive.fixed(splats_);
    } else if (archive.restoring()) {
        std::fill(splats_.begin(), splats_.end(), 0.0);
    }
    archive.value(splat_samples_);
    for (Mean* mean : {&first_, &second_}) {
        for (double* sum :
             {&mean->white_sum.x, &mean->white_sum.y, &mean->white_sum.z, &mean->weight_sum})
            archive.value(*sum);
    }
    cells_.state_of_refused(archive);
    if (archive.restoring()) check_sums();
}

/// Films of 7 x 5 and of 5 x 7 pixels have equally many sums.
void FilmAccumulator::check_size(StateArchive& archive) const {
    std::array<std::uint32_t, 3> size{width_, height_, groups_};
    archive.fixed(std::span(size));
    if (size != std::array<std::uint32_t, 3>{width_, height_, groups_})
        throw StateError("it is of a film of another size");
}

void FilmAccumulator::check_sums() const {
    const auto finite = [](double sum) { return std::isfinite(sum); };
    const auto sound = [&](const Mean& mean) {
        return std::all_of(mean.sums.begin(), mean.sums.end(), finite) &&
               finite(mean.white_sum.x) && finite(mean.white_sum.y) && finite(mean.white_sum.z) &&
               finite(mean.weight_sum);
    };
    if (!sound(first_) || !sound(second_) || !std::all_of(splats_.begin(), splats_.end(), finite) ||
        !finite(splat_samples_) || splat_samples_ < 0)
        throw StateError("a sum of the film is no finite number");
}

}  // namespace lxs
