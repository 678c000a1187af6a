// The surface of a yarn where it shows in a weave, and the direction of the fibres in it.
// Source: Irawan & Marschner 2012, "Specular Reflection from Woven Cloth": a tube along an arc,
// its fibres twisted about it.
#pragma once

#include "bsdfs/woven_bsdf.h"
#include "weave.h"

namespace lxs::shading {

/// Yarns of one direction and the fibres they are made of.
struct Yarn {
    float crimp;      ///< height of the bow over the yarns that it crosses, in its widths, > 0
    float roundness;  ///< sine of the lean at its sides: 1 for a tube, less for a flattened one
    float twist;      ///< of the fibres about the yarn's direction, degrees; > 0 is a Z twist
    float roughness;  ///< deviation of the fibres' inclination, degrees, > 0
    float through;    ///< share of scattered light that goes through a fibre, 0 to 1
};

class BentYarn {
  public:
    explicit BentYarn(const Yarn& yarn);

    /// At `place`, in the coordinates of a shading frame. `u`, `v`: 1 or -1, the sense of its x and
    /// y in which the weave's u and v grow.
    YarnPoint at(const WovenPlace& place, float u, float v) const;

  private:
    float crimp_, roundness_, cos_twist_, sin_twist_;
    FibreLobe fibres_;
};

}  // namespace lxs::shading
