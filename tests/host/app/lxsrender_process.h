// Runs the executable lxsrender as a user would.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

#include "temporary_folder.h"

namespace lxs::test {

using files::TemporaryFolder;

/// How a run of lxsrender ended and what it said.
struct RunResult {
    int exit_code = -1;  ///< 128 + signal number if a signal ended it
    std::string out;     ///< standard output
    std::string err;     ///< standard error
};

/// A running lxsrender, its working folder being `folder`; ended when destroyed.
class LxsrenderProcess {
  public:
    /// `restrict` runs in the new process, in `folder` and with its streams, before it becomes
    /// lxsrender: limits, lost rights.
    LxsrenderProcess(const TemporaryFolder& folder, std::vector<std::string> arguments,
                     const std::string& input = "", const std::function<void()>& restrict = {});
    ~LxsrenderProcess();
    LxsrenderProcess(const LxsrenderProcess&) = delete;
    LxsrenderProcess& operator=(const LxsrenderProcess&) = delete;

    /// Waits until standard error holds `text`; false if that takes longer than half a minute.
    bool wait_for(const std::string& text) const;
    void send(int signal) const;
    RunResult wait();

  private:
    TemporaryFolder streams_;
    pid_t id_ = -1;
};

/// Runs lxsrender to its end.
RunResult run_lxsrender(const TemporaryFolder& folder, std::vector<std::string> arguments,
                        const std::string& input = "");

/// A scene that renders in no time: 8 x 6 pixels of a sphere under a point light, output "out".
/// The texts stand in the options, and in the world before WorldEnd.
std::string small_scene(const std::string& options = "", const std::string& world = "");

}  // namespace lxs::test
