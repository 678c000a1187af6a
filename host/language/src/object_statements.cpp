// Statements of the world block that define objects and place their instances.
#include "scene_reader.h"

namespace lxs {

Inheritance SceneReader::inheritance() const {
    const GraphicsState& graphics = scopes_.graphics;
    return {graphics.material, graphics.material_index, graphics.interior, graphics.exterior};
}

void SceneReader::object_begin(Statement& statement) {
    objects_.begin(take_only_name(statement));
    scopes_.begin(ScopeKind::Object, statement.where);
}

void SceneReader::object_end(Statement& statement) {
    expect_no_arguments(statement);
    objects_.end(statement.where);
    scopes_.end(ScopeKind::Object, statement.where, diagnostics_);
}

void SceneReader::object_instance(Statement& statement) {
    objects_.place(take_only_name(statement), current_transform(), inheritance(), contents_);
}

void SceneReader::motion_instance(Statement& statement) {
    const Name name = take_name(statement, 0);
    // "name" start end "coordinate system at the end"
    const bool well_formed =
        statement.arguments.size() == 3 &&
        std::holds_alternative<std::vector<double>>(statement.arguments[1].values) &&
        std::get<std::vector<double>>(statement.arguments[1].values).size() == 2;
    if (!well_formed) {
        throw InputError(statement.where,
                         "MotionInstance takes \"object\" start end \"coordinate system\"");
    }
    const auto& times = std::get<std::vector<double>>(statement.arguments[1].values);
    const Matrix end = coordinate_system_of(take_name(statement, 2));
    if (!scopes_.motion.empty()) {
        diagnostics_.warning(statement.where,
                             "MotionInstance replaces the motion in force: it starts where that "
                             "begins");
    }
    if (!(times[1] > times[0])) {
        diagnostics_.warning(statement.where,
                             "MotionInstance ends before it starts: the object stands still");
    }
    MovingTransform placed{scopes_.transform, {}};
    if (times[1] > times[0]) placed.motion = {{times[0], scopes_.transform}, {times[1], end}};
    objects_.place(name, placed, inheritance(), contents_);
}

}  // namespace lxs
