// Statements that change the current transform.
#include <algorithm>

#include <fmt/format.h>

#include "lxs/language/transforms.h"
#include "scene_reader.h"

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
    if (motion_) return add_motion_key(matrix, where);
    check_invertible(matrix, where);
    scopes_.transform = matrix;
    scopes_.motion.clear();
}

void SceneReader::concatenate(const Matrix& matrix, const SourceLocation& where) {
    check_invertible(matrix, where);
    if (motion_) {  // each of a motion starts from the same transform
        const std::size_t index = std::min(motion_->keys.size(), motion_->times.size() - 1);
        return add_motion_key(matrix * motion_->base.at(motion_->times[index]), where);
    }
    const Matrix product = matrix * scopes_.transform;
    check_invertible(product, where);
    scopes_.transform = product;
    for (MotionKey& key : scopes_.motion) {
        key.matrix = matrix * key.matrix;
        check_invertible(key.matrix, where);
    }
}

void SceneReader::add_motion_key(const Matrix& matrix, const SourceLocation& where) {
    if (motion_->keys.size() == motion_->times.size()) {
        throw IgnoredStatement(where,
                               fmt::format("MotionBegin lists {} times, but more transforms follow",
                                           motion_->times.size()));
    }
    check_invertible(matrix, where);
    motion_->keys.push_back({motion_->times[motion_->keys.size()], matrix});
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

const Matrix& SceneReader::coordinate_system_of(const Name& name) {
    const auto found = coordinate_systems_.find(name.text);
    if (found == coordinate_systems_.end()) {
        throw IgnoredStatement(name.where, unknown_.message("coordinate system", name.text, [this] {
            return names_of(coordinate_systems_);
        }));
    }
    return found->second;
}

void SceneReader::coord_sys_transform(Statement& statement) {
    set_transform(coordinate_system_of(take_only_name(statement)), statement.where);
}

const Matrix& SceneReader::still_transform(const char* noun, const SourceLocation& where) {
    if (!scopes_.motion.empty()) {
        diagnostics_.warning(where,
                             fmt::format("only ObjectInstance and Camera move: this {} stays "
                                         "where its motion begins",
                                         noun));
    }
    return scopes_.transform;
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
    std::vector<double> times = take_number_list(statement);
    if (times.empty()) throw InputError(statement.where, "MotionBegin takes at least one time");
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (!(times[i] > times[i - 1])) {
            throw InputError(statement.where, fmt::format("MotionBegin takes ascending times, but "
                                                          "{} comes after {}",
                                                          times[i], times[i - 1]));
        }
    }
    motion_ = MotionBlock{statement.where, std::move(times), {}, current_transform()};
}

void SceneReader::motion_end(Statement& statement) {
    expect_no_arguments(statement);
    if (!motion_) throw IgnoredStatement(statement.where, "MotionEnd without MotionBegin");
    MotionBlock block = std::move(*motion_);
    motion_.reset();
    if (block.keys.size() != block.times.size()) {
        throw IgnoredStatement(block.where,
                               fmt::format("MotionBegin lists {} times, but {} transforms follow",
                                           block.times.size(), block.keys.size()));
    }
    scopes_.transform = block.keys.front().matrix;
    scopes_.motion.clear();
    if (block.keys.size() > 1) scopes_.motion = std::move(block.keys);
}

}  // namespace lxs
