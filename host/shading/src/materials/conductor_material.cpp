// Rough metal with optical constants from a texture.
#include "conductor_material.h"

#include "bsdfs/conductor_bsdf.h"
#include "bsdfs/place_bsdf.h"

namespace lxs::shading {

const Bsdf* ConductorMaterial::scatter(const ShadingPoint& point,
                                       std::pmr::memory_resource& memory) const {
    return place_bsdf<ConductorBsdf>(memory, fresnel_.at(point.texture), surface_.at(point));
}

MaterialFacts ConductorMaterial::facts() const {
    MaterialFacts facts;
    facts.lobes = kGlossy;
    facts.reads_image = fresnel_.reads_image() || surface_.reads_image();
    facts.max_bsdf_bytes = kBsdfBytes<ConductorBsdf>;
    return facts;
}

}  // namespace lxs::shading
