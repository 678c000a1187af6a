// Pictures of a report: crops of what methods have after equal time, and their signed errors.
#pragma once

#include <filesystem>

#include "run_errors.h"

namespace bench {

/// A list with one entry for each scene that has images: `exposure`, `gamma`, `clock`, `budget_s`,
/// `seed`, `crop` (`x`, `y`, `width_px`, `height_px`), `overview` and `reference` (PNG data URIs
/// of the whole reference and of its crop; null without references), `error_scale` (the relative
/// error of full colour; null without references) and `tiles`: `variant`, `method`, `image`,
/// `error` (null without references), `seconds`, `passes`, `relmse` of the snapshot. All of a scene
/// are shown with one exposure. Crops are as large as about `bytes` of pictures
/// allow. `runs` are those that are done.
Json report_images(const std::filesystem::path& folder, const Json& runs, const Json& study,
                   ReferenceCache& references, double bytes);

}  // namespace bench
