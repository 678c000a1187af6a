// A medium that varies in space, and how light finds its way through it.
//
// References: Woodcock et al. 1965 (delta tracking), Novak et al. 2014, "Residual ratio tracking
// for estimating attenuation in participating media" (ratio tracking), Kutz et al. 2017, "Spectral
// and decomposition tracking for rendering heterogeneous volumes" (weights of several channels).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "lxs/sdk/types.h"

namespace lxs {

struct Wavelengths;  // lxs/spectrum

/// What a medium does to light, per unit of distance and component, >= 0.
struct MediumCoefficients {
    Rgb absorption{0.0f}, scattering{0.0f};
    Rgb asymmetry{0.0f};  ///< mean cosine of the angle of scattering, in (-1, 1)

    Rgb extinction() const { return absorption + scattering; }
};

/// Absorption and scattering by place; asymmetry is the same everywhere, and left out.
class MediumField {
  public:
    virtual ~MediumField() = default;
    /// In world space. `wavelengths`: those of the pass; null where Rgb means R, G and B.
    virtual MediumCoefficients at(const Vec3& position, const Wavelengths* wavelengths) const = 0;
    /// Whether it scatters anywhere.
    virtual bool scatters() const = 0;
    /// Of a field of cells, the least side of one; 0: of no cells.
    virtual float cell_size() const { return 0; }
};

/// Runs job(0) ... job(count - 1) on any number of threads.
using FieldJobs = std::function<void(int count, const std::function<void(int)>& job)>;

/// A field within bounds, outside of which there is nothing, with the most that it is in each of
/// its cells: what tracking flies by. Both are found at samples, 128 along the longest side, and up
/// to 512 where the field has cells of its own; where the field is more between samples than around
/// them, or a cell so dense that nothing is seen through it, it is cut to that.
class BoundedField {
  public:
    BoundedField(std::shared_ptr<const MediumField> field, const Bounds& bounds,
                 const FieldJobs& jobs);

    /// Of the pass; they outlive it. Null: Rgb means R, G and B.
    void set_wavelengths(const Wavelengths* wavelengths) { wavelengths_ = wavelengths; }

    /// Coefficients at a place.
    MediumCoefficients at(const Vec3& position) const;
    /// Mean over the bounds.
    const MediumCoefficients& mean() const { return mean_; }

    /// Flies from `origin` until `collide(distance, coefficients, majorant)` returns true, which it
    /// is asked where light may collide: at random, `majorant` times per unit of distance. False if
    /// the flight of `length`, which may be infinite, ends first. `seed` draws the places.
    template <class Collide>
    bool fly(const Vec3& origin, const Vec3& direction, float length, std::uint64_t seed,
             Collide&& collide) const;

  private:
    /// A flight's way through the cells.
    class Cells;
    std::size_t index(const std::array<int, 3>& cell) const {
        return (std::size_t(cell[2]) * std::size_t(cells_[1]) + std::size_t(cell[1])) *
                   std::size_t(cells_[0]) +
               std::size_t(cell[0]);
    }

    std::shared_ptr<const MediumField> field_;
    Bounds bounds_;
    const Wavelengths* wavelengths_ = nullptr;
    std::array<int, 3> cells_{1, 1, 1};
    Vec3 width_{1.0f};              // of a cell
    std::vector<float> majorants_;  // [cell]: of the extinction of any component
    MediumCoefficients mean_;
};

}  // namespace lxs
