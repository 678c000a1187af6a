// Reads the main scene file and those it includes.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "lxs/language/arguments.h"
#include "lxs/language/asset_finder.h"
#include "lxs/language/read_text.h"

namespace lxs {

/// What a scene's Includes have read so far; a file that is included twice counts twice.
struct IncludedSum {
    std::size_t files = 0, bytes = 0;
    /// Names that lead to one file have one path here; found once for each name.
    std::map<std::string, std::filesystem::path> identities = {};
};

/// The file that an Include names, added to `sum`. Throws IgnoredStatement if it is missing or
/// can't be read; InputError if it includes itself or nests too deep; EndOfReading if the sum grows
/// beyond all scenes.
std::shared_ptr<const SourceFile> open_include(const Name& file, AssetFinder& finder,
                                               IncludedSum& sum, Diagnostics& diagnostics);

}  // namespace lxs
