// Ctrl-C and SIGTERM during a render.
#include "lxs/host/interruption.h"

#include <unistd.h>

#include <atomic>
#include <csignal>

#include "lxs/host/exit_code.h"

namespace lxs {
namespace {

// A signal handler has no argument to carry state in, so this one flag has to be global.
std::atomic<bool> signal_seen = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void note_signal(int /*number*/) {
    if (signal_seen.exchange(true)) ::_exit(static_cast<int>(ExitCode::Interrupted));
}

void set_handlers(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    ::sigemptyset(&action.sa_mask);
    for (const int number : {SIGINT, SIGTERM})
        ::sigaction(number, &action, nullptr);
}

}  // namespace

Interruption::Interruption() {
    signal_seen = false;
    set_handlers(&note_signal);
}

Interruption::~Interruption() {
    set_handlers(SIG_DFL);
}

bool Interruption::requested() const {
    return signal_seen;
}

}  // namespace lxs
