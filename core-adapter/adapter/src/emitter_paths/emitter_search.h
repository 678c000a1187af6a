// Searches for images that specular surfaces make of emitters.
//
// A chain of specular surfaces maps the film, which has two dimensions, to directions, which have
// two as well. From a film position that sees such a chain Newton's method goes to the one from
// which it looks at an emitter; derivatives are taken by differences, so that nothing is asked of
// the host but to trace rays. (Manifold walks solve the same equations for the chain's vertices:
// Jakob and Marschner 2012; Zeltner et al. 2020.) The derivative at the root tells how large the
// emitter's image is, however small: no chance has to meet it first.
#pragma once

#include <vector>

#include "eye/eye_pass.h"

namespace aips {

/// One search.
struct EmitterSearch {
    std::uint64_t round = 0;  ///< no two rounds of a render have the same
    std::uint32_t number = 0;
    float time = 0;
};

/// Starts anywhere on the film; adds the images of emitters that were found and seen to `images`.
/// Returns the rays that it took.
std::uint64_t search_emitters(const EyePassInput& input, const EmitterSearch& search,
                              InvalidSampleFilter& filter, Arena& arena,
                              std::vector<EmitterImage>& images);

}  // namespace aips
