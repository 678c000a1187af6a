// The reference page of the scene language: `--scene-language`.
#pragma once

#include <string>

namespace lxs {

/// Markdown: every plugin name of LuxRender 1.9 by statement, with its declared parameters if it is
/// rendered, else with what stands in for it.
std::string scene_language_page();

}  // namespace lxs
