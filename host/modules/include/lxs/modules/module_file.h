// Where a module lies that a program loads when it needs it.
#pragma once

#include <boost/dll/runtime_symbol_info.hpp>
#include <filesystem>
#include <initializer_list>
#include <system_error>

namespace lxs {

/// The file `name` in the first of `folders` that has one; empty if none has. Folders are relative
/// to that of the program: as it is installed, and as it is built.
inline std::filesystem::path module_file(std::initializer_list<const char*> folders,
                                         const char* name) {
    const std::filesystem::path bin = boost::dll::program_location().parent_path();
    for (const char* folder : folders) {
        std::filesystem::path file = bin / folder / name;
        std::error_code unknown;
        if (std::filesystem::exists(file, unknown)) return file;
    }
    return {};
}

}  // namespace lxs
