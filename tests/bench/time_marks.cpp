// When snapshots are due: after the pass in which a clock passes a mark, and after given passes.
#include "time_marks.h"

#include <algorithm>

namespace bench {

TimeMarks::TimeMarks(std::span<const double> budgets_s, const std::string& clock) {
    if (budgets_s.empty()) return;
    std::vector<double> times(budgets_s.begin(), budgets_s.end());
    times.push_back(*std::min_element(times.begin(), times.end()) / 2);
    for (const char* name : {"cpu", "wall"}) {
        if (clock != "both" && clock != name) continue;
        for (const double seconds : times)
            pending_.push_back({name, seconds});
    }
}

std::vector<TimeMark> TimeMarks::due(double cpu_s, double wall_s) {
    std::vector<TimeMark> passed;
    std::erase_if(pending_, [&](const TimeMark& mark) {
        const bool is_due = (mark.clock == "cpu" ? cpu_s : wall_s) >= mark.seconds;
        if (is_due) passed.push_back(mark);
        return is_due;
    });
    return passed;
}

bool PassMarks::due(std::uint64_t passes) {
    return std::erase_if(pending_, [&](std::uint64_t mark) { return mark <= passes; }) > 0;
}

}  // namespace bench
