// Scenes that consist of option statements only, built in the tests' own words.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "lxs/scene/contents.h"
#include "lxs/spectrum/rgb_spectra.h"
#include "temporary_folder.h"

namespace lxs::test {

using files::TemporaryFolder;

/// Keeps what was said; a test looks at it afterwards.
class RecordedDiagnostics : public Diagnostics {
  public:
    std::vector<std::string> warnings, unknown;
    bool lenient = false;  ///< goes on where LuxRender does

    void warning(const SourceLocation& where, const std::string& message) override {
        warnings.push_back(format_message(where, "warning", message));
    }
    void unknown_parameter(const SourceLocation& where, const std::string& message) override {
        unknown.push_back(format_message(where, "warning", message));
    }
    void fallback(const SourceLocation& where, const std::string& message,
                  const std::string& instead) override {
        if (!lenient) return Diagnostics::fallback(where, message, instead);
        warning(where, message + "; " + instead);
    }
};

/// A place in "scene.lxs" without text, so that messages are one line.
inline SourceLocation place(std::uint32_t line, std::uint32_t column) {
    static const auto file =
        std::make_shared<const SourceFile>(SourceFile{"scene.lxs", nullptr, nullptr, 0});
    return {file, line, column};
}

inline ParameterValue numbers(const std::string& type, const std::string& name,
                              std::vector<double> values) {
    return {type, name, std::move(values), place(2, 5), {}};
}
inline ParameterValue integer(const std::string& name, double value) {
    return numbers("integer", name, {value});
}
inline ParameterValue real(const std::string& name, double value) {
    return numbers("float", name, {value});
}
inline ParameterValue text(const std::string& name, const std::string& value) {
    return {"string", name, std::vector<std::string>{value}, place(2, 5), {}};
}
inline ParameterValue flag(const std::string& name, bool value) {
    return {"bool", name, std::vector<bool>{value}, place(2, 5), {}};
}

/// A scene with one light group and no statement.
inline SceneContents empty_scene() {
    SceneContents contents;
    contents.light_groups = {"default"};
    contents.end = place(9, 1);
    return contents;
}

inline OptionStatement& set_option(SceneContents& contents, const std::string& statement,
                                   const std::string& plugin, std::vector<ParameterValue> values) {
    OptionStatement& option = contents.options[statement];
    option.parameters = {plugin, place(1, 6), std::move(values)};
    return option;
}

/// A scene with a film of this size, which keeps the scene's colours, and the box filter of one
/// pixel.
inline SceneContents scene_of_size(int width, int height) {
    const auto chromaticity = [](const char* name, const std::array<double, 2>& c) {
        return numbers("float", name, {c[0], c[1]});
    };
    SceneContents contents = empty_scene();
    set_option(
        contents, "Film", "fleximage",
        {integer("xresolution", width), integer("yresolution", height),
         chromaticity("colorspace_red", kSceneRed), chromaticity("colorspace_green", kSceneGreen),
         chromaticity("colorspace_blue", kSceneBlue),
         chromaticity("colorspace_white", kSceneWhite)});
    set_option(contents, "PixelFilter", "box", {});
    return contents;
}

/// Runs `action` and gives the text of the InputError that it throws, "" if none.
template <class Action>
std::string input_error(const Action& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace lxs::test
