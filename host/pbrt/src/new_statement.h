// A statement of our own language, as the translators write it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lxs/language/statement.h"
#include "lxs/sdk/types.h"

namespace lxs::pbrt {

using Numbers = std::vector<double>;
using Strings = std::vector<std::string>;

class NewStatement {
  public:
    /// All of it stands at `where`, but for what is given another place.
    NewStatement(std::string name, const SourceLocation& where) {
        statement_ = {std::move(name), where, {}};
    }

    /// A name in quotes, or the numbers of a transform.
    NewStatement& name(std::string text) { return add(Strings{std::move(text)}, false, nullptr); }
    NewStatement& list(Numbers numbers) { return add(std::move(numbers), true, nullptr); }

    /// Parameters; `head` is type and name.
    NewStatement& set(const char* head, Numbers values, const SourceLocation* where = nullptr) {
        add(Strings{head}, false, where);
        return add(std::move(values), true, where);
    }
    NewStatement& set(const char* head, double value, const SourceLocation* where = nullptr) {
        return set(head, Numbers{value}, where);
    }
    NewStatement& set(const char* head, int value, const SourceLocation* where = nullptr) {
        return set(head, Numbers{static_cast<double>(value)}, where);
    }
    NewStatement& set(const char* head, const Rgb& value, const SourceLocation* where = nullptr) {
        return set(head, Numbers{value.x, value.y, value.z}, where);
    }
    NewStatement& set(const char* head, const std::string& value,
                      const SourceLocation* where = nullptr) {
        add(Strings{head}, false, where);
        return add(Strings{value}, true, where);
    }
    NewStatement& set(const char* head, const char* value, const SourceLocation* where = nullptr) {
        return set(head, std::string(value), where);
    }
    NewStatement& set_list(const char* head, Strings values,
                           const SourceLocation* where = nullptr) {
        add(Strings{head}, false, where);
        return add(std::move(values), true, where);
    }

    /// A parameter as the scene gives it.
    NewStatement& set(const ParameterValue& value) {
        add(Strings{value.type + " " + value.name}, false, &value.where);
        statement_.arguments.push_back({value.where, value.values, value.value_where, true});
        return *this;
    }

    const SourceLocation& where() const { return statement_.where; }
    Statement take() { return std::move(statement_); }

  private:
    template <class Values>
    NewStatement& add(Values values, bool bracketed, const SourceLocation* where) {
        const SourceLocation& at = where != nullptr ? *where : statement_.where;
        statement_.arguments.push_back({at, std::move(values), {}, bracketed});
        return *this;
    }

    Statement statement_;
};

}  // namespace lxs::pbrt
