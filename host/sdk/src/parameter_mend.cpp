// Mends values: numbers of triples, whole numbers, ranges, bools.
#include "parameter_mend.h"

#include <algorithm>
#include <cmath>

#include "parameter_check.h"
#include "parameter_text.h"

namespace lxs {
namespace {

using Type = ParameterType;

bool fits(const ParameterValue& value, const ParameterDeclaration& declaration) {
    try {
        check_parameter(value, declaration, "");
        return true;
    } catch (const InputError&) {
        return false;
    }
}

/// The nearest number that the declaration takes; a range that holds none is a bug elsewhere.
double nearest_in_range(double number, const ParameterDeclaration& declaration) {
    if (declaration.type == Type::Integer) number = std::trunc(number);
    return std::clamp(number, declaration.minimum, declaration.maximum);
}

/// Drops numbers behind the last whole value (the fourth of a colour); what is kept, in words, or
/// nothing if there was none to drop.
std::string drop_remainder(std::vector<double>& numbers, std::size_t components) {
    const std::size_t kept = numbers.size() - numbers.size() % components;
    if (kept == numbers.size() || kept == 0) return {};
    numbers.resize(kept);
    return "the first " + std::to_string(kept) + " are used";
}

std::string used(const std::vector<double>& numbers) {
    if (numbers.size() == 1) return number_text(numbers.front()) + " is used";
    return "the nearest in range is used";
}

}  // namespace

MendedParameter mend_parameter(const ParameterValue& value,
                               const ParameterDeclaration& declaration) {
    ParameterValue mended = value;
    std::string instead;
    if (auto* numbers = std::get_if<std::vector<double>>(&mended.values)) {
        instead = drop_remainder(*numbers, components(declaration.type));
        if (!instead.empty() && fits(mended, declaration)) return {std::move(mended), instead};
        for (double& number : *numbers)
            number = nearest_in_range(number, declaration);
        instead = used(*numbers);
    } else if (declaration.type == Type::Bool && value.type == "bool") {
        mended.values = std::vector<bool>{false};
        instead = "false is used";
    }
    if (!instead.empty() && fits(mended, declaration)) return {std::move(mended), instead};
    return {std::nullopt, declaration.array || declaration.default_text.empty()
                              ? "it is left out"
                              : "its default is used"};
}

}  // namespace lxs
