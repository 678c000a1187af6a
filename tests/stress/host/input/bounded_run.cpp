// lxsrender as a child process, watched.
#include "bounded_run.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

namespace stress {
namespace {

constexpr double kSanitizedFactor = AIPS_SANITIZED ? 4 : 1;

/// In the child: never returns.
[[noreturn]] void become_lxsrender(const files::TemporaryFolder& folder,
                                   const files::TemporaryFolder& streams, int input,
                                   const Bounds& bounds, std::vector<char*>& arguments,
                                   std::vector<char*>& environment) {
    const auto redirect = [&](const std::string& path, int flags, int descriptor) {
        ::dup2(::open(path.c_str(), flags, 0600), descriptor);
    };
    ::dup2(input, STDIN_FILENO);
    redirect(streams / "out", O_WRONLY | O_CREAT, STDOUT_FILENO);
    redirect(streams / "err", O_WRONLY | O_CREAT, STDERR_FILENO);
    const auto seconds = static_cast<rlim_t>(bounds.cpu_seconds * kSanitizedFactor + 1);
    const rlimit limit{seconds, seconds + 1};
    ::setrlimit(RLIMIT_CPU, &limit);
    if (::chdir(folder.path().c_str()) == 0)
        ::execve(LXSRENDER, arguments.data(), environment.data());
    ::_exit(127);
}

double resident_megabytes(pid_t id) {
    std::ifstream file("/proc/" + std::to_string(id) + "/statm");
    double total = 0, resident = 0;
    file >> total >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> result;
    result.reserve(texts.size() + 1);
    for (std::string& text : texts)
        result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

/// Ends the child if it takes more memory than it may.
void watch(pid_t id, double most_megabytes, const std::atomic<bool>& over, BoundedRun& run) {
    using namespace std::chrono_literals;
    while (!over) {
        if (resident_megabytes(id) > most_megabytes) {
            run.beyond_bounds = true;
            ::kill(id, SIGKILL);
            return;
        }
        std::this_thread::sleep_for(5ms);
    }
}

void write_input(int descriptor, const RunOptions& options) {
    ::signal(SIGPIPE, SIG_IGN);
    const Pipe pipe = [&](const std::string& text) {
        for (std::size_t at = 0; at < text.size();) {
            const ssize_t written = ::write(descriptor, text.data() + at, text.size() - at);
            if (written <= 0) return false;
            at += static_cast<std::size_t>(written);
        }
        return true;
    };
    if (options.feed) options.feed(pipe);
    ::close(descriptor);
}

}  // namespace

BoundedRun run_lxsrender(const files::TemporaryFolder& folder,
                         const std::vector<std::string>& arguments, const RunOptions& options) {
    const files::TemporaryFolder streams;
    std::vector<std::string> words{LXSRENDER}, variables = options.environment;
    words.insert(words.end(), arguments.begin(), arguments.end());
    for (char** variable = environ; *variable; ++variable)
        variables.emplace_back(*variable);
    std::vector<char*> argv = pointers(words), envp = pointers(variables);
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    const pid_t id = ::fork();
    if (id == 0) become_lxsrender(folder, streams, ends[0], options.bounds, argv, envp);
    ::close(ends[0]);
    BoundedRun run;
    std::atomic<bool> over = false;
    std::thread watcher(watch, id, options.bounds.megabytes * kSanitizedFactor, std::cref(over),
                        std::ref(run));
    write_input(ends[1], options);
    int status = 0;
    rusage usage{};
    ::wait4(id, &status, 0, &usage);
    over = true;
    watcher.join();
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    run.beyond_bounds |= run.exit_code == 128 + SIGXCPU;
    run.cpu_seconds = static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
                      static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) * 1e-6;
    run.peak_megabytes = static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
    run.out = streams.has("out") ? streams.read("out") : "";
    run.err = streams.has("err") ? streams.read("err") : "";
    return run;
}

std::string small_scene(const std::string& options, const std::string& world) {
    return "LookAt 0 -5 0  0 0 0  0 0 1 Camera \"perspective\"\n"
           "Film \"fleximage\" \"integer xresolution\" [8] \"integer yresolution\" [6]"
           " \"string filename\" [\"out\"]\n" +
           options +
           "\nWorldBegin\nLightSource \"point\" \"point from\" [0 -5 3] \"color L\" [40 40 40]\n"
           "Shape \"sphere\" \"float radius\" [1]\n" +
           world + "\nWorldEnd\n";
}

void expect_refused(const BoundedRun& run, const std::string& message) {
    constexpr std::size_t kLongestMessages = 20000;
    const std::string shown = run.err.substr(0, kLongestMessages);
    EXPECT_FALSE(run.beyond_bounds) << figure_of(run) << shown;
    EXPECT_EQ(run.exit_code, 3) << shown;
    EXPECT_LT(run.err.size(), kLongestMessages);
    EXPECT_THAT(shown, testing::HasSubstr(message));
    EXPECT_THAT(shown, testing::ContainsRegex("[a-z>]:([0-9]+:[0-9]+:)? error: |command line: .*: "
                                              "error: |error: scene.lxs: "));
}

std::string figure_of(const BoundedRun& run) {
    char text[120];
    std::snprintf(text, sizeof text, "exit code %d, %.1f CPU s, %.0f MB", run.exit_code,
                  run.cpu_seconds, run.peak_megabytes);
    return text;
}

}  // namespace stress
