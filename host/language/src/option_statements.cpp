// Statements that choose the camera, the film, the integrator and the like.
#include "scene_reader.h"

namespace lxs {

void SceneReader::option(Statement& statement) {
    OptionStatement choice{take_plugin(statement), scopes_.transform, scopes_.motion};
    if (statement.name == "Camera") coordinate_systems_["camera"] = scopes_.transform.inverse();
    const auto [entry, is_new] =
        contents_.options.insert_or_assign(statement.name, std::move(choice));
    if (!is_new) {
        diagnostics_.warning(statement.where,
                             statement.name + " is given twice: the last one counts");
    }
}

}  // namespace lxs
