// What parameters are where a scene says nothing, and the names that choices go by.
#pragma once

#include <array>
#include <string_view>

#include "aips/adapter/settings.h"
#include "parameters.h"

namespace aips {

/// By number of Mode, GuideKind, CriterionKind, NeighbourKind, RadiusKind and PhotonSampler.
inline constexpr std::array<std::string_view, 3> kModes{"progressive", "photonmap", "ppm"};
inline constexpr std::array<std::string_view, 3> kGuides{"none", "paper", "adaptive"};
inline constexpr std::array<std::string_view, 2> kCriteria{"paper", "image"};
inline constexpr std::array<std::string_view, 3> kNeighbours{"reached", "last", "both"};
/// The first is of aips alone; LuxRender's plugins have the others.
inline constexpr std::array<std::string_view, 3> kRadii{"automatic", "schedule", "adaptive"};
inline constexpr std::array<std::string_view, 2> kPhotonSamplers{"halton", "amc"};

/// What a plugin takes where a scene says nothing: LuxRender's plugins have its values where ours
/// decides itself.
Settings defaults_of(PluginKind kind);

}  // namespace aips
