// A medium that varies in space, and how light finds its way through it.
//
// References: Woodcock et al. 1965 (delta tracking), Novak et al. 2014, "Residual ratio tracking
// for estimating attenuation in participating media" (ratio tracking), Kutz et al. 2017, "Spectral
// and decomposition tracking for rendering heterogeneous volumes" (weights of several channels).
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "lxs/sdk/grid_walk.h"
#include "lxs/sdk/hashed_numbers.h"
#include "lxs/sdk/types.h"

namespace lxs {

struct Wavelengths;  // lxs/spectrum

/// What a medium does to light, per unit of distance and component, >= 0.
struct MediumCoefficients {
    Rgb absorption{0.0f}, scattering{0.0f};
    Rgb asymmetry{0.0f};  ///< mean cosine of the angle of scattering, in (-1, 1)
    Rgb emission{0.0f};   ///< radiance that it sends by itself

    Rgb extinction() const { return absorption + scattering; }
};

/// Absorption and scattering by place; asymmetry is the same everywhere, and left out, and emission
/// is asked for apart.
class MediumField {
  public:
    virtual ~MediumField() = default;
    /// In world space. `wavelengths`: those of the pass; null where Rgb means R, G and B.
    virtual MediumCoefficients at(const Vec3& position, const Wavelengths* wavelengths) const = 0;
    /// Whether it scatters anywhere.
    virtual bool scatters() const = 0;
    /// Radiance that it sends by itself per unit of distance, likewise.
    virtual Rgb emission(const Vec3& /*position*/, const Wavelengths* /*wavelengths*/) const {
        return Rgb(0.0f);
    }
    /// Whether it sends light anywhere.
    virtual bool emits() const { return false; }
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
    /// MediumField::emission() at a place, for R, G and B whatever the pass has.
    Rgb emission(const Vec3& position) const {
        return grid_.bounds.intersects(position) ? field_->emission(position, nullptr) : Rgb(0.0f);
    }
    /// Light of its own that reaches `origin` from the first `length` of a ray: an estimate that is
    /// right in the mean, drawn by `numbers`.
    Rgb emitted(const Vec3& origin, const Vec3& direction, float length,
                HashedNumbers numbers) const;

    /// Flies from `origin` until `collide(distance, coefficients, majorant)` returns true, which it
    /// is asked where light may collide: at random, `majorant` times per unit of distance. False if
    /// the flight of `length`, which may be infinite, ends first. `numbers` draw the places.
    template <class Collide>
    bool fly(const Vec3& origin, const Vec3& direction, float length, HashedNumbers numbers,
             Collide&& collide) const;

  private:
    std::shared_ptr<const MediumField> field_;
    const Wavelengths* wavelengths_ = nullptr;
    RegularGrid grid_;
    std::vector<float> majorants_;  // [cell]: of the extinction of any component
    MediumCoefficients mean_;
};

}  // namespace lxs
