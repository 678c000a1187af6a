// Which scenes there are, and what their references are made with: tests/bench/scenes.json.
#include "scene_table.h"

#include <fmt/format.h>

#include <regex>
#include <set>
#include <system_error>
#include <vector>

#include "checksum.h"
#include "study_file.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

void add_with_named_files(const fs::path& file, const fs::path& folder, std::set<fs::path>& files) {
    if (!files.insert(file.lexically_normal()).second ||
        !file.extension().string().starts_with(".lx"))
        return;
    const std::string text = read_file(file);
    static const std::regex quoted("\"([^\"\n]+)\"");
    for (std::sregex_iterator match(text.begin(), text.end(), quoted), end; match != end; ++match) {
        const fs::path named = folder / (*match)[1].str();
        std::error_code no_such_file;
        if (fs::is_regular_file(named, no_such_file)) add_with_named_files(named, folder, files);
    }
}

}  // namespace

BenchScene listed_scene(const std::string& name, const fs::path& table) {
    BenchScene scene;
    scene.name = name;
    const Json listed = read_json(table);
    for (const Json& entry : listed.at("scenes")) {
        if (entry.at("name") != name) continue;
        scene.references = entry.at("references").get<std::array<std::string, 2>>();
        scene.misses = entry.value("misses", scene.misses);
    }
    return scene;
}

BenchScene find_scene(const std::string& name, const fs::path& table, const fs::path& folder) {
    const fs::path path(name);
    const bool is_path = path.extension() == ".lxs";
    BenchScene scene = listed_scene(name, table);
    if (is_path) scene.name = path.stem().string();
    scene.file = is_path ? path : folder / (name + ".lxs");
    if (!fs::is_regular_file(scene.file)) {
        throw StudyError(
            fmt::format("unknown scene \"{}\": there is no file '{}'", name, scene.file.string()));
    }
    return scene;
}

std::string scene_checksum(const fs::path& file) {
    std::set<fs::path> files;
    add_with_named_files(file, file.parent_path(), files);
    return sha1_of_files({files.begin(), files.end()});
}

}  // namespace bench
