// A render in a process of its own, so that its memory, CPU time and crashes are its own.
#include "render_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

namespace bench {
namespace {

namespace fs = std::filesystem;

/// Both standard streams of a process to be started go to one file.
class StreamsToFile {
  public:
    explicit StreamsToFile(const fs::path& file) {
        ::posix_spawn_file_actions_init(&actions_);
        ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, file.c_str(),
                                           O_WRONLY | O_CREAT | O_TRUNC, 0644);
        ::posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    }
    ~StreamsToFile() { ::posix_spawn_file_actions_destroy(&actions_); }
    StreamsToFile(const StreamsToFile&) = delete;
    StreamsToFile& operator=(const StreamsToFile&) = delete;
    const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

int run(const fs::path& program, std::array<std::string, 3> arguments, const fs::path& log) {
    const StreamsToFile streams(log);
    std::array<char*, 4> pointers{arguments[0].data(), arguments[1].data(), arguments[2].data(),
                                  nullptr};
    pid_t id = 0;
    const int error =
        ::posix_spawn(&id, program.c_str(), streams.get(), nullptr, pointers.data(), environ);
    if (error != 0) {
        throw std::system_error(error, std::generic_category(), "cannot start " + program.string());
    }
    int status = 0;
    while (::waitpid(id, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

std::string end_of(const fs::path& log) {
    constexpr std::size_t kMostBytes = 1000;
    const std::string text = read_file(log);
    return text.substr(text.size() - std::min(text.size(), kMostBytes));
}

}  // namespace

ProcessEnd render_in_process(const fs::path& program, const RenderJob& job, const fs::path& log) {
    const fs::path job_file = job.result + ".job";
    write_json(job_file, to_json(job));
    make_folder(log.parent_path());
    make_folder(fs::path(job.images).parent_path());
    const int status = run(program, {program.string(), "render-one", job_file.string()}, log);
    std::error_code ignored;
    fs::remove(job_file, ignored);
    ProcessEnd end;
    if (WIFEXITED(status)) {
        end.done = WEXITSTATUS(status) == 0;
        if (!end.done) {
            end.message = fmt::format("exit code {}: {}", WEXITSTATUS(status), end_of(log));
        }
    } else {
        const int signal = WTERMSIG(status);
        end.interrupted = signal == SIGINT || signal == SIGTERM;
        end.message = fmt::format("signal {} ({}): {}", signal, ::strsignal(signal), end_of(log));
    }
    return end;
}

fs::path own_executable() {
    return fs::read_symlink("/proc/self/exe");
}

}  // namespace bench
