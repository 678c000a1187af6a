// What a process prints, kept in memory in place of its standard output and error.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace lxs {

/// From now on, until the process ends. Where memory for it can't be had, output is dropped.
class CapturedOutput {
  public:
    CapturedOutput() : file_(::memfd_create("output", MFD_CLOEXEC)) {
        const int target = file_ >= 0 ? file_ : ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        std::fflush(stdout);
        for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
            ::dup2(target, stream);
    }
    CapturedOutput(const CapturedOutput&) = delete;
    CapturedOutput& operator=(const CapturedOutput&) = delete;

    std::string text() const {
        std::fflush(stdout);
        std::fflush(stderr);
        const off_t size = file_ >= 0 ? ::lseek(file_, 0, SEEK_END) : 0;
        std::string text(static_cast<std::size_t>(std::max<off_t>(size, 0)), '\0');
        const ssize_t read = ::pread(file_, text.data(), text.size(), 0);
        text.resize(static_cast<std::size_t>(std::max<ssize_t>(read, 0)));
        return text;
    }

  private:
    int file_;
};

}  // namespace lxs
