// An integrator of a module whose exceptions say whose they are.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "lxs/sdk/integrator.h"

namespace lxs {

/// Hands every call on to `integrator`, named `name`, of the module `file`. What that throws
/// becomes a PluginFailure with the module, the integrator and the pass, but for InputError,
/// std::bad_alloc and, in prepare(), the std::runtime_error of a scene that it can't render.
std::unique_ptr<Integrator> guarded(std::unique_ptr<Integrator> integrator, std::string name,
                                    std::filesystem::path file);

}  // namespace lxs
