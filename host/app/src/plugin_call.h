// Calls into a module's code: whatever it throws arrives as a failure that names the module.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <new>
#include <string>
#include <string_view>

#include "lxs/host/failure.h"
#include "lxs/sdk/diagnostics.h"

namespace lxs {

[[noreturn]] inline void fail_module(const std::filesystem::path& file, const std::string& cause) {
    throw PluginFailure(fmt::format("plugin module '{}': {}", file.string(), cause));
}

/// Runs `function`, which calls a module; `what` names it in the message. Bad input and a lack of
/// memory pass through, everything else becomes a PluginFailure.
template <class Function>
auto call_module(const std::filesystem::path& file, std::string_view what, Function function) {
    try {
        return function();
    } catch (const InputError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        fail_module(file, fmt::format("{} failed: {}", what, error.what()));
    } catch (...) {
        fail_module(file, fmt::format("{} failed with an exception of unknown type", what));
    }
}

}  // namespace lxs
