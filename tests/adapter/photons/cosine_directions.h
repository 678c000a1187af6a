// Guided directions that no guide has learned, for tests of what becomes of their densities.
#pragma once

#include <algorithm>

#include "aips/adapter/guide.h"
#include "aips/core/sampling/sampling.h"

namespace mock {

/// Draws half of all directions by the cosine about `axis`.
class CosineDirections final : public aips::GuidedDirections {
  public:
    explicit CosineDirections(aips::Vec3 axis) : aips::GuidedDirections(0.5f), frame_(axis) {}
    aips::Vec3 sample(aips::Vec2 u) const override {
        return frame_.to_world(aips::square_to_cosine_hemisphere(u));
    }
    float pdf(aips::Vec3 direction) const override {
        return std::max(0.0f, aips::dot(direction, frame_.n)) * aips::kInvPi;
    }

    static const CosineDirections* about(aips::Vec3 axis, std::pmr::memory_resource& memory) {
        return new (memory.allocate(sizeof(CosineDirections), alignof(CosineDirections)))
            CosineDirections(axis);
    }

  private:
    aips::Frame frame_;
};

}  // namespace mock
