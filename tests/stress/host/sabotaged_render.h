// Renders with the integrator of tests/host/app/modules/saboteur.cpp.
#pragma once

#include <functional>
#include <string>

#include "lxsrender_process.h"

namespace lxs::test {

/// A render of "scene.lxs" in a folder of its own, with harm done in it.
struct SabotagedRender {
    TemporaryFolder folder;

    /// Renders small_scene() with these additions; `options` go to the command line.
    RunResult run(const std::string& deed, const std::string& victim = "",
                  const std::vector<std::string>& options = {},
                  const std::function<void()>& restrict = {}) {
        const std::string modules = TEST_MODULES "/saboteur";
        std::vector<std::string> arguments{
            "scene.lxs", "--integrator",         "saboteur", "--plugin-path", modules,
            "--set",     "saboteur.deed=" + deed};
        if (!victim.empty()) {
            arguments.insert(arguments.end(), {"--set", "saboteur.victim=" + victim});
        }
        arguments.insert(arguments.end(), options.begin(), options.end());
        return LxsrenderProcess(folder, arguments, "", restrict).wait();
    }
};

}  // namespace lxs::test
