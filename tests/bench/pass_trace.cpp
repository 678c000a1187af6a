// What a render has done after a pass, and a record of it that stays small however long it runs.
#include "pass_trace.h"

namespace bench {

void PassTrace::add(const PassTotals& totals) {
    last_ = totals;
    if ((totals.passes - 1) % stride_ != 0) return;
    kept_.push_back(totals);
    if (kept_.size() < kMostEntries) return;
    stride_ *= 2;
    std::erase_if(kept_,
                  [&](const PassTotals& entry) { return (entry.passes - 1) % stride_ != 0; });
}

std::vector<PassTotals> PassTrace::entries() const {
    std::vector<PassTotals> all = kept_;
    if (last_.passes > 0 && all.back().passes != last_.passes) all.push_back(last_);
    return all;
}

}  // namespace bench
