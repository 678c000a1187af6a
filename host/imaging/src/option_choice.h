// Which plugin an option statement of the scene chooses.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "lxs/scene/contents.h"

namespace lxs {

/// An option statement, or LuxRender's default for it when the scene has none.
struct OptionChoice {
    OptionStatement statement;
    bool given = false;
};

/// The option `statement` ("Film", "Camera", ...) of the scene; without one, the plugin `fallback`
/// with no parameters. Throws InputError listing `known` if the plugin's name is none of them.
OptionChoice choose_option(const SceneContents& contents, const std::string& statement,
                           std::string_view fallback, std::initializer_list<std::string> known);

/// The same, but a name that is none of the known ones is reported, and `fallback` is used with
/// those parameters that it has.
OptionChoice choose_option(const SceneContents& contents, const std::string& statement,
                           std::string_view fallback, std::initializer_list<std::string> known,
                           Diagnostics& diagnostics);

}  // namespace lxs
