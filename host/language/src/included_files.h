// Reads the main scene file and those it includes.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "arguments.h"
#include "lxs/language/asset_finder.h"

namespace lxs {

/// Content of the file `path`, "-" for standard input. Throws std::system_error.
std::string read_text(const std::string& path);

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

/// Its first word; empty if it begins with none, but null if there is nothing but comments.
std::optional<std::string_view> first_word(std::string_view scene);

}  // namespace lxs
