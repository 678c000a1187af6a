// ParameterReader: checks a statement's parameters once, then hands out their values.
#include <algorithm>
#include <set>

#include "lxs/sdk/parameters.h"
#include "parameter_check.h"

namespace lxs {
namespace {

using Numbers = std::vector<double>;

bool is_vector(const ParameterValue& value) {
    return value.type == "vector";
}

const Numbers* numbers_of(const ParameterValue* value, std::size_t at_least) {
    const auto* numbers = value ? std::get_if<Numbers>(&value->values) : nullptr;
    return numbers && numbers->size() >= at_least ? numbers : nullptr;
}

/// The declaration of a value's name. A vector and a number of one name may both be declared:
/// LuxRender's marble has a "float scale" of its own and the "vector scale" of its mapping.
const ParameterDeclaration* declared(std::span<const ParameterDeclaration> declarations,
                                     const ParameterValue& value) {
    const ParameterDeclaration* named = nullptr;
    for (const ParameterDeclaration& declaration : declarations) {
        if (declaration.name != value.name) continue;
        if (!named || is_vector(value) == (declaration.type == ParameterType::Vector))
            named = &declaration;
    }
    return named;
}

/// The last value of `name` that is, or isn't, written as a vector.
const ParameterValue* last_value(const ParameterSet& set, std::string_view name, bool vector) {
    const auto found = std::find_if(set.values.rbegin(), set.values.rend(), [&](const auto& value) {
        return value.name == name && is_vector(value) == vector;
    });
    return found == set.values.rend() ? nullptr : &*found;
}

/// For each value of the set, whether a later one is for the same parameter.
std::vector<bool> overridden(const ParameterSet& set,
                             std::span<const ParameterDeclaration> declarations) {
    std::set<std::pair<std::string_view, const ParameterDeclaration*>> later;
    std::vector<bool> result(set.values.size());
    for (std::size_t i = set.values.size(); i-- > 0;) {
        const ParameterValue& value = set.values[i];
        result[i] = !later.emplace(value.name, declared(declarations, value)).second;
    }
    return result;
}

void report_unknown(const ParameterSet& set, const ParameterValue& value,
                    std::span<const ParameterDeclaration> declarations, Diagnostics& diagnostics) {
    std::vector<std::string> known;
    for (const ParameterDeclaration& d : declarations)
        known.emplace_back(d.name);
    const std::string nearest = nearest_name(value.name, known);
    std::string message = set.plugin.empty() ? "" : set.plugin + ": ";
    message += "unknown parameter " + in_quotes(value.name);
    if (!nearest.empty()) message += "; did you mean \"" + nearest + "\"?";
    diagnostics.unknown_parameter(value.where, message);
}

/// One warning for all parameters of the set that are accepted but do nothing.
void report_no_effect(const ParameterSet& set, const std::vector<const ParameterValue*>& values,
                      Diagnostics& diagnostics) {
    if (values.empty()) return;
    std::string message = set.plugin.empty() ? "" : set.plugin + ": ";
    for (std::size_t i = 0; i < values.size(); ++i) {
        message += (i == 0 ? "" : ", ") + in_quotes(values[i]->name);
    }
    message += values.size() == 1 ? " has no effect here" : " have no effect here";
    diagnostics.warning(values.front()->where, message);
}

}  // namespace

ParameterReader::ParameterReader(const ParameterSet& set,
                                 std::span<const ParameterDeclaration> declarations,
                                 Diagnostics& diagnostics)
    : set_(set), diagnostics_(diagnostics) {
    std::vector<const ParameterValue*> without_effect;
    const std::vector<bool> is_overridden = overridden(set, declarations);
    for (std::size_t i = 0; i < set.values.size(); ++i) {
        const ParameterValue& value = set.values[i];
        const ParameterDeclaration* declaration = declared(declarations, value);
        if (is_overridden[i]) {
            diagnostics.warning(value.where,
                                in_quotes(value.name) + " is given twice: the last one counts");
        } else if (!declaration) {
            report_unknown(set, value, declarations, diagnostics);
        } else if (declaration->no_effect) {
            without_effect.push_back(&value);
        } else {
            check_parameter(value, *declaration, set.plugin);
        }
    }
    report_no_effect(set, without_effect, diagnostics);
}

double ParameterReader::number(std::string_view name, double fallback) const {
    const Numbers* numbers = numbers_of(last_value(set_, name, false), 1);
    return numbers ? numbers->front() : fallback;
}

std::int64_t ParameterReader::integer(std::string_view name, std::int64_t fallback) const {
    const Numbers* numbers = numbers_of(find(name), 1);
    return numbers ? static_cast<std::int64_t>(numbers->front()) : fallback;
}

bool ParameterReader::boolean(std::string_view name, bool fallback) const {
    const ParameterValue* value = find(name);
    const auto* bools = value ? std::get_if<std::vector<bool>>(&value->values) : nullptr;
    return bools && !bools->empty() ? bools->front() : fallback;
}

std::string ParameterReader::string(std::string_view name, std::string_view fallback) const {
    const ParameterValue* value = find(name);
    const auto* strings = value ? std::get_if<std::vector<std::string>>(&value->values) : nullptr;
    return strings && !strings->empty() ? strings->front() : std::string(fallback);
}

Rgb ParameterReader::color(std::string_view name, const Rgb& fallback) const {
    const Vec3 v = vector(name, Vec3(fallback.x, fallback.y, fallback.z));
    return {v.x, v.y, v.z};
}

Vec3 ParameterReader::vector(std::string_view name, const Vec3& fallback) const {
    const Numbers* numbers = numbers_of(find(name), 3);
    if (!numbers) numbers = numbers_of(last_value(set_, name, true), 3);
    if (!numbers) return fallback;
    return {static_cast<float>((*numbers)[0]), static_cast<float>((*numbers)[1]),
            static_cast<float>((*numbers)[2])};
}

std::span<const double> ParameterReader::numbers(std::string_view name) const {
    const Numbers* numbers = numbers_of(find(name), 1);
    return numbers ? std::span<const double>(*numbers) : std::span<const double>();
}

std::optional<std::string> ParameterReader::texture_name(std::string_view name) const {
    const ParameterValue* value = find(name);
    if (!value || !is_texture_reference(*value)) return std::nullopt;
    return std::get<std::vector<std::string>>(value->values).front();
}

const SourceLocation& ParameterReader::where(std::string_view name) const {
    const ParameterValue* value = find(name);
    return value ? value->where : set_.where;
}

void ParameterReader::fail(std::string_view name, const std::string& message) const {
    throw InputError(where(name), message);
}

const ParameterValue* ParameterReader::find(std::string_view name) const {
    const auto found = std::find_if(set_.values.rbegin(), set_.values.rend(),
                                    [&](const auto& value) { return value.name == name; });
    return found == set_.values.rend() ? nullptr : &*found;
}

}  // namespace lxs
