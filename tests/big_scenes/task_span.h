// Work and span of what oneTBB's tasks do, told by one thread (Cilkview: He, Leiserson and
// Leiserson 2010): a program that has task_span.cpp among its sources comes before the library with
// the functions by which tasks are spawned and waited for, also those that other libraries call.
//
// While a span is measured, every task begins, in reckoned time, when it was spawned, and who waits
// goes on when the last of what it waited for has ended. Only one thread may work meanwhile.
#pragma once

#include <cstdint>
#include <functional>

namespace task_span {

struct Span {
    double work = 0;  ///< seconds that one processor takes
    double span = 0;  ///< seconds that any number of them take at least: the longest chain
    std::uint64_t tasks = 0;

    /// Seconds that `processors` take at most, if a free one never leaves a task waiting (Graham
    /// 1966, Brent 1974).
    double on(int processors) const { return (work - span) / processors + span; }
};

/// A clock that is read in a fraction of a microsecond, as it is some times for each task. The
/// seconds of this thread's processor take many times as long to ask for.
double seconds_on_the_clock();

/// Runs `body` on this thread, with tasks divided as for `processors` threads. `clock`: seconds so
/// far.
Span measure(int processors, const std::function<void()>& body,
             const std::function<double()>& clock = seconds_on_the_clock);

}  // namespace task_span
