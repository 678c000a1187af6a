// Sums by cells of the film.
#include "estimate/photon_noise.h"

#include <cmath>
#include <limits>

#include "base/constants.h"
#include "base/disjoint_ranges.h"
#include "base/film_pixel.h"

namespace aips {

PhotonNoise::PhotonNoise(std::uint32_t width, std::uint32_t height)
    : width_(width),
      height_(height),
      cells_(std::size_t{film_cells_along(width)} * film_cells_along(height)) {}

void PhotonNoise::add_pass(const EyeImage& image, const PhotonFlux& flux) {
    const auto cell_at = [&](std::size_t i) {
        const Vec2 film = image.positions[image.visible_points[i].sample];
        return film_cell(film_pixel(film, width_, height_), width_);
    };
    const std::uint32_t columns = film_cells_along(width_);
    in_disjoint_ranges(
        image.visible_points.size(),
        [&](std::size_t i) { return std::uint32_t(cell_at(i) / columns); },
        [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const auto sum = double(luminance_over_groups(flux.flux, i, image.groups));
                const auto squares = double(flux.squares[i]);
                // Of a single point whose square overflows the cell would know nothing ever after.
                if (flux.accepted[i] == 0 || !std::isfinite(sum) || !std::isfinite(squares))
                    continue;
                Cell& cell = cells_[cell_at(i)];
                cell.sum += sum;
                cell.squares += squares;
            }
        });
}

double PhotonNoise::relative_variance(std::uint32_t pixel) const {
    const Cell& cell = cells_[film_cell(pixel, width_)];
    if (!(cell.sum > 0)) return std::numeric_limits<double>::infinity();
    return double(kFilmCell * kFilmCell) * cell.squares / (cell.sum * cell.sum);
}

void PhotonNoise::state(StateArchive& archive) {
    for (Cell& cell : cells_) {
        archive.amount(cell.sum);
        archive.amount(cell.squares);
    }
}

}  // namespace aips
