// Collects what the grammar matches into statements, and words the syntax errors.
#pragma once

#include <memory>
#include <string_view>

#include "lxs/language/parse_file.h"

namespace lxs {

/// Follows one file from its first to its last character; hands out each complete statement.
class StatementBuilder {
  public:
    StatementBuilder(std::shared_ptr<const SourceFile> file, const StatementHandler& handler);

    void begin_statement(const char* at, std::string_view word);
    void end_statement();
    void begin_list(const char* at);
    void end_list() { in_list_ = false; }
    void begin_string(const char* at) { string_begin_ = at; }
    /// One that is too large counts as infinite.
    void add_number(const char* at, std::string_view text);
    void add_not_finite(const char* at);
    /// Numbers of the open list from `at` on, if it is long enough that they need no locations;
    /// returns where they end.
    const char* add_number_run(const char* at, const char* end);
    void add_string(std::string_view text);
    void add_bool(const char* at, bool value);

    [[noreturn]] void fail_number(const char* at);
    [[noreturn]] void fail_number_end() { fail_number(number_begin_); }
    [[noreturn]] void fail_string(const char* at);
    [[noreturn]] void fail_list(const char* at);
    [[noreturn]] void fail_statement(const char* at);

  private:
    /// Line and column of `at`; cheap when asked in rising order.
    SourceLocation locate(const char* at);
    /// Values that the next one joins: those of the open list, of a run of bare numbers, or new.
    template <class Value>
    std::vector<Value>& open_values(const char* at);
    template <class Value>
    void add(const char* at, Value value);
    /// The word at `at`, up to the next blank, bracket or quote.
    std::string_view token(const char* at) const;

    std::shared_ptr<const SourceFile> file_;
    const StatementHandler& handler_;
    Statement statement_;
    bool in_list_ = false;
    const char* number_begin_ = nullptr;
    const char* string_begin_ = nullptr;
    const char* scanned_;     ///< lines are counted up to here
    const char* line_begin_;  ///< of the line that `scanned_` is in
    std::uint32_t line_ = 1;
};

}  // namespace lxs
