// Loads a shared object while the program runs.
#pragma once

#include <boost/dll/shared_library.hpp>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace lxs {

/// Loads `file` into `library`. Throws std::runtime_error with the loader's reason, and also where
/// the file is cut short: the loader would map what is not there, and the program would end with
/// the first use of it. What is no regular file is not opened.
void load_module(boost::dll::shared_library& library, const std::filesystem::path& file,
                 boost::dll::load_mode::type mode = boost::dll::load_mode::default_mode);

/// The function `name` of a loaded module; throws std::runtime_error if it has none.
template <class Function>
Function& module_function(const boost::dll::shared_library& library, const char* name) {
    if (!library.has(name)) throw std::runtime_error(std::string("it has no function ") + name);
    return library.get<Function>(name);
}

}  // namespace lxs
