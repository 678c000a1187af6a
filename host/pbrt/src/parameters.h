// The parameters of one directive, with pbrt's types: checked as they are asked for, told of when
// nobody asked.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "colour_space.h"
#include "lxs/language/arguments.h"
#include "new_statement.h"

namespace lxs::pbrt {

class Parameters {
  public:
    /// `defaults`: what directives Attribute have set for directives of the kind; those that nobody
    /// asks for are not told of.
    Parameters(ParameterSet set, const std::vector<ParameterValue>& defaults,
               const ColourSpace& space, Diagnostics& diagnostics);

    const std::string& plugin() const { return set_.plugin; }
    const SourceLocation& where() const { return set_.where; }
    /// Where the parameter stands, or the directive if it isn't given.
    const SourceLocation& where(std::string_view name) const;
    bool given(std::string_view name) const { return find(name) != nullptr; }
    /// The value as written, or null; it counts as asked for.
    const ParameterValue* value(std::string_view name) const;

    /// Throw InputError for a value of another type or number. Of several values the first counts,
    /// as in pbrt.
    double number(std::string_view name, double fallback) const;
    int integer(std::string_view name, int fallback) const;
    bool flag(std::string_view name, bool fallback) const;
    std::string text(std::string_view name, std::string_view fallback) const;
    Strings texts(std::string_view name) const;
    /// All numbers of a list, moved out; empty if it isn't given.
    Numbers numbers(std::string_view name);
    std::optional<Vec3> point(std::string_view name) const;
    /// The texture that the parameter names, if it names one.
    std::optional<Name> texture(std::string_view name) const;

    /// A parameter by its name in version 3 is read by that of version 4, which counts if both are
    /// given.
    void rename(std::string_view older, std::string_view name);
    /// Takes a parameter that changes nothing here.
    void ignore(std::string_view name) const { value(name); }
    /// A warning that it isn't rendered, if it is given.
    void leave_out(std::string_view name, std::string_view instead) const;
    /// Tells of all that nobody asked for. `noun`: whose they are.
    void report_unused(std::string_view noun) const;

    /// Those of the directive that nobody asked for; they count as asked for.
    std::vector<const ParameterValue*> rest() const;

    const ColourSpace& space() const { return *space_; }
    Diagnostics& diagnostics() const { return diagnostics_; }
    [[noreturn]] void fail(std::string_view name, const std::string& message) const;

  private:
    const ParameterValue* find(std::string_view name) const;
    ParameterValue* find(std::string_view name);

    ParameterSet set_;
    std::size_t own_;  ///< those of the directive stand first
    const ColourSpace* space_;
    Diagnostics& diagnostics_;
    mutable std::set<std::string, std::less<>> asked_;
};

/// Whether a value is of type "texture"; and whether its type is one of a colour.
bool is_texture(const ParameterValue& value);

}  // namespace lxs::pbrt
