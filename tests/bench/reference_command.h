// `aips-bench reference`: renders more of a scene's reference images and merges it into them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "exit_code.h"
#include "lxs/host/console_log.h"
#include "lxs/host/interruption.h"
#include "lxs/host/plugin_library.h"
#include "method_table.h"
#include "scene_table.h"

namespace bench {

struct ReferenceRequest {
    std::vector<BenchScene> scenes;
    double seconds = 60;         ///< for each scene
    std::string clock = "wall";  ///< of the seconds: "wall" or "cpu"
    bool up_to = false;          ///< the seconds that the references already took count
    unsigned threads = 0;
    std::uint32_t width_px = 0, height_px = 0;  ///< 0: the scene's own, in proportion
    std::filesystem::path root;                 ///< folder of all references
};

/// Success, ReferencesDiffer or Interrupted. Throws StudyError, lxs::OutputFailure.
ExitCode make_references(const ReferenceRequest& request, const MethodTable& table,
                         const lxs::PluginLibrary& plugins, const lxs::Interruption& interruption,
                         lxs::ConsoleLog& log);

}  // namespace bench
