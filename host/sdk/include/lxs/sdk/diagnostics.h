// Located messages about input: file:line:column, the source line, a caret.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
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

/// Bad input. `what()` is the whole formatted text, made when it is first asked for: finding the
/// source line takes time, and most errors are told as kinds.
class InputError : public std::runtime_error {
  public:
    InputError(const SourceLocation& where, const std::string& message);
    const SourceLocation& where() const;
    /// Without the place.
    const std::string& message() const;
    const char* what() const noexcept override;

  private:
    struct Place;
    std::shared_ptr<const Place> place_;  ///< shared: exceptions are copied
};

/// A statement that LuxRender leaves out, with a message, and reads on.
class IgnoredStatement : public InputError {
    using InputError::InputError;
};

/// Where what is wrong with the input goes.
class Diagnostics {
  public:
    virtual ~Diagnostics() = default;
    virtual void warning(const SourceLocation& where, const std::string& message) = 0;
    /// A parameter that no declaration knows; an error with --strict.
    virtual void unknown_parameter(const SourceLocation& where, const std::string& message) = 0;
    /// What LuxRender says and then goes on from, as `instead` has it: a warning; an error with
    /// --strict, and for whoever does not override this.
    virtual void fallback(const SourceLocation& where, const std::string& message,
                          const std::string& instead);
    /// An error after which reading goes on, to find more; nothing is rendered. Throws it unless
    /// overridden.
    virtual void error(const InputError& error);
};

/// The nearest of `known` to `name` by edit distance, empty if none is near.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

/// `text` fit for a terminal, which names from files reach: '?' for control characters other than
/// tabs and line ends, for what turns the direction of text, and for what is no UTF-8.
std::string printable(std::string_view text);

/// `text` in double quotes, fit for a message: as printable() has it, without tabs and line ends,
/// and cut after 120 bytes.
std::string in_quotes(std::string_view text);

/// "unknown <kind> "<name>"".
std::string unknown_name(std::string_view kind, std::string_view name);

/// "unknown <kind> "<name>"; did you mean "<nearest>"? Known: a, b, c": the nearest of `known`
/// first, the rest in the order given; of a long list, its first names and how many more there are.
std::string unknown_name_message(std::string_view kind, const std::string& name,
                                 const std::vector<std::string>& known);

}  // namespace lxs
