// Which scenes there are, and what their references are made with: tests/bench/scenes.json.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>

namespace bench {

struct BenchScene {
    std::string name;
    std::filesystem::path file;
    /// Reference methods of images 1 and 2. Where both need a radius, a third image at half of it
    /// shows the bias.
    std::array<std::string, 2> references{"photons-guided", "photons"};
    /// By method: the light that it can't find here, so that it doesn't converge.
    std::map<std::string, std::string> misses{};
};

/// `name` as listed in `table` or found as `folder`/NAME.lxs, or the path of a .lxs file. Throws
/// StudyError if there is no such file.
BenchScene find_scene(const std::string& name, const std::filesystem::path& table,
                      const std::filesystem::path& folder);

/// What `table` says of the scene `name`; nothing special if it isn't listed.
BenchScene listed_scene(const std::string& name, const std::filesystem::path& table);

/// Checksum of the scene file and of every file that a text in quotes in it names, and so on.
std::string scene_checksum(const std::filesystem::path& file);

}  // namespace bench
