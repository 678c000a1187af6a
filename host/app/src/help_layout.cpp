// How `--help` looks: options by group, each with its value and a sentence, lines of 79 characters.
#include "lxs/host/help_layout.h"

#include <fmt/format.h>

#include <sstream>

namespace lxs {
namespace {

constexpr std::size_t kWidth = 79, kIndent = 6;

/// `text` in lines that begin `kIndent` characters in.
std::string wrapped(const std::string& text) {
    std::istringstream words(text);
    std::string result, line;
    for (std::string word; words >> word;) {
        if (!line.empty() && kIndent + line.size() + 1 + word.size() > kWidth) {
            result += std::string(kIndent, ' ') + line + '\n';
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return result + std::string(kIndent, ' ') + line + '\n';
}

}  // namespace

std::string HelpLayout::make_option(const CLI::Option* option, bool is_positional) const {
    std::string head = is_positional ? option->get_type_name() : option->get_name(false, true);
    if (!is_positional && !option->get_type_name().empty()) head += ' ' + option->get_type_name();
    return fmt::format("  {}\n{}", head, wrapped(option->get_description()));
}

}  // namespace lxs
