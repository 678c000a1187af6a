// The response curves that the Film statement asks for.
#include "camera_response_choice.h"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <string>

namespace lxs {
namespace {

std::optional<std::string> path_of(const std::string& name, const SourceLocation& where,
                                   const FileResolver& resolve) {
    if (!resolve) return std::nullopt;
    try {
        return resolve(name, where);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

std::shared_ptr<const SourceFile> read_file(const std::string& path, const SourceLocation& where) {
    constexpr std::streamsize kMostBytes = 1 << 24;  // curves of a film take some 60 KB
    std::ifstream file(path, std::ios::binary);
    if (!file) return nullptr;
    std::string text(kMostBytes, '\0');
    file.read(text.data(), kMostBytes);
    text.resize(static_cast<std::size_t>(file.gcount()));
    return std::make_shared<const SourceFile>(SourceFile{
        path, std::make_shared<const std::string>(std::move(text)), where.file, where.line});
}

}  // namespace

std::shared_ptr<const CameraResponse> choose_camera_response(const FilmSettings& settings,
                                                             Diagnostics& diagnostics,
                                                             const FileResolver& resolve) {
    const std::string& name = settings.response_file;
    const SourceLocation& where = settings.response_where;
    if (name.empty()) return nullptr;
    const auto path = path_of(name, where, resolve);
    const auto file = path ? read_file(*path, where) : nullptr;
    if (!file) {
        const bool builtin = is_builtin_response(name);
        diagnostics.fallback(
            where,
            builtin ? fmt::format("the measured response of film {} is not at hand, name a file "
                                  "with its curves",
                                  in_quotes(name))
                    : fmt::format("no file {} can be read", in_quotes(name)),
            "no film response is applied");
        return nullptr;
    }
    try {
        return std::make_shared<const CameraResponse>(read_camera_response(file));
    } catch (const ResponseFileError& error) {
        diagnostics.fallback(error.where(), error.what(), "no film response is applied");
        return nullptr;
    }
}

}  // namespace lxs
