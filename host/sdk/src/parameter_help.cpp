// Help made from parameter declarations: aligned text and Markdown.
#include <algorithm>
#include <array>
#include <cctype>

#include "lxs/sdk/parameters.h"
#include "parameter_text.h"

namespace lxs {
namespace {

std::string joined_choices(const ParameterDeclaration& declaration) {
    std::string text;
    for (const std::string_view choice : declaration.choices) {
        if (!text.empty()) text += ", ";
        text += choice;
    }
    return text;
}

/// Adds a sentence; to a doc that is no sentence, a clause.
void add_remark(std::string& doc, std::string sentence) {
    if (doc.empty() || doc.ends_with('.')) {
        doc += doc.empty() ? sentence : " " + sentence;
        return;
    }
    sentence.front() =
        static_cast<char>(std::tolower(static_cast<unsigned char>(sentence.front())));
    sentence.pop_back();
    doc += "; " + sentence;
}

/// Name, type, default, allowed values, doc.
std::array<std::string, 5> columns(const ParameterDeclaration& declaration) {
    std::string type(type_name(declaration.type));
    if (declaration.array) type += " list";
    const std::string allowed =
        declaration.choices.empty() ? range_text(declaration) : joined_choices(declaration);
    std::string doc(declaration.doc);
    if (!declaration.older_name.empty())
        add_remark(doc, "Older name: " + std::string(declaration.older_name) + ".");
    if (declaration.no_effect) add_remark(doc, "Has no effect.");
    return {std::string(declaration.name), type, std::string(declaration.default_text), allowed,
            doc};
}

/// '|' would end a Markdown table cell.
std::string markdown_cell(const std::string& text) {
    std::string cell;
    for (const char c : text) {
        if (c == '|') cell += '\\';
        cell += c;
    }
    return cell;
}

}  // namespace

std::string describe_text(std::span<const ParameterDeclaration> declarations) {
    std::size_t name_width = 0;
    std::size_t type_width = 0;
    std::size_t default_width = 0;
    for (const ParameterDeclaration& declaration : declarations) {
        const auto [name, type, fallback, allowed, doc] = columns(declaration);
        name_width = std::max(name_width, name.size());
        type_width = std::max(type_width, type.size());
        default_width = std::max(default_width, fallback.size());
    }
    const auto padded = [](std::string text, std::size_t width) {
        text.resize(width + 2, ' ');
        return text;
    };
    std::string text;
    std::string_view group;
    for (const ParameterDeclaration& declaration : declarations) {
        const auto [name, type, fallback, allowed, doc] = columns(declaration);
        if (declaration.group != group) {
            group = declaration.group;
            if (!text.empty()) text += '\n';
            text += group;
            text += ":\n";
        }
        text.append("  ").append(padded(name, name_width)).append(padded(type, type_width));
        text.append(padded(fallback, default_width)).append(doc);
        if (!allowed.empty()) text.append(" (").append(allowed).append(")");
        text += '\n';
    }
    return text;
}

std::string describe_markdown(std::span<const ParameterDeclaration> declarations) {
    std::string text = "| name | type | default | allowed | meaning |\n";
    text += "| --- | --- | --- | --- | --- |\n";
    std::string_view group;
    for (const ParameterDeclaration& declaration : declarations) {
        if (declaration.group != group) {
            group = declaration.group;
            text += "| **" + markdown_cell(std::string(group)) + "** | | | | |\n";
        }
        text += "|";
        for (const std::string& cell : columns(declaration)) {
            if (!cell.empty()) text += ' ';
            text += markdown_cell(cell);
            text += " |";
        }
        text += '\n';
    }
    return text;
}

}  // namespace lxs
