// ParameterReader: checks a statement's parameters once, then hands out their values.
#include <algorithm>
#include <set>

#include "lxs/sdk/parameters.h"
#include "parameter_check.h"
#include "parameter_mend.h"

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
        if (declaration.name != value.name && declaration.older_name != value.name) continue;
        if (!named || is_vector(value) == (declaration.type == ParameterType::Vector))
            named = &declaration;
    }
    return named;
}

template <class Predicate>
const ParameterValue* last_value(const ParameterSet& set, const Predicate& fits) {
    const auto found = std::find_if(set.values.rbegin(), set.values.rend(), fits);
    return found == set.values.rend() ? nullptr : &*found;
}

const ParameterValue* last_value(const ParameterSet& set, std::string_view name) {
    return last_value(set, [&](const ParameterValue& value) { return value.name == name; });
}

/// The last value of `name` that is, or isn't, written as a vector.
const ParameterValue* last_value(const ParameterSet& set, std::string_view name, bool vector) {
    return last_value(set, [&](const ParameterValue& value) {
        return value.name == name && is_vector(value) == vector;
    });
}

std::string prefix(const ParameterSet& set) {
    return set.plugin.empty() ? "" : set.plugin + ": ";
}

std::string quoted_list(const std::vector<std::string_view>& names) {
    std::string text;
    for (const std::string_view name : names) {
        text += text.empty() ? "" : ", ";
        text += in_quotes(name);
    }
    return text;
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
    for (const ParameterDeclaration& d : declarations) {
        known.emplace_back(d.name);
        if (!d.older_name.empty()) known.emplace_back(d.older_name);
    }
    const std::string nearest = nearest_name(value.name, known);
    std::string message = prefix(set) + "unknown parameter " + in_quotes(value.name);
    if (!nearest.empty()) message += "; did you mean \"" + nearest + "\"?";
    diagnostics.unknown_parameter(value.where, message);
}

/// What is used if `value` does not fit, which is reported; nothing if it does.
std::optional<MendedParameter> misfit(const ParameterValue& value,
                                      const ParameterDeclaration& declaration,
                                      const std::string& plugin, Diagnostics& diagnostics) {
    ParameterDeclaration spelled = declaration;
    spelled.name = value.name;
    try {
        check_written_type(value);
        check_parameter(value, spelled, plugin);
        return std::nullopt;
    } catch (const InputError& error) {
        MendedParameter mended = mend_parameter(value, spelled);
        diagnostics.fallback(error.where(), error.message(), mended.instead);
        return mended;
    }
}

/// One warning for all parameters of the set that are accepted but do nothing.
void report_no_effect(const ParameterSet& set, const std::vector<const ParameterValue*>& values,
                      Diagnostics& diagnostics) {
    if (values.empty()) return;
    std::vector<std::string_view> names;
    names.reserve(values.size());
    for (const ParameterValue* value : values)
        names.push_back(value->name);
    diagnostics.warning(values.front()->where,
                        prefix(set) + quoted_list(names) +
                            (names.size() == 1 ? " has no effect here" : " have no effect here"));
}

/// A value under an older name beside others of the same under the names of today.
void report_superseded(const ParameterSet& set, const ParameterValue& older,
                       std::span<const ParameterDeclaration> declarations,
                       Diagnostics& diagnostics) {
    std::vector<std::string_view> used;
    for (const ParameterDeclaration& declaration : declarations) {
        if (declaration.older_name != older.name) continue;
        const ParameterValue* newer = last_value(set, declaration.name);
        if (newer && newer->values != older.values) used.push_back(declaration.name);
    }
    if (used.empty()) return;
    diagnostics.warning(older.where, prefix(set) + quoted_list(used) +
                                         (used.size() == 1 ? " is" : " are") +
                                         " used in place of " + in_quotes(older.name));
}

}  // namespace

ParameterReader::ParameterReader(const ParameterSet& set,
                                 std::span<const ParameterDeclaration> declarations,
                                 Diagnostics& diagnostics)
    : set_(&set), declarations_(declarations), diagnostics_(diagnostics) {
    std::vector<const ParameterValue*> without_effect;
    std::vector<Mend> mends;
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
        } else if (auto wrong = misfit(value, *declaration, set.plugin, diagnostics)) {
            mends.push_back({i, std::move(wrong->value)});
        } else {
            report_superseded(set, value, declarations, diagnostics);
        }
    }
    report_no_effect(set, without_effect, diagnostics);
    if (!mends.empty()) mend(std::move(mends), is_overridden);
}

void ParameterReader::mend(std::vector<Mend> mends, const std::vector<bool>& is_overridden) {
    auto mended = std::make_shared<ParameterSet>();
    mended->plugin = set_->plugin;
    mended->where = set_->where;
    auto next = mends.begin();
    for (std::size_t i = 0; i < set_->values.size(); ++i) {
        const bool wrong = next != mends.end() && next->index == i;
        if (wrong && next->value) mended->values.push_back(std::move(*next->value));
        // One that was overridden must not come back in place of what was wrong.
        if (!wrong && !is_overridden[i]) mended->values.push_back(set_->values[i]);
        if (wrong) ++next;
    }
    set_ = mended.get();
    mended_ = std::move(mended);
}

double ParameterReader::number(std::string_view name, double fallback) const {
    const Numbers* numbers = numbers_of(last_value(*set_, spelling(name), false), 1);
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
    if (!numbers) numbers = numbers_of(last_value(*set_, spelling(name), true), 3);
    if (!numbers) return fallback;
    return {static_cast<float>((*numbers)[0]), static_cast<float>((*numbers)[1]),
            static_cast<float>((*numbers)[2])};
}

std::span<const double> ParameterReader::numbers(std::string_view name) const {
    const Numbers* numbers = numbers_of(find(name), 1);
    return numbers ? std::span<const double>(*numbers) : std::span<const double>();
}

std::vector<std::string> ParameterReader::strings(std::string_view name) const {
    const ParameterValue* value = find(name);
    const auto* strings = value ? std::get_if<std::vector<std::string>>(&value->values) : nullptr;
    return strings ? *strings : std::vector<std::string>();
}

std::optional<std::string> ParameterReader::texture_name(std::string_view name) const {
    const ParameterValue* value = find(name);
    if (!value || !is_texture_reference(*value)) return std::nullopt;
    return std::get<std::vector<std::string>>(value->values).front();
}

const SourceLocation& ParameterReader::where(std::string_view name) const {
    const ParameterValue* value = find(name);
    return value ? value->where : set_->where;
}

void ParameterReader::fail(std::string_view name, const std::string& message) const {
    throw InputError(where(name), message);
}

std::string_view ParameterReader::spelling(std::string_view name) const {
    if (last_value(*set_, name)) return name;
    for (const ParameterDeclaration& declaration : declarations_) {
        if (declaration.name == name && last_value(*set_, declaration.older_name))
            return declaration.older_name;
    }
    return name;
}

const ParameterValue* ParameterReader::find(std::string_view name) const {
    return last_value(*set_, spelling(name));
}

}  // namespace lxs
