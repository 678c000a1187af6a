// Reads a scene in pbrt's format (version 4, and 3 where words differ), and everything it includes.
#pragma once

#include <string>

#include "lxs/language/read_files.h"
#include "lxs/scene/contents.h"
#include "lxs/scene/registry.h"
#include "lxs/sdk/diagnostics.h"

namespace lxs {

/// True of a file name that ends like a scene of pbrt.
bool is_pbrt_file(const std::string& path);

/// Reads `path`, as read_scene() does a scene of LuxRender. Each directive becomes the statements
/// of our own language that mean the same; what has no equal is told, and the nearest used. Throws
/// InputError (bad input) or std::system_error (the file can't be read). Fills `files`, unless it
/// is null.
SceneContents read_pbrt(const std::string& path, const Registry& registry, Diagnostics& diagnostics,
                        ReadFiles* files = nullptr);

/// The same from memory; `directory` is where relative names are looked up.
SceneContents read_pbrt_text(const std::string& text, const std::string& name,
                             const std::string& directory, const Registry& registry,
                             Diagnostics& diagnostics);

}  // namespace lxs
