// Stands in for oneTBB's header of this name in builds with AIPS_RECORD_WORK, as parallel_for.h
// does.
#pragma once

#include <typeinfo>

#include "work_record.h"

namespace tbb {

/// As oneTBB's, of two.
template <class First, class Second>
void parallel_invoke(const First& first, const Second& second) {
    work_record::run_beside(typeid(First), first, second);
}

}  // namespace tbb
