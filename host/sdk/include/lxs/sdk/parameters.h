// Parameters of plugins: declared once, read and checked against the declaration.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lxs/sdk/diagnostics.h"
#include "lxs/sdk/types.h"

namespace lxs {

enum class ParameterType : std::uint8_t {
    Float,
    Integer,
    Bool,
    String,
    Color,
    Point,
    Vector,
    Normal,
    FloatTexture,   ///< written "float n" [v] or "texture n" ["name"]
    ColorTexture,   ///< written "color n" [r g b] or "texture n" ["name"]
    FresnelTexture  ///< written "texture n" ["name"] or "float n" [index]
};

/// One declared parameter. Help, validation and the reference page are made from it.
struct ParameterDeclaration {
    std::string_view name;
    ParameterType type = ParameterType::Float;
    std::string_view default_text = {};  ///< as it would stand in a scene file, for docs; "" = none
    std::string_view doc = {};           ///< one sentence, with the unit
    double minimum = -std::numeric_limits<double>::infinity();  ///< inclusive, numbers only
    double maximum = std::numeric_limits<double>::infinity();   ///< inclusive, numbers only
    std::span<const std::string_view> choices = {};             ///< allowed strings; empty = any
    bool array = false;                                         ///< takes any number of values
    bool no_effect = false;  ///< accepted for compatibility; said once when a scene sets it
    /// Numbers need not be finite: whoever reads them deals with those that aren't.
    bool holds_any_number = false;
    /// Another name of the same, which counts where `name` isn't given; several declarations may
    /// share one.
    std::string_view older_name = {};
    /// Heading above it and those of the same group that follow, in help; "" = none.
    std::string_view group = {};
};

/// One parameter as a scene file gives it.
struct ParameterValue {
    std::string type;  ///< as written: float, integer, ...; "" or no type at all if misspelt
    std::string name;
    std::variant<std::vector<double>, std::vector<std::string>, std::vector<bool>> values;
    SourceLocation where;                     ///< of the "type name" string
    std::vector<SourceLocation> value_where;  ///< of each value, for short lists only; may be empty
};

/// The parameters of one statement.
struct ParameterSet {
    std::string plugin;    ///< plugin name, e.g. "matte"
    SourceLocation where;  ///< of the plugin name
    std::vector<ParameterValue> values;
};

/// Reads a ParameterSet against declarations. The constructor reports unknown names (with the
/// nearest known one), and Diagnostics::fallback()s wrong types, wrong counts and unknown choices,
/// which leave the default, and values out of range, which become the nearest in it. A name given
/// twice: the last one counts, with a warning. Older names are read as the names of today, which
/// count, with a warning, where both are given and differ. Set, declarations and diagnostics must
/// outlive the reader.
class ParameterReader {
  public:
    ParameterReader(const ParameterSet& set, std::span<const ParameterDeclaration> declarations,
                    Diagnostics& diagnostics);

    bool given(std::string_view name) const { return find(name) != nullptr; }
    double number(std::string_view name, double fallback) const;
    std::int64_t integer(std::string_view name, std::int64_t fallback) const;
    bool boolean(std::string_view name, bool fallback) const;
    std::string string(std::string_view name, std::string_view fallback) const;
    Rgb color(std::string_view name, const Rgb& fallback) const;
    Vec3 vector(std::string_view name, const Vec3& fallback) const;
    /// All numbers of an array parameter; empty when not given.
    std::span<const double> numbers(std::string_view name) const;
    /// All strings of an array parameter; empty when not given.
    std::vector<std::string> strings(std::string_view name) const;
    /// Name of the texture that the parameter refers to, if it refers to one.
    std::optional<std::string> texture_name(std::string_view name) const;

    /// The name that the scene gives the parameter: `name`, or its older one where only that is
    /// given.
    std::string_view spelling(std::string_view name) const;
    /// Where the parameter stands, or the statement if it isn't given.
    const SourceLocation& where(std::string_view name) const;
    const SourceLocation& where() const { return set_->where; }
    const std::string& plugin() const { return set_->plugin; }
    /// All that the scene gives, for plugins that hand it on to another one.
    const ParameterSet& set() const { return *set_; }
    Diagnostics& diagnostics() const { return diagnostics_; }
    /// Throws InputError at the parameter `name`.
    [[noreturn]] void fail(std::string_view name, const std::string& message) const;

  private:
    const ParameterValue* find(std::string_view name) const;
    /// Takes a value's place, or leaves it out.
    struct Mend {
        std::size_t index;
        std::optional<ParameterValue> value;
    };
    void mend(std::vector<Mend> mends, const std::vector<bool>& is_overridden);

    const ParameterSet* set_;
    std::shared_ptr<const ParameterSet> mended_;  ///< what `set_` is where values were wrong
    std::span<const ParameterDeclaration> declarations_;
    Diagnostics& diagnostics_;
};

/// Types that scene files write before a parameter's name: float, integer, bool, ...
std::span<const std::string_view> written_types();

/// Declared parameters as aligned text (for `--describe`) and as a Markdown table (for docs/).
std::string describe_text(std::span<const ParameterDeclaration> declarations);
std::string describe_markdown(std::span<const ParameterDeclaration> declarations);

}  // namespace lxs
