// What is wrong with the input, gathered by kind and told in one go.
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "lxs/host/console_log.h"
#include "lxs/sdk/diagnostics.h"

namespace lxs {

/// Input with errors, which have been told: nothing is rendered.
class RefusedInput : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Gathers warnings and errors until report(). Messages that differ only in what stands in quotes,
/// in numbers and in lists of known names are of one kind, which is told once: the first in full,
/// with its place, the number of all, and the names in a few of the others. With `strict`, what
/// LuxRender goes on from is an error; what the command line gives always is.
class InputDiagnostics : public Diagnostics {
  public:
    InputDiagnostics(ConsoleLog& log, bool strict) : log_(log), strict_(strict) {}

    void warning(const SourceLocation& where, const std::string& message) override;
    void unknown_parameter(const SourceLocation& where, const std::string& message) override;
    void fallback(const SourceLocation& where, const std::string& message,
                  const std::string& instead) override;
    void error(const InputError& error) override;

    std::uint64_t warnings() const { return warnings_; }
    std::uint64_t errors() const { return errors_; }
    /// Tells all that was gathered, in the order of first appearance, and forgets it; the sums
    /// stay.
    void report();
    /// Throws RefusedInput if there was an error.
    void refuse_errors() const;

  private:
    struct Kind {
        std::string before, behind;  ///< of the first: its place, and the line there
        std::string message;         ///< of the first
        bool error;
        std::uint64_t count = 0;
        std::vector<std::string> others;  ///< names in other messages, a few, in order
    };
    /// `instead`: what follows `about`.
    void add(const std::string& severity, const SourceLocation& where, const std::string& about,
             const std::string& instead = "");
    static std::string text(const Kind& kind);

    ConsoleLog& log_;
    bool strict_;
    std::vector<Kind> kinds_;
    std::map<std::string, std::size_t> kinds_of_;  ///< by severity
    std::map<std::string, std::size_t> index_;     ///< into kinds_, by severity and pattern
    std::uint64_t warnings_ = 0, errors_ = 0, untold_ = 0;
};

}  // namespace lxs
