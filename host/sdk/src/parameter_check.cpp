// Type, count, range and choice checks of parameters.
#include "parameter_check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "parameter_text.h"

namespace lxs {
namespace {

using Type = ParameterType;
using Numbers = std::vector<double>;
using Strings = std::vector<std::string>;
using Bools = std::vector<bool>;

constexpr double kLargestInteger = 9007199254740992.0;  // 2^53: whole numbers are exact up to it

bool accepts_texture(Type type) {
    return type == Type::FloatTexture || type == Type::ColorTexture || type == Type::FresnelTexture;
}

/// Scene-file types whose numbers a declared type takes.
bool accepts_numbers_of(Type declared, std::string_view written) {
    switch (declared) {
        case Type::Float:
        case Type::Integer:
        case Type::FloatTexture:
        case Type::FresnelTexture:
            return written == "float" || written == "integer";
        case Type::Color:
        case Type::ColorTexture:
            return written == "color" || written == "rgb";
        case Type::Point:
        case Type::Vector:
        case Type::Normal:
            return written == type_name(declared);
        case Type::Bool:
        case Type::String:
            return false;
    }
    return false;
}

std::size_t value_count(const ParameterValue& value) {
    return std::visit([](const auto& list) { return list.size(); }, value.values);
}

/// What a value of the wrong kind is, in words.
std::string found_text(const ParameterValue& value) {
    std::string text = "a value of type " + value.type;
    const bool textual = value.type == "string" || value.type == "bool" || value.type == "texture";
    if (is_texture_reference(value) && value.type != "texture") text += " naming a texture";
    if (std::holds_alternative<Numbers>(value.values) && textual) text += " holding numbers";
    if (std::holds_alternative<Bools>(value.values) && value.type != "bool")
        text += " holding bools";
    return text;
}

/// One check of one value; keeps what the messages need.
class Check {
  public:
    Check(const ParameterValue& value, const ParameterDeclaration& declaration,
          const std::string& plugin)
        : value_(value), declaration_(declaration), plugin_(plugin) {}

    void run() const {
        // An empty list holds no values whose kind could be wrong.
        if (value_count(value_) == 0) {
            if (!declaration_.array) fail("has no value");
        } else if (is_texture_reference(value_)) {
            check_texture();
        } else if (const auto* numbers = std::get_if<Numbers>(&value_.values)) {
            check_numbers(*numbers);
        } else if (const auto* strings = std::get_if<Strings>(&value_.values)) {
            check_strings(*strings);
        } else {
            check_type(declaration_.type == Type::Bool && value_.type == "bool");
            check_single(std::get<Bools>(value_.values).size());
        }
    }

  private:
    [[noreturn]] void fail(const std::string& what) const { fail_at(value_.where, what); }
    [[noreturn]] void fail_at(const SourceLocation& where, const std::string& what) const {
        const std::string prefix = plugin_.empty() ? std::string() : plugin_ + ": ";
        throw InputError(where, prefix + in_quotes(declaration_.name) + " " + what);
    }
    const SourceLocation& where_value(std::size_t index) const {
        return index < value_.value_where.size() ? value_.value_where[index] : value_.where;
    }

    void check_type(bool fits) const {
        if (!fits) fail("takes " + written_form(declaration_) + ", found " + found_text(value_));
    }
    void check_single(std::size_t count) const {
        if (declaration_.array || count == 1) return;
        fail("takes one value, found " + std::to_string(count));
    }
    void check_texture() const {
        check_type(accepts_texture(declaration_.type));
        check_single(std::get<Strings>(value_.values).size());
    }
    void check_numbers(const Numbers& numbers) const;
    void check_strings(const Strings& strings) const;

    const ParameterValue& value_;
    const ParameterDeclaration& declaration_;
    const std::string& plugin_;
};

void Check::check_numbers(const Numbers& numbers) const {
    check_type(accepts_numbers_of(declaration_.type, value_.type));
    const std::size_t size = components(declaration_.type);
    if (!declaration_.array && numbers.size() != size) {
        fail("takes " + std::to_string(size) + (size == 1 ? " number" : " numbers") + ", found " +
             std::to_string(numbers.size()));
    }
    if (numbers.size() % size != 0) {
        fail("takes numbers in groups of " + std::to_string(size) + ", found " +
             std::to_string(numbers.size()));
    }
    const bool whole = declaration_.type == Type::Integer;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double number = numbers[i];
        if (!std::isfinite(number)) {
            if (declaration_.holds_any_number) continue;
            fail_at(where_value(i), "takes finite numbers, at most 3.4e38");
        }
        if (whole && (number != std::trunc(number) || std::abs(number) > kLargestInteger)) {
            fail_at(where_value(i),
                    "takes a whole number of at most 2^53, found " + number_text(number));
        }
        if (number < declaration_.minimum || number > declaration_.maximum) {
            fail_at(where_value(i), "is out of range: " + number_text(number) + " is not " +
                                        range_text(declaration_));
        }
    }
}

void Check::check_strings(const Strings& strings) const {
    if (declaration_.type == Type::Bool && value_.type == "bool") {
        fail_at(where_value(0), "takes \"true\" or \"false\", found " + in_quotes(strings.front()));
    }
    check_type(declaration_.type == Type::String && value_.type == "string");
    check_single(strings.size());
    if (declaration_.choices.empty()) return;
    const Strings known(declaration_.choices.begin(), declaration_.choices.end());
    for (std::size_t i = 0; i < strings.size(); ++i) {
        if (std::find(known.begin(), known.end(), strings[i]) != known.end()) continue;
        const std::string prefix = plugin_.empty() ? std::string() : plugin_ + ": ";
        throw InputError(where_value(i),
                         prefix + unknown_name_message(declaration_.name, strings[i], known));
    }
}

}  // namespace

std::span<const std::string_view> written_types() {
    static constexpr std::array<std::string_view, 10> kTypes = {
        "float",  "integer", "bool",    "point", "vector",
        "normal", "string",  "texture", "color", "rgb"};
    return kTypes;
}

std::size_t components(Type type) {
    const bool triple = type == Type::Color || type == Type::ColorTexture || type == Type::Point ||
                        type == Type::Vector || type == Type::Normal;
    return triple ? 3 : 1;
}

void check_written_type(const ParameterValue& value) {
    if (value.type.empty()) {
        throw InputError(value.where,
                         "a parameter begins with \"type name\", found " + in_quotes(value.name));
    }
    const Strings known(written_types().begin(), written_types().end());
    if (std::find(known.begin(), known.end(), value.type) == known.end())
        throw InputError(value.where, unknown_name_message("parameter type", value.type, known));
}

bool is_texture_reference(const ParameterValue& value) {
    const auto* strings = std::get_if<Strings>(&value.values);
    return strings && !strings->empty() && value.type != "string" && value.type != "bool";
}

void check_parameter(const ParameterValue& value, const ParameterDeclaration& declaration,
                     const std::string& plugin) {
    Check(value, declaration, plugin).run();
}

}  // namespace lxs
