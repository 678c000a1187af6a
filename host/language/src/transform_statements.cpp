// Statements that change the current transform.
#include <fmt/format.h>

#include "scene_reader.h"
#include "transforms.h"

namespace lxs {
namespace {

/// The statement's `Count` numbers.
template <std::size_t Count>
std::array<double, Count> fixed_numbers(const Statement& statement) {
    const std::vector<double> numbers = take_numbers(statement, Count);
    std::array<double, Count> result{};
    std::copy(numbers.begin(), numbers.end(), result.begin());
    return result;
}

}  // namespace

void SceneReader::set_transform(const Matrix& matrix, const SourceLocation& where) {
    check_invertible(matrix, where);
    if (motion_ && motion_->transforms++ > 0) return;
    scopes_.transform = matrix;
}

void SceneReader::concatenate(const Matrix& matrix, const SourceLocation& where) {
    check_invertible(matrix, where);
    if (motion_ && motion_->transforms > 0) {  // each of a motion starts from the same transform
        ++motion_->transforms;
        return;
    }
    set_transform(matrix * scopes_.transform, where);
}

void SceneReader::identity(Statement& statement) {
    expect_no_arguments(statement);
    set_transform(Matrix(), statement.where);
}

void SceneReader::translate(Statement& statement) {
    concatenate(translation(fixed_numbers<3>(statement)), statement.where);
}

void SceneReader::scale(Statement& statement) {
    concatenate(scaling(fixed_numbers<3>(statement)), statement.where);
}

void SceneReader::rotate(Statement& statement) {
    const auto numbers = fixed_numbers<4>(statement);
    const std::span<const double, 4> all(numbers);
    concatenate(rotation(all[0], all.subspan<1, 3>(), statement.where), statement.where);
}

void SceneReader::look_at_statement(Statement& statement) {
    concatenate(look_at(fixed_numbers<9>(statement), statement.where), statement.where);
}

void SceneReader::transform(Statement& statement) {
    set_transform(listed_matrix(fixed_numbers<16>(statement), statement.where), statement.where);
}

void SceneReader::concat_transform(Statement& statement) {
    concatenate(listed_matrix(fixed_numbers<16>(statement), statement.where), statement.where);
}

void SceneReader::coordinate_system(Statement& statement) {
    coordinate_systems_[take_only_name(statement).text] = scopes_.transform;
}

void SceneReader::coord_sys_transform(Statement& statement) {
    const Name name = take_only_name(statement);
    const auto found = coordinate_systems_.find(name.text);
    if (found == coordinate_systems_.end()) {
        std::vector<std::string> known;
        for (const auto& entry : coordinate_systems_)
            known.push_back(entry.first);
        throw InputError(name.where, unknown_name_message("coordinate system", name.text, known));
    }
    set_transform(found->second, statement.where);
}

void SceneReader::transform_begin(Statement& statement) {
    expect_no_arguments(statement);
    scopes_.begin(ScopeKind::Transform, statement.where);
}

void SceneReader::transform_end(Statement& statement) {
    expect_no_arguments(statement);
    scopes_.end(ScopeKind::Transform, statement.where, diagnostics_);
}

void SceneReader::motion_begin(Statement& statement) {
    const std::size_t times = take_number_list(statement).size();
    if (times == 0) throw InputError(statement.where, "MotionBegin takes at least one time");
    if (times > 1) {
        diagnostics_.warning(statement.where,
                             "motion is not rendered yet: the first transform is used");
    }
    motion_ = Motion{statement.where, times, 0};
}

void SceneReader::motion_end(Statement& statement) {
    expect_no_arguments(statement);
    if (!motion_) throw InputError(statement.where, "MotionEnd without MotionBegin");
    if (motion_->transforms != motion_->times) {
        throw InputError(motion_->where,
                         fmt::format("MotionBegin lists {} times, but {} transforms follow",
                                     motion_->times, motion_->transforms));
    }
    motion_.reset();
}

}  // namespace lxs
