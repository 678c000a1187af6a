// Ctrl-C, SIGTERM and SIGHUP during a render, and other requests to end it.
#include "lxs/host/interruption.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <mutex>

#include "lxs/host/exit_code.h"

namespace lxs {
namespace {

// Signal handlers belong to the process, and have no argument to carry state in: the flag and the
// count of its users have to be global.
std::atomic<bool> signal_seen = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void note_signal(int /*number*/) {
    if (signal_seen.exchange(true)) ::_exit(static_cast<int>(ExitCode::Interrupted));
}

/// A terminal that is closed (SIGHUP) takes no finished pass with it either.
constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

/// How many Interruptions there are, and what the signals did before the first.
struct Installed {
    std::mutex mutex;
    int users = 0;
    std::array<struct sigaction, kSignals.size()> before{};
};

Installed& installed() {
    static Installed state;
    return state;
}

void install(Installed& state) {
    struct sigaction action {};
    action.sa_handler = &note_signal;
    action.sa_flags = SA_RESTART;
    ::sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        ::sigaction(kSignals[i], nullptr, &state.before[i]);
        const bool ignored = state.before[i].sa_handler == SIG_IGN;  // as nohup does with SIGHUP
        if (!(kSignals[i] == SIGHUP && ignored)) ::sigaction(kSignals[i], &action, nullptr);
    }
}

}  // namespace

Interruption::Interruption(bool signals) : signals_(signals) {
    if (!signals_) return;
    Installed& state = installed();
    const std::lock_guard lock(state.mutex);
    if (state.users++ > 0) return;
    signal_seen = false;
    install(state);
}

Interruption::~Interruption() {
    if (!signals_) return;
    Installed& state = installed();
    const std::lock_guard lock(state.mutex);
    if (--state.users > 0) return;
    for (std::size_t i = 0; i < kSignals.size(); ++i)
        ::sigaction(kSignals[i], &state.before[i], nullptr);
}

bool Interruption::signalled() const {
    return signals_ && signal_seen;
}

bool Interruption::requested() const {
    return signalled() || !asked_by_.empty();
}

void Interruption::request(std::string_view who) {
    asked_by_ = who;
}

std::string Interruption::reason() const {
    if (signalled()) return "stopped by Ctrl-C or a signal";
    return asked_by_.empty() ? std::string() : "stopped by " + std::string(asked_by_);
}

}  // namespace lxs
