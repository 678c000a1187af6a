// What became of light and photons in a render, as text: --explain, and one line at each end.
#pragma once

#include <string>

#include "lxs/host/render_session.h"

namespace lxs {

/// "light 3 (area, scene.lxs:12)", with its light group if that is not the default.
std::string light_name(const RenderSession& session, std::size_t light);

/// Tables of lights and materials, what was left out, where time went; several lines.
std::string explanation(const RenderSession& session, const TransportStatistics& transport);

/// Who brought the image its light, and how many photons counted; empty without photons.
std::string transport_line(const TransportStatistics& transport);

/// Luminance of the image as far as transport statistics tell it apart by light.
double told_luminance(const TransportStatistics& transport);

/// Photon paths shot, over all lights.
std::uint64_t told_photon_paths(const TransportStatistics& transport);

}  // namespace lxs
