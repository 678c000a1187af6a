// Text of located messages: position, source line, caret, include chain.
#include "lxs/sdk/diagnostics.h"

#include <algorithm>
#include <boost/locale/utf.hpp>
#include <mutex>

namespace lxs {
namespace {

constexpr std::size_t kExcerptBytes = 96;  // of a source line, around the caret
constexpr std::size_t kContextBytes = 40;  // kept before the caret when the line is cut
constexpr std::size_t kQuotedBytes = 120;

bool is_continuation(char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

/// What moves a terminal's cursor or colours, what orders text from right to left, and ends of
/// lines that a terminal may take for such.
bool commands_terminal(char32_t c) {
    const auto within = [c](char32_t first, char32_t last) { return first <= c && c <= last; };
    return c < 0x20 || within(0x7F, 0x9F) || c == 0x61C || within(0x200E, 0x200F) ||
           within(0x2028, 0x202E) || within(0x2066, 0x2069) || within(0xFFF9, 0xFFFB);
}

/// `text` with '?' for such characters, but for those in `kept`, and for bytes that are no UTF-8.
std::string shown(std::string_view text, std::string_view kept) {
    namespace utf = boost::locale::utf;
    std::string result;
    result.reserve(text.size());
    for (const char* at = text.data(); at != text.data() + text.size();) {
        const char* next = at;
        const auto c = utf::utf_traits<char>::decode(next, text.data() + text.size());
        if (c == utf::illegal || c == utf::incomplete) {
            result += '?';
            ++at;
            continue;
        }
        if (commands_terminal(c) && kept.find(*at) == std::string_view::npos) {
            result += '?';
        } else {
            result.append(at, next);
        }
        at = next;
    }
    return result;
}

/// Line number `line` (from 1) of `text` without its line end; empty if there is no such line.
std::string_view source_line(std::string_view text, std::uint32_t line) {
    for (std::uint32_t current = 1; current < line; ++current) {
        const std::size_t newline = text.find('\n');
        if (newline == std::string_view::npos) return {};
        text.remove_prefix(newline + 1);
    }
    text = text.substr(0, text.find('\n'));
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    return text;
}

/// Moves `offset` back to the first byte of the UTF-8 character that it lies in.
std::size_t character_start(std::string_view text, std::size_t offset) {
    for (int i = 0; i < 3 && offset > 0 && offset < text.size(); ++i) {
        if (!is_continuation(text[offset])) break;
        --offset;
    }
    return offset;
}

/// The source line, cut around `column` (from 1, bytes) if it is long, and a line with the caret.
std::string excerpt(std::string_view line, std::uint32_t column) {
    const std::size_t caret = std::min<std::size_t>(std::max(column, 1u) - 1, line.size());
    std::size_t begin = 0;
    std::size_t end = line.size();
    if (line.size() > kExcerptBytes) {
        if (caret > kContextBytes) begin = character_start(line, caret - kContextBytes);
        end = character_start(line, std::min(begin + kExcerptBytes, line.size()));
    }
    std::string source = "  ";
    std::string marker = "  ";
    if (begin > 0) {
        source += "...";
        marker += "   ";
    }
    source += shown(line.substr(begin, end - begin), "\t");
    if (end < line.size()) source += "...";
    for (const char c : shown(line.substr(begin, caret - begin), "\t")) {
        if (!is_continuation(c)) marker += c == '\t' ? '\t' : ' ';
    }
    return source + '\n' + marker + "^";
}

}  // namespace

std::string printable(std::string_view text) {
    return shown(text, "\t\n");
}

std::string format_message(const SourceLocation& where, const std::string& severity,
                           const std::string& message) {
    if (!where.file) return printable(severity + ": " + message);
    const SourceFile& file = *where.file;
    std::string text = file.name + ":";
    if (where.line > 0) {
        text += std::to_string(where.line) + ":" + std::to_string(where.column) + ":";
    }
    text += " " + severity + ": " + message;
    if (file.text && !file.text->empty() && where.line > 0) {
        text += '\n';
        text += excerpt(source_line(*file.text, where.line), where.column);
    }
    for (const SourceFile* f = &file; f->included_by; f = f->included_by.get()) {
        text += "\nincluded from " + f->included_by->name + ":" + std::to_string(f->include_line);
    }
    return printable(text);
}

struct InputError::Place {
    Place(const SourceLocation& at, const std::string& said) : where(at), message(said) {}

    SourceLocation where;
    std::string message;
    mutable std::once_flag formatted;
    mutable std::string text;  ///< once formatted
};

InputError::InputError(const SourceLocation& where, const std::string& message)
    : std::runtime_error(message), place_(std::make_shared<const Place>(where, message)) {}

const SourceLocation& InputError::where() const {
    return place_->where;
}

const std::string& InputError::message() const {
    return place_->message;
}

const char* InputError::what() const noexcept try {
    std::call_once(place_->formatted,
                   [&] { place_->text = format_message(place_->where, "error", place_->message); });
    return place_->text.c_str();
} catch (const std::exception&) {
    return std::runtime_error::what();
}

void Diagnostics::fallback(const SourceLocation& where, const std::string& message,
                           const std::string& /*instead*/) {
    throw InputError(where, message);
}

void Diagnostics::error(const InputError& error) {
    throw InputError(error);
}

std::string in_quotes(std::string_view text) {
    const bool cut = text.size() > kQuotedBytes;
    if (cut) text = text.substr(0, character_start(text, kQuotedBytes));
    return '"' + shown(text, "") + (cut ? "..." : "") + '"';
}

}  // namespace lxs
