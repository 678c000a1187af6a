// Entry points of the scene reader.
#include "lxs/language/read_scene.h"

#include <filesystem>

#include "included_files.h"
#include "scene_reader.h"

namespace lxs {
namespace {

SceneContents read_source(std::string text, const std::string& name, const std::string& directory,
                          const Registry& registry, Diagnostics& diagnostics, ReadFiles* files) {
    SceneReader reader(directory.empty() ? "." : directory, registry, diagnostics);
    reader.read(source_of(std::move(text), name));
    if (files != nullptr) *files = reader.take_files();
    return reader.finish();
}

}  // namespace

void forget_sources(ReadFiles& files) {
    const auto nothing = std::make_shared<const std::string>();
    for (const auto& source : files.sources) {
        // Made by this reader, as what may change.
        if (source->text->size() > kMostKeptText)
            std::const_pointer_cast<SourceFile>(source)->text = nothing;
    }
    files.sources.clear();
}

SceneContents read_scene(const std::string& path, const Registry& registry,
                         Diagnostics& diagnostics, ReadFiles* files) {
    const std::string name = path == "-" ? "<standard input>" : path;
    const std::string directory = std::filesystem::path(path).parent_path().string();
    return read_source(read_text(path), name, directory, registry, diagnostics, files);
}

SceneContents read_scene_text(const std::string& text, const std::string& name,
                              const std::string& directory, const Registry& registry,
                              Diagnostics& diagnostics) {
    return read_source(text, name, directory, registry, diagnostics, nullptr);
}

}  // namespace lxs
