// How `--help` looks: options by group, each with its value and a sentence, lines of 79 characters.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace lxs {

class HelpLayout : public CLI::Formatter {
  public:
    std::string make_option(const CLI::Option* option, bool is_positional) const override;
};

}  // namespace lxs
