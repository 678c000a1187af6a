// Samples of a field, and what they say of its cells.
#include "lxs/sdk/medium_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "field_flight.h"

namespace lxs {
namespace {

/// Samples along the longest side of the bounds, less one: of a field of no cells, and at most.
constexpr int kSamples = 128, kMostSamples = 512;
/// Cells along it at most: beyond, a flight's steps cost more than what majorants spare.
constexpr int kMostCells = 64;
/// Samples along the side of a cell, at least.
constexpr int kSamplesOfACell = 4;
/// Most that spectra are above the colours that they are made of.
constexpr float kAboveColours = 1.25f;

/// Greatest optical depth of a cell. Nothing is seen through it, and flights may collide as often
/// in vain where a part of the cell is empty.
constexpr float kDensestCell = 1e4f;

}  // namespace

BoundedField::BoundedField(std::shared_ptr<const MediumField> field, const Bounds& bounds,
                           const FieldJobs& jobs)
    : field_(std::move(field)) {
    const Vec3 size = bounds.size();
    const float longest = std::max({size.x, size.y, size.z, 1e-30f});
    // At borders and middles of its own cells: a grid that fills the bounds is met where it is
    // most.
    const float own = field_->cell_size() > 0 ? 2 * longest / field_->cell_size() : 0;
    const int wanted = int(std::clamp(own, float(kSamples), float(kMostSamples)));
    const int per_cell = std::max(kSamplesOfACell, (wanted + kMostCells - 1) / kMostCells);
    grid_ = RegularGrid(bounds, (wanted + per_cell - 1) / per_cell);
    const RegularGrid::Cell& cells = grid_.cells;
    RegularGrid::Cell samples{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        samples[axis] = cells[axis] * per_cell + 1;
    const float densest = kDensestCell / std::min({grid_.width.x, grid_.width.y, grid_.width.z});
    const auto row = std::size_t(samples[0]), layer = row * std::size_t(samples[1]);
    // Of a cell its own samples, those on its faces, and one beyond.
    const auto around = [&](int cell, std::size_t axis) {
        return std::pair(std::max(cell * per_cell - 1, 0),
                         std::min((cell + 1) * per_cell + 1, samples[axis] - 1));
    };
    std::vector<Imath::V3d> absorption(std::size_t(samples[2]), Imath::V3d(0.0));
    std::vector<Imath::V3d> scattering(absorption);
    majorants_.resize(grid_.count());
    // Layer by layer of cells: samples of all at once would take half a gigabyte.
    jobs(cells[2], [&](int cell_z) {
        const auto [first, last] = around(cell_z, 2);
        std::vector<float> extinctions(layer * std::size_t(last - first + 1));
        for (int z = first; z <= last; ++z) {
            float* next = extinctions.data() + std::size_t(z - first) * layer;
            Imath::V3d absorbed(0.0), scattered(0.0);
            for (int y = 0; y < samples[1]; ++y) {
                for (int x = 0; x < samples[0]; ++x) {
                    const Vec3 place = Vec3(float(x), float(y), float(z)) / float(per_cell);
                    const MediumCoefficients here =
                        field_->at(bounds.min + place * grid_.width, nullptr);
                    const float most = max_component(here.extinction());
                    const float share = most > densest ? densest / most : 1;
                    absorbed += Imath::V3d(here.absorption * share);
                    scattered += Imath::V3d(here.scattering * share);
                    *next++ = most * share;
                }
            }
            // Layers that two jobs sample count once.
            if (std::min(z / per_cell, cells[2] - 1) != cell_z) continue;
            absorption[std::size_t(z)] = absorbed;
            scattering[std::size_t(z)] = scattered;
        }
        for (int y = 0; y < cells[1]; ++y) {
            for (int x = 0; x < cells[0]; ++x) {
                const auto [x0, x1] = around(x, 0);
                const auto [y0, y1] = around(y, 1);
                float most = 0;
                for (int k = 0; k <= last - first; ++k) {
                    for (int j = y0; j <= y1; ++j) {
                        const float* const from =
                            extinctions.data() + std::size_t(k) * layer + std::size_t(j) * row;
                        most = std::max(most, *std::max_element(from + x0, from + x1 + 1));
                    }
                }
                majorants_[grid_.index({x, y, cell_z})] = std::min(most * kAboveColours, densest);
            }
        }
    });
    const auto mean = [&](const std::vector<Imath::V3d>& sums) {
        Imath::V3d sum(0.0);
        for (const Imath::V3d& s : sums)
            sum += s;
        return Rgb(Vec3(sum / (double(layer) * double(samples[2]))));
    };
    mean_.absorption = mean(absorption);
    mean_.scattering = mean(scattering);
}

MediumCoefficients BoundedField::at(const Vec3& position) const {
    if (!grid_.bounds.intersects(position)) return {};
    MediumCoefficients here = field_->at(position, wavelengths_);
    const float limit = majorants_[grid_.index(grid_.cell_at(position))];
    const float most = max_component(here.extinction());
    if (most > limit) {
        here.absorption *= limit / most;
        here.scattering *= limit / most;
    }
    return here;
}

// One place in each cell tells of what it emits.
Rgb BoundedField::emitted(const Vec3& origin, const Vec3& direction, float length,
                          HashedNumbers numbers) const {
    HashedNumbers of_flight = numbers;
    of_flight.about(1.0f);
    GridWalk cells(grid_, origin, direction, double(length));
    Rgb sum(0.0f), passed(1.0f);
    const auto place_in_cell = [&] {
        return cells.from() + (cells.to() - cells.from()) * double(numbers.next());
    };
    double asked = cells.inside() ? place_in_cell() : 0;
    const auto ask_until = [&](double distance) {
        while (cells.inside() && asked < distance) {
            const Rgb here = field_->emission(origin + direction * float(asked), wavelengths_);
            sum += here * passed * float(cells.to() - cells.from());
            cells.go_on();
            if (cells.inside()) asked = place_in_cell();
        }
    };
    fly(origin, direction, length, of_flight,
        [&](float distance, const MediumCoefficients& here, float majorant) {
            ask_until(double(distance));
            passed *= Rgb(1.0f) - here.extinction() / majorant;
            return is_black(passed);
        });
    if (!is_black(passed)) ask_until(std::numeric_limits<double>::infinity());
    return sum;
}

}  // namespace lxs
