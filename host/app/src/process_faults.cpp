// Faults that the system would end the process for, turned into errors that can be reported.
#include "lxs/host/process_faults.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "lxs/host/exit_code.h"

namespace lxs {
namespace {

/// Takes no memory of its own: there may be none left.
[[noreturn]] void end_after_uncaught() {
    try {
        if (const std::exception_ptr error = std::current_exception())
            std::rethrow_exception(error);
        std::fputs("error: internal error: the program was asked to end itself\n", stderr);
    } catch (const std::bad_alloc&) {
        std::fputs("error: out of memory\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: internal error: %s\n", error.what());
    } catch (...) {
        std::fputs("error: internal error: an exception of unknown type\n", stderr);
    }
    ::_exit(static_cast<int>(ExitCode::InternalError));
}

}  // namespace

void receive_faults_as_errors() {
    for (const int number : {SIGXFSZ, SIGPIPE})
        std::signal(number, SIG_IGN);
    std::set_terminate(&end_after_uncaught);
}

}  // namespace lxs
