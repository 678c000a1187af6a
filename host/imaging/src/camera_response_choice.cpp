// The response curves that the Film statement asks for.
#include "camera_response_choice.h"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <string>

namespace lxs {
namespace {

/// What the scene gives for "cameraresponse", if anything.
const ParameterValue* named_response(const SceneContents& contents) {
    const auto film = contents.options.find("Film");
    if (film == contents.options.end()) return nullptr;
    const ParameterValue* last = nullptr;
    for (const ParameterValue& value : film->second.parameters.values) {
        if (value.name == "cameraresponse") last = &value;
    }
    return last;
}

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

std::shared_ptr<const CameraResponse> choose_camera_response(const SceneContents& contents,
                                                             Diagnostics& diagnostics,
                                                             const FileResolver& resolve) {
    const ParameterValue* value = named_response(contents);
    if (!value) return nullptr;
    const std::string name = std::get<std::vector<std::string>>(value->values).front();
    if (name.empty()) return nullptr;
    const auto path = path_of(name, value->where, resolve);
    const auto file = path ? read_file(*path, value->where) : nullptr;
    if (!file) {
        diagnostics.warning(
            value->where,
            is_builtin_response(name)
                ? fmt::format("the measured response of film {} is not at hand: no film response "
                              "is applied; name a file with its curves",
                              in_quotes(name))
                : fmt::format("no file {} can be read: no film response is applied",
                              in_quotes(name)));
        return nullptr;
    }
    try {
        return std::make_shared<const CameraResponse>(read_camera_response(file));
    } catch (const ResponseFileError& error) {
        diagnostics.warning(error.where(), fmt::format("{}; this file's film response is not "
                                                       "applied",
                                                       error.what()));
        return nullptr;
    }
}

}  // namespace lxs
