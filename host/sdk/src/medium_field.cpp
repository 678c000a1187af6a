// Samples of a field, and what they say of its cells.
#include "lxs/sdk/medium_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lxs {
namespace {

/// Samples along the longest side of the bounds, less one.
constexpr int kSamples = 128;
/// Of these along the side of a cell.
constexpr int kSamplesOfACell = 4;
/// Most that spectra are above the colours that they are made of.
constexpr float kAboveColours = 1.25f;

/// Greatest optical depth of a cell. Nothing is seen through it, and flights may collide as often
/// in vain where a part of the cell is empty.
constexpr float kDensestCell = 1e4f;

}  // namespace

BoundedField::BoundedField(std::shared_ptr<const MediumField> field, const Bounds& bounds,
                           const FieldJobs& jobs)
    : field_(std::move(field)), bounds_(bounds) {
    const Vec3 size = bounds.size();
    const float longest = std::max({size.x, size.y, size.z, 1e-30f});
    std::array<int, 3> samples{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float share = size[int(axis)] / longest * (kSamples / kSamplesOfACell);
        cells_[axis] = std::clamp(int(std::ceil(share)), 1, kSamples / kSamplesOfACell);
        samples[axis] = cells_[axis] * kSamplesOfACell + 1;
        width_[int(axis)] = std::max(size[int(axis)], 1e-6f * longest) / float(cells_[axis]);
    }
    const float densest = kDensestCell / std::min({width_.x, width_.y, width_.z});
    const auto layer = std::size_t(samples[0]) * std::size_t(samples[1]);
    std::vector<float> extinctions(layer * std::size_t(samples[2]));
    std::vector<Imath::V3d> absorption(std::size_t(samples[2]), Imath::V3d(0.0));
    std::vector<Imath::V3d> scattering(absorption);
    jobs(samples[2], [&](int z) {
        float* next = extinctions.data() + std::size_t(z) * layer;
        for (int y = 0; y < samples[1]; ++y) {
            for (int x = 0; x < samples[0]; ++x) {
                const Vec3 place = Vec3(float(x), float(y), float(z)) / float(kSamplesOfACell);
                const MediumCoefficients here = field_->at(bounds_.min + place * width_, nullptr);
                const float most = max_component(here.extinction());
                const float share = most > densest ? densest / most : 1;
                absorption[std::size_t(z)] += Imath::V3d(here.absorption * share);
                scattering[std::size_t(z)] += Imath::V3d(here.scattering * share);
                *next++ = most * share;
            }
        }
    });
    const auto mean = [&](const std::vector<Imath::V3d>& sums) {
        Imath::V3d sum(0.0);
        for (const Imath::V3d& s : sums)
            sum += s;
        return Rgb(Vec3(sum / double(extinctions.size())));
    };
    mean_.absorption = mean(absorption);
    mean_.scattering = mean(scattering);
    // Of a cell its own samples, those on its faces, and one beyond.
    majorants_.resize(index({cells_[0] - 1, cells_[1] - 1, cells_[2] - 1}) + 1);
    jobs(cells_[2], [&](int z) {
        for (int y = 0; y < cells_[1]; ++y) {
            for (int x = 0; x < cells_[0]; ++x) {
                const auto around = [&](int cell, std::size_t axis) {
                    return std::pair(std::max(cell * kSamplesOfACell - 1, 0),
                                     std::min((cell + 1) * kSamplesOfACell + 1, samples[axis] - 1));
                };
                const auto [x0, x1] = around(x, 0);
                const auto [y0, y1] = around(y, 1);
                const auto [z0, z1] = around(z, 2);
                float most = 0;
                for (int k = z0; k <= z1; ++k) {
                    for (int j = y0; j <= y1; ++j) {
                        const float* const row = extinctions.data() + std::size_t(k) * layer +
                                                 std::size_t(j) * std::size_t(samples[0]);
                        most = std::max(most, *std::max_element(row + x0, row + x1 + 1));
                    }
                }
                majorants_[index({x, y, z})] = std::min(most * kAboveColours, densest);
            }
        }
    });
}

MediumCoefficients BoundedField::at(const Vec3& position) const {
    if (!bounds_.intersects(position)) return {};
    MediumCoefficients here = field_->at(position, wavelengths_);
    std::array<int, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int i = int(axis);
        cell[axis] =
            std::clamp(int((position[i] - bounds_.min[i]) / width_[i]), 0, cells_[axis] - 1);
    }
    const float limit = majorants_[index(cell)], most = max_component(here.extinction());
    if (most > limit) {
        here.absorption *= limit / most;
        here.scattering *= limit / most;
    }
    return here;
}

}  // namespace lxs
