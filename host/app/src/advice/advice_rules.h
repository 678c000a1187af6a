// The rules of advice. A new one is a function declared here, its line in the list of advice.cpp, a
// scene that provokes it in tests/host/app/advice_test.cpp, and its row in
// docs/reference/statistics.md.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "advice/scene_probe.h"
#include "lxs/host/advice.h"

namespace lxs {

/// What rules look at.
struct AdviceFacts {
    const RenderSession& session;
    const TransportStatistics& transport;
    const ImageVerdict& image;
    std::span<const std::uint8_t> picture;  ///< FileFilm::tone_mapped()
    SceneProbe& probe;
};

/// What a rule has to say; nothing if all is well.
using AdviceText = std::optional<std::string>;

// transport_rules.cpp: by what the integrator counted.
AdviceText photon_depth_cuts_caustics(const AdviceFacts& facts);
AdviceText eye_depth_cuts_glass(const AdviceFacts& facts);
AdviceText light_takes_photons_for_nothing(const AdviceFacts& facts);

// image_rules.cpp: by what the image shows.
AdviceText image_is_burnt_out(const AdviceFacts& facts);
AdviceText image_is_nearly_black(const AdviceFacts& facts);
AdviceText everything_is_out_of_view(const AdviceFacts& facts);

// solid_rules.cpp: by rays that ask which solids are where.
AdviceText camera_is_inside_glass(const AdviceFacts& facts);
AdviceText lamp_is_inside_a_solid(const AdviceFacts& facts);
AdviceText glass_is_inside_out(const AdviceFacts& facts);
AdviceText architectural_glass_is_curved(const AdviceFacts& facts);

// light_rules.cpp: by rays that ask where light goes.
AdviceText path_misses_caustics(const AdviceFacts& facts);
AdviceText gloss_misses_caustics(const AdviceFacts& facts);
AdviceText radius_is_wider_than_objects(const AdviceFacts& facts);

}  // namespace lxs
