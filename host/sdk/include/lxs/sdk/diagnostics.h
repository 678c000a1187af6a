// Located messages about input: file:line:column, the source line, a caret.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace lxs {

/// A file being read and how it came to be included; kept alive by the locations in it.
struct SourceFile {
    std::string name;                               ///< as messages show it
    std::shared_ptr<const std::string> text;        ///< whole content, null for the command line
    std::shared_ptr<const SourceFile> included_by;  ///< null for the main file
    std::uint32_t include_line = 0;                 ///< line of the Include in `included_by`
};

/// A place in a scene file; `file` is null where there is none (defaults, tests).
struct SourceLocation {
    std::shared_ptr<const SourceFile> file;
    std::uint32_t line = 0;    ///< from 1
    std::uint32_t column = 0;  ///< from 1, bytes
};

/// "file:line:column: severity: message", the source line, a caret and the include chain.
std::string format_message(const SourceLocation& where, const std::string& severity,
                           const std::string& message);

/// Bad input. `what()` is the whole formatted text.
class InputError : public std::runtime_error {
  public:
    InputError(const SourceLocation& where, const std::string& message)
        : std::runtime_error(format_message(where, "error", message)) {}
};

/// Where warnings about input go; with --strict, a warning of kind unknown-parameter throws.
class Diagnostics {
  public:
    virtual ~Diagnostics() = default;
    virtual void warning(const SourceLocation& where, const std::string& message) = 0;
    /// A parameter that no declaration knows.
    virtual void unknown_parameter(const SourceLocation& where, const std::string& message) = 0;
};

/// The nearest of `known` to `name` by edit distance, empty if none is near.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

/// `text` with '?' for control characters other than tabs and line ends: names from files reach
/// terminals.
std::string printable(std::string_view text);

/// `text` in double quotes, fit for a message: control characters shown as '?', cut after 120
/// bytes.
std::string in_quotes(std::string_view text);

/// "unknown <kind> "<name>"; did you mean "<nearest>"? Known: a, b, c": the nearest of `known`
/// first, the rest in the order given.
std::string unknown_name_message(std::string_view kind, const std::string& name,
                                 const std::vector<std::string>& known);

}  // namespace lxs
