// Statements from matched text; syntax errors.
#include "statement_builder.h"

#include <fmt/format.h>

#include <cstring>
#include <limits>

#include "number.h"
#include "number_run.h"

namespace lxs {
namespace {

constexpr std::size_t kLocatedValues = 16;  // of one list; longer lists get one location

/// A backslash escapes a quote or a backslash; any other is part of the text (Windows paths).
std::string unescaped(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escape =
            text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == '"' || text[i + 1] == '\\');
        if (escape) ++i;
        result += text[i];
    }
    return result;
}

}  // namespace

StatementBuilder::StatementBuilder(std::shared_ptr<const SourceFile> file,
                                   const StatementHandler& handler)
    : file_(std::move(file)),
      handler_(handler),
      scanned_(file_->text->data()),
      line_begin_(scanned_) {}

void StatementBuilder::begin_statement(const char* at, std::string_view word) {
    statement_ = {std::string(word), locate(at), {}};
}

void StatementBuilder::end_statement() {
    handler_(statement_);
}

void StatementBuilder::begin_list(const char* at) {
    statement_.arguments.push_back({locate(at), {}, {}, true});
    in_list_ = true;
}

template <class Value>
std::vector<Value>& StatementBuilder::open_values(const char* at) {
    std::vector<Argument>& arguments = statement_.arguments;
    if (!in_list_) {
        const bool joins = std::is_same_v<Value, double> && !arguments.empty() &&
                           !arguments.back().bracketed &&
                           std::holds_alternative<std::vector<double>>(arguments.back().values);
        if (!joins) arguments.push_back({locate(at), std::vector<Value>(), {}, false});
    }
    auto& values = arguments.back().values;
    if (auto* open = std::get_if<std::vector<Value>>(&values)) return *open;
    if (!std::visit([](const auto& list) { return list.empty(); }, values)) {
        throw InputError(locate(at),
                         "a list holds either numbers or strings or bools, not a mixture");
    }
    return values.emplace<std::vector<Value>>();
}

template <class Value>
void StatementBuilder::add(const char* at, Value value) {
    std::vector<Value>& values = open_values<Value>(at);
    if (values.size() < kLocatedValues) {
        statement_.arguments.back().value_where.push_back(locate(at));
    }
    values.push_back(std::move(value));
}

void StatementBuilder::add_number(const char* at, std::string_view text) {
    number_begin_ = at;
    add(at, parse_number(text).value_or(std::numeric_limits<double>::infinity()));
}

void StatementBuilder::add_not_finite(const char* at) {
    add(at, std::numeric_limits<double>::quiet_NaN());
}

const char* StatementBuilder::add_number_run(const char* at, const char* end) {
    auto* values = std::get_if<std::vector<double>>(&statement_.arguments.back().values);
    if (!values || values->size() < kLocatedValues) return at;
    return read_number_run(at, end, *values);
}

void StatementBuilder::add_string(std::string_view text) {
    add(string_begin_, unescaped(text));
}

void StatementBuilder::add_bool(const char* at, bool value) {
    add(at, value);
}

void StatementBuilder::fail_number(const char* at) {
    throw InputError(locate(at), in_quotes(token(at)) + " is not a number");
}

void StatementBuilder::fail_string(const char* at) {
    const char* const end = file_->text->data() + file_->text->size();
    if (at == end || *at == '\n' || *at == '\r') {
        throw InputError(locate(string_begin_), "this string has no closing quote on its line");
    }
    throw InputError(locate(at), fmt::format("control character 0x{:02x} in a string",
                                             static_cast<unsigned char>(*at)));
}

void StatementBuilder::fail_list(const char* at) {
    const SourceLocation begin = statement_.arguments.back().where;
    const std::string_view word = token(at);
    if (word.empty()) throw InputError(begin, "this list has no closing ']'");
    if (word == "[") throw InputError(locate(at), "lists do not nest: '[' inside of a list");
    throw InputError(locate(at),
                     fmt::format("expected a number, a string or ']' in the list that begins at "
                                 "{}:{}, found {}",
                                 begin.line, begin.column, in_quotes(word)));
}

void StatementBuilder::fail_statement(const char* at) {
    throw InputError(locate(at),
                     fmt::format("expected a statement, found {}", in_quotes(token(at))));
}

SourceLocation StatementBuilder::locate(const char* at) {
    if (at < scanned_) {  // errors may look back
        scanned_ = line_begin_ = file_->text->data();
        line_ = 1;
    }
    while (const void* newline =
               std::memchr(scanned_, '\n', static_cast<std::size_t>(at - scanned_))) {
        scanned_ = line_begin_ = static_cast<const char*>(newline) + 1;
        ++line_;
    }
    scanned_ = at;
    return {file_, line_, static_cast<std::uint32_t>(at - line_begin_) + 1};
}

std::string_view StatementBuilder::token(const char* at) const {
    const char* const end = file_->text->data() + file_->text->size();
    const std::string_view rest(at, static_cast<std::size_t>(end - at));
    const std::size_t length = rest.find_first_of(" \t\r\n\f\v[]\"");
    return rest.substr(0, length == 0 ? 1 : length);
}

}  // namespace lxs
