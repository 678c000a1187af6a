// What "glass" and "glass2" have in common.
#include "glass_surface.h"

#include <algorithm>

#include "bsdfs/dispersive_glass_bsdf.h"
#include "bsdfs/glass_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "bsdfs/thin_glass_bsdf.h"

namespace lxs::shading {

const Bsdf* scatter_glass(const GlassPoint& glass, bool architectural, const ShadingPoint& point,
                          std::pmr::memory_resource& memory) {
    if (is_black(glass.kr) && is_black(glass.kt)) return nullptr;
    if (architectural)
        return place_bsdf<ThinGlassBsdf>(memory, glass.kr, glass.kt, glass.eta, glass.pane,
                                         glass.film, point.ng, point.ns);
    if (glass.etas) {
        return place_bsdf<DispersiveGlassBsdf>(memory, glass.kr, glass.kt, *glass.etas, glass.film,
                                               point.component, point.ng, point.ns);
    }
    return place_bsdf<GlassBsdf>(memory, glass.kr, glass.kt, glass.eta, glass.film, point.ng,
                                 point.ns);
}

MaterialFacts glass_facts(bool architectural, bool disperses) {
    MaterialFacts facts;
    facts.lobes = kSpecular;
    facts.transmits = true;
    facts.straight = architectural;
    facts.disperses = disperses && !architectural;
    facts.max_bsdf_bytes = std::max(
        {kBsdfBytes<GlassBsdf>, kBsdfBytes<DispersiveGlassBsdf>, kBsdfBytes<ThinGlassBsdf>});
    return facts;
}

}  // namespace lxs::shading
