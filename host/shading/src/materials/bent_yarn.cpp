// The surface of a yarn where it shows in a weave, and the direction of the fibres in it.
#include "bent_yarn.h"

#include <algorithm>
#include <cmath>

#include "lxs/sdk/warp.h"

namespace lxs::shading {
namespace {

FibreLobe lobe_of(const Yarn& yarn) {
    const float deviation = yarn.roughness * kRadiansPerDegree;
    return {deviation * deviation, yarn.through};
}

}  // namespace

BentYarn::BentYarn(const Yarn& yarn)
    : crimp_(yarn.crimp),
      roundness_(yarn.roundness),
      cos_twist_(std::cos(yarn.twist * kRadiansPerDegree)),
      sin_twist_(std::sin(yarn.twist * kRadiansPerDegree)),
      fibres_(lobe_of(yarn)) {}

// u is the paper's angle along the bow, v the one around the cross-section.
YarnPoint BentYarn::at(const WovenPlace& place, float u, float v) const {
    const Vec3 z(0, 0, 1);
    const Vec3 along = place.warp ? Vec3(0, v, 0) : Vec3(u, 0, 0);
    const Vec3 across = place.warp ? Vec3(u, 0, 0) : Vec3(0, v, 0);
    // Tangent of half the inclination at the ends of an arc of this height over its chord.
    const float half = 2 * crimp_ / place.length;
    const float sin_u = place.along * 2 * half / (1 + half * half);
    const float cos_u = std::sqrt(std::max(0.0f, 1 - sin_u * sin_u));
    const float sin_v = place.across * roundness_,
                cos_v = std::sqrt(std::max(0.0f, 1 - sin_v * sin_v));
    const Vec3 normal = across * sin_v + (along * sin_u + z * cos_u) * cos_v;
    const Vec3 spine = along * cos_u - z * sin_u;
    return {normal, spine * cos_twist_ + spine.cross(normal) * sin_twist_, fibres_};
}

}  // namespace lxs::shading
