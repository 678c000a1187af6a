// Ideal mirror: sampling.
#include "mirror_bsdf.h"

namespace lxs::shading {

bool MirrorBsdf::sample(const Vec3& wo, const Vec2&, float, Transport, LobeMask mask,
                        BsdfSample& sample) const {
    const Vec3 wi = reflect(wo, ns_);
    if (!(mask & kSpecular) || !same_side(wo, wi, ng_)) return false;
    sample = {wi, reflected(wo), 0, kSpecular, false, false};
    return true;
}

}  // namespace lxs::shading
