// Entry points of the reader.
#include "lxs/pbrt/read_pbrt.h"

#include <filesystem>

#include "lxs/language/read_text.h"
#include "translator.h"

namespace lxs {
namespace {

SceneContents read_source(std::string text, const std::string& name, const std::string& directory,
                          const Registry& registry, Diagnostics& diagnostics, ReadFiles* files) {
    StatementExecutor executor(directory, registry, diagnostics);
    pbrt::Translator translator(executor, diagnostics);
    translator.read(source_of(std::move(text), name));
    translator.finish();
    if (files != nullptr) *files = executor.take_files();
    return executor.finish();
}

}  // namespace

bool is_pbrt_file(const std::string& path) {
    return path.ends_with(".pbrt");
}

SceneContents read_pbrt(const std::string& path, const Registry& registry, Diagnostics& diagnostics,
                        ReadFiles* files) {
    const std::string directory = std::filesystem::path(path).parent_path().string();
    return read_source(read_text(path), path, directory, registry, diagnostics, files);
}

SceneContents read_pbrt_text(const std::string& text, const std::string& name,
                             const std::string& directory, const Registry& registry,
                             Diagnostics& diagnostics) {
    return read_source(text, name, directory, registry, diagnostics, nullptr);
}

}  // namespace lxs
