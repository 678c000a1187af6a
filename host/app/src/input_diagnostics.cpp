// Kinds of messages, their counts, their text.
#include "lxs/host/input_diagnostics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace lxs {
namespace {

const std::string kMessage = "<the message>";  // where it stands in a formatted one
constexpr std::size_t kMostKinds = 100;
constexpr std::size_t kMostOthers = 5;  // names of one kind beside the first

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// The message without what stands in quotes and without digits.
std::string pattern_of(const std::string& message) {
    std::string pattern;
    bool quoted = false;
    for (const char c : message) {
        if (c == '"') quoted = !quoted;
        if ((quoted && c != '"') || is_digit(c)) continue;
        pattern += c;
    }
    return pattern;
}

/// The pattern without a list of known names, the nearest first, which differs from message to
/// message of one kind. Nothing follows such a list.
std::string without_known_names(std::string pattern) {
    constexpr std::array<std::string_view, 3> kLists = {"; did you mean ",
                                                        "; known: ", "; none is known"};
    for (const std::string_view list : kLists) {
        const std::size_t begin = pattern.find(list);
        if (begin != std::string::npos) pattern.erase(begin);
    }
    return pattern;
}

/// What the message is about: its first text in quotes, with them; empty if there is none.
std::string name_in(const std::string& message) {
    const std::size_t begin = message.find('"');
    const std::size_t end = begin == std::string::npos ? begin : message.find('"', begin + 1);
    return end == std::string::npos ? "" : message.substr(begin, end + 1 - begin);
}

}  // namespace

void InputDiagnostics::warning(const SourceLocation& where, const std::string& message) {
    ++warnings_;
    add("warning", where, message);
}

void InputDiagnostics::unknown_parameter(const SourceLocation& where, const std::string& message) {
    if (strict_) return error(InputError(where, message));
    warning(where, message);
}

void InputDiagnostics::fallback(const SourceLocation& where, const std::string& message,
                                const std::string& instead) {
    const bool from_command_line = where.file && !where.file->text;
    if (strict_ || from_command_line) return error(InputError(where, message));
    ++warnings_;
    add("warning", where, message, "; " + instead);
}

void InputDiagnostics::error(const InputError& error) {
    ++errors_;
    add("error", error.where(), error.message());
}

void InputDiagnostics::add(const std::string& severity, const SourceLocation& where,
                           const std::string& about, const std::string& instead) {
    const std::string key = severity + without_known_names(pattern_of(about)) + pattern_of(instead);
    const std::string message = about + instead;
    const auto known = index_.find(key);
    if (known == index_.end()) {
        if (kinds_of_[severity] == kMostKinds) {
            ++untold_;
            return;
        }
        ++kinds_of_[severity];
        index_[key] = kinds_.size();
        // At once, since texts of large files are given up before all is told.
        const std::string told = format_message(where, severity, kMessage);
        const std::size_t at = told.find(kMessage);
        kinds_.push_back({told.substr(0, at),
                          told.substr(at + kMessage.size()),
                          message,
                          severity == "error",
                          1,
                          {}});
        return;
    }
    Kind& kind = kinds_[known->second];
    ++kind.count;
    const std::string name = name_in(message);
    if (name.empty() || name == name_in(kind.message) || kind.others.size() > kMostOthers) return;
    if (std::find(kind.others.begin(), kind.others.end(), name) == kind.others.end())
        kind.others.push_back(name);
}

std::string InputDiagnostics::text(const Kind& kind) {
    if (kind.count == 1) return kind.message;
    if (kind.others.empty()) return fmt::format("{} ({} times)", kind.message, kind.count);
    const bool more = kind.others.size() > kMostOthers;
    const auto end = kind.others.begin() +
                     static_cast<std::ptrdiff_t>(std::min(kind.others.size(), kMostOthers));
    return fmt::format("{} ({} of this kind, also {}{})", kind.message, kind.count,
                       fmt::join(kind.others.begin(), end, ", "), more ? ", ..." : "");
}

void InputDiagnostics::report() {
    for (const Kind& kind : kinds_)
        log_.verbatim(kind.before + printable(text(kind)) + kind.behind, kind.error);
    if (untold_ > 0) {
        log_.warning(
            fmt::format("more than {} kinds of messages about the scene: {} of further "
                        "kinds are not shown",
                        kMostKinds, untold_));
    }
    if (errors_ > 1) log_.error(fmt::format("nothing is rendered: {} errors", errors_));
    kinds_.clear();
    kinds_of_.clear();
    index_.clear();
    untold_ = 0;
}

void InputDiagnostics::refuse_errors() const {
    if (errors_ > 0) throw RefusedInput(fmt::format("nothing is rendered: {} errors", errors_));
}

}  // namespace lxs
