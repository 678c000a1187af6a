// Directives that change the current transforms: of the moment when the shutter opens, and closes.
#include <fmt/format.h>

#include "lxs/language/transforms.h"
#include "translator.h"

namespace lxs::pbrt {
namespace {

template <std::size_t Count>
std::array<double, Count> fixed_numbers(const Statement& statement) {
    const Numbers numbers = take_numbers(statement, Count);
    std::array<double, Count> result{};
    std::copy(numbers.begin(), numbers.end(), result.begin());
    return result;
}

Numbers listed(const Matrix& m) {
    Numbers numbers;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            numbers.push_back(m[i][j]);
    return numbers;
}

}  // namespace

void Translator::concatenate(const Matrix& matrix, const SourceLocation& where) {
    check_invertible(matrix, where);
    for (unsigned i = 0; i < 2; ++i) {
        if (!(state_.active & (1u << i))) continue;
        const Matrix product = matrix * state_.transforms[i];
        check_invertible(product, where);
        state_.transforms[i] = product;
    }
}

void Translator::identity(Statement& statement) {
    expect_no_arguments(statement);
    for (unsigned i = 0; i < 2; ++i)
        if (state_.active & (1u << i)) state_.transforms[i] = Matrix();
}

void Translator::translate_directive(Statement& statement) {
    concatenate(translation(fixed_numbers<3>(statement)), statement.where);
}

void Translator::scale(Statement& statement) {
    concatenate(scaling(fixed_numbers<3>(statement)), statement.where);
}

void Translator::rotate(Statement& statement) {
    const auto numbers = fixed_numbers<4>(statement);
    const std::span<const double, 4> all(numbers);
    concatenate(rotation(all[0], all.subspan<1, 3>(), statement.where), statement.where);
}

void Translator::look_at_directive(Statement& statement) {
    // pbrt's world is left-handed: x goes to the right where up is turned onto the view, which is
    // to the left in LuxRender's.
    constexpr std::array<double, 3> kMirror{-1, 1, 1};
    concatenate(look_at(fixed_numbers<9>(statement), statement.where) * scaling(kMirror),
                statement.where);
}

void Translator::transform(Statement& statement) {
    const Matrix matrix = listed_matrix(fixed_numbers<16>(statement), statement.where);
    check_invertible(matrix, statement.where);
    for (unsigned i = 0; i < 2; ++i)
        if (state_.active & (1u << i)) state_.transforms[i] = matrix;
}

void Translator::concat_transform(Statement& statement) {
    concatenate(listed_matrix(fixed_numbers<16>(statement), statement.where), statement.where);
}

void Translator::coordinate_system(Statement& statement) {
    coordinate_systems_[take_only_name(statement).text] = state_.transforms;
}

void Translator::coord_sys_transform(Statement& statement) {
    const Name name = take_only_name(statement);
    const auto found = coordinate_systems_.find(name.text);
    if (found == coordinate_systems_.end())  // as pbrt, which goes on
        throw IgnoredStatement(name.where, unknown_name("coordinate system", name.text));
    state_.transforms = found->second;
}

void Translator::active_transform(Statement& statement) {
    // The word behind ActiveTransform has no quotes: it comes as a directive of its own.
    expect_no_arguments(statement);
    if (statement.name == "ActiveTransform") {
        awaits_active_transform_ = true;
        return;
    }
    if (!std::exchange(awaits_active_transform_, false))
        throw InputError(statement.where, statement.name + " stands behind ActiveTransform only");
    state_.active = statement.name == "All" ? 3 : statement.name == "StartTime" ? 1 : 2;
}

void Translator::transform_times(Statement& statement) {
    const auto times = fixed_numbers<2>(statement);
    if (!(times[1] > times[0]))
        throw InputError(statement.where, "TransformTimes takes ascending times");
    times_ = times;
}

bool Translator::moves() const {
    return state_.transforms[0] != state_.transforms[1];
}

void Translator::place(const SourceLocation& where, bool may_move, const char* noun) {
    const auto& [start, end] = state_.transforms;
    if (!may_move && moves())
        warn(where,
             fmt::format("this {} does not move here: it stays where it is when the shutter opens",
                         noun));
    const bool motion = may_move && moves();
    if (!motion && start == Matrix()) return;
    if (motion) add(NewStatement("MotionBegin", where).list({times_[0], times_[1]}));
    add(NewStatement("Transform", where).list(listed(start)));
    if (!motion) return;
    add(NewStatement("Transform", where).list(listed(end)));
    add("MotionEnd", where);
}

}  // namespace lxs::pbrt
