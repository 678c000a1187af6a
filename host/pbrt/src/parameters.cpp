// Parameters of directives.
#include "parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lxs::pbrt {
namespace {

const Numbers* numbers_of(const ParameterValue& value) {
    const auto* numbers = std::get_if<Numbers>(&value.values);
    return numbers != nullptr && !numbers->empty() ? numbers : nullptr;
}

const SourceLocation& place_of(const ParameterValue& value) {
    return value.value_where.empty() ? value.where : value.value_where.front();
}

[[noreturn]] void fail_type(const ParameterValue& value, std::string_view expected) {
    throw InputError(value.where,
                     fmt::format("parameter {} takes {}, found type {}", in_quotes(value.name),
                                 expected, in_quotes(value.type)));
}

double finite(const ParameterValue& value, double number) {
    if (std::isfinite(number) && std::abs(number) <= 3.4e38) return number;
    throw InputError(
        place_of(value),
        fmt::format("parameter {} takes finite numbers, at most 3.4e38", in_quotes(value.name)));
}

}  // namespace

bool is_texture(const ParameterValue& value) {
    return value.type == "texture";
}

Parameters::Parameters(ParameterSet set, const std::vector<ParameterValue>& defaults,
                       const ColourSpace& space, Diagnostics& diagnostics)
    : set_(std::move(set)), own_(set_.values.size()), space_(&space), diagnostics_(diagnostics) {
    for (std::size_t i = 0; i < own_; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (set_.values[j].name != set_.values[i].name) continue;
            diagnostics.warning(set_.values[i].where,
                                fmt::format("parameter {} is given twice: the first one counts",
                                            in_quotes(set_.values[i].name)));
            break;
        }
    }
    set_.values.insert(set_.values.end(), defaults.begin(), defaults.end());
}

const ParameterValue* Parameters::find(std::string_view name) const {
    const auto found = std::find_if(set_.values.begin(), set_.values.end(),
                                    [&](const ParameterValue& v) { return v.name == name; });
    if (found == set_.values.end()) return nullptr;
    return &*found;
}

ParameterValue* Parameters::find(std::string_view name) {
    return const_cast<ParameterValue*>(std::as_const(*this).find(name));
}

const SourceLocation& Parameters::where(std::string_view name) const {
    const ParameterValue* const value = find(name);
    return value != nullptr ? value->where : set_.where;
}

const ParameterValue* Parameters::value(std::string_view name) const {
    const ParameterValue* const value = find(name);
    if (value != nullptr) asked_.emplace(name);
    return value;
}

double Parameters::number(std::string_view name, double fallback) const {
    const ParameterValue* const given = value(name);
    if (given == nullptr) return fallback;
    const Numbers* const numbers = numbers_of(*given);
    if (numbers == nullptr) fail_type(*given, "a number");
    return finite(*given, numbers->front());
}

int Parameters::integer(std::string_view name, int fallback) const {
    const double given = number(name, fallback);
    if (!(std::abs(given) <= 2147483647.0))
        fail(name, fmt::format("parameter {} takes whole numbers of 32 bits", in_quotes(name)));
    return static_cast<int>(given);
}

bool Parameters::flag(std::string_view name, bool fallback) const {
    const ParameterValue* const given = value(name);
    if (given == nullptr) return fallback;
    if (const auto* flags = std::get_if<std::vector<bool>>(&given->values))
        if (!flags->empty()) return flags->front();
    const auto* texts = std::get_if<Strings>(&given->values);
    if (texts != nullptr && !texts->empty() &&
        (texts->front() == "true" || texts->front() == "false"))
        return texts->front() == "true";
    fail_type(*given, "true or false");
}

std::string Parameters::text(std::string_view name, std::string_view fallback) const {
    const ParameterValue* const given = value(name);
    if (given == nullptr) return std::string(fallback);
    const auto* texts = std::get_if<Strings>(&given->values);
    if (texts == nullptr || texts->empty()) fail_type(*given, "a string");
    return texts->front();
}

Strings Parameters::texts(std::string_view name) const {
    const ParameterValue* const given = value(name);
    if (given == nullptr) return {};
    const auto* texts = std::get_if<Strings>(&given->values);
    if (texts == nullptr) fail_type(*given, "strings");
    return *texts;
}

Numbers Parameters::numbers(std::string_view name) {
    ParameterValue* const given = find(name);
    if (given == nullptr) return {};
    asked_.emplace(name);
    auto* numbers = std::get_if<Numbers>(&given->values);
    if (numbers == nullptr) fail_type(*given, "numbers");
    return std::move(*numbers);
}

std::optional<Vec3> Parameters::point(std::string_view name) const {
    const ParameterValue* const given = value(name);
    if (given == nullptr) return std::nullopt;
    const Numbers* const numbers = numbers_of(*given);
    if (numbers == nullptr || numbers->size() < 3) fail_type(*given, "three numbers");
    Vec3 result;
    for (int i = 0; i < 3; ++i)
        result[i] = static_cast<float>(finite(*given, (*numbers)[static_cast<std::size_t>(i)]));
    return result;
}

std::optional<Name> Parameters::texture(std::string_view name) const {
    const ParameterValue* const given = find(name);
    if (given == nullptr || !is_texture(*given)) return std::nullopt;
    return Name{text(name, ""), place_of(*given)};
}

void Parameters::rename(std::string_view older, std::string_view name) {
    ParameterValue* const given = find(older);
    if (given == nullptr) return;
    if (find(name) == nullptr) {
        given->name = name;
    } else {
        ignore(older);
    }
}

void Parameters::leave_out(std::string_view name, std::string_view instead) const {
    if (const ParameterValue* const given = value(name)) {
        diagnostics_.warning(given->where,
                             fmt::format("{} of {} is not rendered: {}", in_quotes(name),
                                         in_quotes(set_.plugin), instead));
    }
}

std::vector<const ParameterValue*> Parameters::rest() const {
    std::vector<const ParameterValue*> values;
    for (std::size_t i = 0; i < own_; ++i)
        if (asked_.insert(set_.values[i].name).second) values.push_back(&set_.values[i]);
    return values;
}

void Parameters::report_unused(std::string_view noun) const {
    for (std::size_t i = 0; i < own_; ++i) {
        const ParameterValue& value = set_.values[i];
        if (asked_.contains(value.name)) continue;
        diagnostics_.unknown_parameter(
            value.where, fmt::format("unknown parameter {} of {} {}", in_quotes(value.name), noun,
                                     in_quotes(set_.plugin)));
        asked_.insert(value.name);
    }
}

void Parameters::fail(std::string_view name, const std::string& message) const {
    const ParameterValue* const value = find(name);
    throw InputError(value != nullptr ? place_of(*value) : set_.where, message);
}

}  // namespace lxs::pbrt
