// Reads a LuxRender 1.x scene file and everything it includes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lxs/language/read_files.h"
#include "lxs/scene/contents.h"
#include "lxs/scene/registry.h"
#include "lxs/sdk/diagnostics.h"

namespace lxs {

/// Reads `path` ("-": standard input). Throws InputError (bad input) or std::system_error (the
/// file can't be read). Fills `files`, unless it is null.
SceneContents read_scene(const std::string& path, const Registry& registry,
                         Diagnostics& diagnostics, ReadFiles* files = nullptr);

/// The same from memory; `directory` is where relative names are looked up.
SceneContents read_scene_text(const std::string& text, const std::string& name,
                              const std::string& directory, const Registry& registry,
                              Diagnostics& diagnostics);

/// Every plugin name of LuxRender 1.9 by statement ("Material", "Shape", ...), rendered or not:
/// a name in here that the host does not render yet is reported as such, any other as unknown.
const std::map<std::string, std::vector<std::string>>& known_plugin_names();

}  // namespace lxs
