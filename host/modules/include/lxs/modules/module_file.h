// Where what a program loads when it needs it lies: beside it.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <vector>

namespace lxs {

/// The folders that paths to modules are relative to: that of the program, or, where this code is
/// part of the module of Python, those that a program beside it would lie in, as it is installed
/// and as it is built.
std::vector<std::filesystem::path> program_folders();

/// The first of `paths` that there is, relative to a program's folder: as it is installed, and as
/// it is built. Empty if there is none.
std::filesystem::path beside_program(std::initializer_list<std::filesystem::path> paths);

}  // namespace lxs
