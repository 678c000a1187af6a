// What "glass" and "glass2" have in common: one dielectric interface, solid or architectural.
#pragma once

#include <optional>

#include "bsdfs/thin_film.h"
#include "lxs/scene/material.h"

namespace lxs::shading {

/// Colours and index ratio at one point.
struct GlassPoint {
    Rgb kr{1.0f}, kt{1.0f};
    float eta = 1.5f;  ///< index behind the surface / index before it
    ThinFilm film{};   ///< colours what is reflected
    /// `eta` by component where each wavelength is bent its own way.
    std::optional<Rgb> etas = {};
    bool pane = false;  ///< architectural: a whole pane, not one of its faces
};

/// Bsdf of a solid or architectural glass surface.
const Bsdf* scatter_glass(const GlassPoint& glass, bool architectural, const ShadingPoint& point,
                          std::pmr::memory_resource& memory);
/// `disperses`: its index depends on the wavelength. What is architectural bends nothing.
MaterialFacts glass_facts(bool architectural, bool disperses);

}  // namespace lxs::shading
