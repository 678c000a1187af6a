// What a program says of a command line that it does not understand.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace lxs {

/// For CLI::App::failure_message(): CLI11's words, but for an option that is unknown, which is
/// named with the nearest that there is.
std::string mistake_message(const CLI::App* app, const CLI::Error& error);

}  // namespace lxs
