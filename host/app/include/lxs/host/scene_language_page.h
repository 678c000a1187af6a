// The reference page of the scene language: `--scene-language`.
#pragma once

#include <string>

namespace lxs {

/// Markdown: every plugin name of LuxRender 1.9 by statement, with its declared parameters if it is
/// rendered, else with what stands in for it. Parameters that several share stand once, above, and
/// those without effect in one table at the end.
std::string scene_language_page();

}  // namespace lxs
