// Wrapped tasks, and the functions of oneTBB that this program has in the library's place.
#include "task_span.h"

#include <dlfcn.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <string>
#include <utility>

namespace task_span {
namespace {

namespace d1 = tbb::detail::d1;

/// What is measured; none: calls are handed on as they are.
struct Account {
    const std::function<double()>& clock;
    int processors = 1;
    double read = 0;    ///< the clock when it was last looked at
    double now = 0;     ///< reckoned time of what is being done
    double waited = 0;  ///< reckoned end of the last task of those that are being waited for
    Span span = {};

    /// What went on since the clock was last looked at, took its time.
    void advance() {
        const double seconds = clock();
        now += seconds - read;
        span.work += seconds - read;
        read = seconds;
    }
};

// The library's functions have no room for an argument of ours.
Account* account = nullptr;

/// Measuring lasts as long as this lives.
struct Opened {
    explicit Opened(Account& opened) { account = &opened; }
    ~Opened() { account = nullptr; }
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;
};

/// A task that begins when it was spawned, whenever it is its turn.
class Timed : public d1::task {
  public:
    Timed(d1::task& whole, double start) : whole_(whole), start_(start) {}

    d1::task* execute(d1::execution_data& data) override {
        account->advance();
        const double before = account->now;
        account->now = start_;
        for (d1::task* next = &whole_; next;)
            next = next->execute(data);
        account->advance();
        account->waited = std::max(account->waited, account->now);
        account->now = before;
        delete this;
        return nullptr;
    }
    d1::task* cancel(d1::execution_data& data) override {
        for (d1::task* next = &whole_; next;)
            next = next->cancel(data);
        delete this;
        return nullptr;
    }

  private:
    d1::task& whole_;
    double start_;
};

/// `task` itself, or with an account one that is timed.
d1::task& timed(d1::task& task) {
    if (!account) return task;
    account->advance();
    ++account->span.tasks;
    return *new Timed(task, account->now);
}

/// Until `wait` returns, tasks that end are those that it waits for: the thread takes what was
/// spawned last.
template <class Wait>
void reckon_wait(const Wait& wait) {
    if (!account) return wait();
    account->advance();
    const double outer = std::exchange(account->waited, account->now);
    wait();
    account->advance();
    account->now = std::max(account->now, account->waited);
    account->waited = outer;
}

/// The function of the library that is called `name`, which one of ours hides.
template <class Function>
Function* in_library(const char* name) {
    void* const found = dlsym(RTLD_NEXT, name);
    if (!found) throw std::runtime_error(std::string("no ") + name + " in this version of oneTBB");
    return reinterpret_cast<Function*>(found);
}

}  // namespace

double seconds_on_the_clock() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

Span measure(int processors, const std::function<void()>& body,
             const std::function<double()>& clock) {
    const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
    Account own{clock, processors, clock()};
    {
        const Opened opened(own);
        body();
        own.advance();
    }
    own.span.span = own.now;
    return own.span;
}

}  // namespace task_span

// oneTBB's entry points (oneapi/tbb/detail/_task.h).
namespace tbb::detail::r1 {

using task_span::in_library;

void spawn(d1::task& task, d1::task_group_context& context) {
    static auto* const real = in_library<void(d1::task&, d1::task_group_context&)>(
        "_ZN3tbb6detail2r15spawnERNS0_2d14taskERNS2_18task_group_contextE");
    real(task_span::timed(task), context);
}

void spawn(d1::task& task, d1::task_group_context& context, d1::slot_id slot) {
    static auto* const real = in_library<void(d1::task&, d1::task_group_context&, d1::slot_id)>(
        "_ZN3tbb6detail2r15spawnERNS0_2d14taskERNS2_18task_group_contextEt");
    real(task_span::timed(task), context, slot);
}

void execute_and_wait(d1::task& task, d1::task_group_context& context, d1::wait_context& wait,
                      d1::task_group_context& wait_group) {
    static auto* const real = in_library<void(d1::task&, d1::task_group_context&, d1::wait_context&,
                                              d1::task_group_context&)>(
        "_ZN3tbb6detail2r116execute_and_waitERNS0_2d14taskERNS2_18task_group_contextERNS2_12wait_"
        "contextES6_");
    task_span::reckon_wait([&] { real(task_span::timed(task), context, wait, wait_group); });
}

void wait(d1::wait_context& wait, d1::task_group_context& context) {
    static auto* const real = in_library<void(d1::wait_context&, d1::task_group_context&)>(
        "_ZN3tbb6detail2r14waitERNS0_2d112wait_contextERNS2_18task_group_contextE");
    task_span::reckon_wait([&] { real(wait, context); });
}

int max_concurrency(const d1::task_arena_base* arena) {
    static auto* const real = in_library<int(const d1::task_arena_base*)>(
        "_ZN3tbb6detail2r115max_concurrencyEPKNS0_2d115task_arena_baseE");
    return task_span::account ? task_span::account->processors : real(arena);
}

}  // namespace tbb::detail::r1
