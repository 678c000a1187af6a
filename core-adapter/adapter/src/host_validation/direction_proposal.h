// A density of directions that is known exactly and follows lobes of any width: half uniform, half
// caps around directions that were seen to matter.
#pragma once

#include <vector>

#include "aips/core/sampling/random.h"
#include "aips/core/sampling/sampling.h"
#include "tolerances.h"

namespace aips {

class DirectionProposal {
  public:
    /// Caps around each of these unit directions, from a tenth of the sphere to 10^-6 of it. They
    /// must not be among the samples that are compared.
    explicit DirectionProposal(std::vector<Vec3> pilots) : pilots_(std::move(pilots)) {}

    Vec3 sample(RandomStream& random) const;
    /// Per steradian; positive everywhere.
    double pdf(Vec3 direction) const;

  private:
    /// 1 - cosine of the half angle of a cap; its solid angle is 2 pi times as much.
    static double extent(int size);

    std::vector<Vec3> pilots_;
};

}  // namespace aips
