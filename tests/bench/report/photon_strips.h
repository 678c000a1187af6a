// Debug layers of a study's photon methods over the passes, as rows of small pictures.
#pragma once

#include <filesystem>

#include "study_file.h"

namespace bench {

/// Pictures are at most this wide.
inline constexpr int kStripPictureWidth = 160;

/// Snapshots of the first seed and variant (docs/reference/layers.md says what the layers are):
/// that after the first pass and those taken for budgets of the study's first clock, six at most.
/// `variant`, `seed`, `clock`, `palette` (colours as "#rrggbb"), `columns` (null for the first
/// pass, or seconds of the budget), `left_out` (layers for which there was no room) and `scenes`:
/// `scene` and `layers`, those that it has: `layer`, `low`, `high`, `logarithmic` (one scale for
/// all pictures of a scene and layer) and `rows` of `method` and `pictures`, one per column: null,
/// or `pass`, `seconds`, `image` (PNG data URI). Null if no image of the study has such layers.
/// Pictures shrink, and then layers are left out, until they take no more than `bytes`. `runs` are
/// those that are done. Throws StudyError.
Json report_photon_strips(const std::filesystem::path& folder, const Json& runs, const Json& study,
                          double bytes);

}  // namespace bench
