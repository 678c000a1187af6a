// Runs lxsrender within bounds of time and memory, and tells what it took.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "temporary_folder.h"

namespace stress {

/// What a run may take; it is ended beyond that. Sanitized builds get four times as much.
struct Bounds {
    double cpu_seconds = 10;
    double megabytes = 400;  ///< resident; a small scene takes about 100 by itself
};

struct BoundedRun {
    int exit_code = -1;  ///< 128 + signal number if a signal ended it
    std::string out, err;
    double cpu_seconds = 0;
    double peak_megabytes = 0;
    bool beyond_bounds = false;  ///< it was ended for taking too much
};

/// Writes what a program is to read into its standard input, piece by piece; returns false when it
/// no longer reads.
using Pipe = std::function<bool(const std::string&)>;

/// What a run is made of besides its arguments.
struct RunOptions {
    Bounds bounds = {};
    std::vector<std::string> environment = {};   ///< NAME=value, in addition to this process's
    std::function<void(const Pipe&)> feed = {};  ///< writes standard input; none: it is empty
};

/// Runs lxsrender in `folder`.
BoundedRun run_lxsrender(const files::TemporaryFolder& folder,
                         const std::vector<std::string>& arguments, const RunOptions& options = {});

/// Options, then the world with a light and a sphere: renders in no time, to "out.exr".
std::string small_scene(const std::string& options = "", const std::string& world = "");

/// Fails the running test unless the run ended as bad input within its bounds, with a message that
/// holds `message` and begins with a place ("scene.lxs:3:1: error: " or "command line: ...").
void expect_refused(const BoundedRun& run, const std::string& message);

/// "exit code 3, 0.2 s, 90 MB": a row's figure.
std::string figure_of(const BoundedRun& run);

}  // namespace stress
