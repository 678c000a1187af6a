// Runs the executable lxsrender as a user would.
#include "lxsrender_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace lxs::test {
namespace {

/// In the child: never returns.
[[noreturn]] void become_lxsrender(const std::filesystem::path& folder,
                                   const std::filesystem::path& streams,
                                   std::vector<char*>& arguments,
                                   const std::function<void()>& restrict) {
    const auto redirect = [&](const char* name, int flags, int descriptor) {
        ::dup2(::open((streams / name).c_str(), flags, 0600), descriptor);
    };
    redirect("in", O_RDONLY, STDIN_FILENO);
    redirect("out", O_WRONLY | O_CREAT, STDOUT_FILENO);
    redirect("err", O_WRONLY | O_CREAT, STDERR_FILENO);
    if (::chdir(folder.c_str()) != 0) ::_exit(127);
    if (restrict) restrict();
    ::execv(LXSRENDER, arguments.data());
    ::_exit(127);
}

}  // namespace

LxsrenderProcess::LxsrenderProcess(const TemporaryFolder& folder,
                                   std::vector<std::string> arguments, const std::string& input,
                                   const std::function<void()>& restrict) {
    streams_.write("in", input);
    streams_.write("out", "");
    streams_.write("err", "");
    arguments.insert(arguments.begin(), LXSRENDER);
    std::vector<char*> pointers;
    pointers.reserve(arguments.size() + 1);
    for (std::string& argument : arguments)
        pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    id_ = ::fork();
    if (id_ == 0) become_lxsrender(folder.path(), streams_.path(), pointers, restrict);
}

LxsrenderProcess::~LxsrenderProcess() {
    if (id_ <= 0) return;
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
}

bool LxsrenderProcess::wait_for(const std::string& text) const {
    using namespace std::chrono_literals;
    for (const auto end = std::chrono::steady_clock::now() + 30s;
         std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(10ms)) {
        if (streams_.read("err").find(text) != std::string::npos) return true;
    }
    return false;
}

void LxsrenderProcess::send(int signal) const {
    ::kill(id_, signal);
}

RunResult LxsrenderProcess::wait() {
    int status = 0;
    ::waitpid(id_, &status, 0);
    id_ = -1;
    const int exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {exit_code, streams_.read("out"), streams_.read("err")};
}

RunResult run_lxsrender(const TemporaryFolder& folder, std::vector<std::string> arguments,
                        const std::string& input) {
    return LxsrenderProcess(folder, std::move(arguments), input).wait();
}

std::string small_scene(const std::string& options, const std::string& world) {
    return "LookAt 0 -5 0  0 0 0  0 0 1\n"
           "Camera \"perspective\" \"float fov\" [40]\n"
           "Film \"fleximage\" \"integer xresolution\" [8] \"integer yresolution\" [6]\n"
           "  \"string filename\" [\"out\"]\n" +
           options +
           "\nWorldBegin\n"
           "LightSource \"point\" \"point from\" [0 -5 3] \"color L\" [40 40 40]\n"
           "Shape \"sphere\" \"float radius\" [1]\n" +
           world + "\nWorldEnd\n";
}

}  // namespace lxs::test
