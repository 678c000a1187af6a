// Which runs a study consists of, and in which order.
#pragma once

#include <string>
#include <vector>

#include "method_table.h"
#include "run_settings.h"
#include "scene_table.h"

namespace bench {

/// What `aips-bench run` is asked for.
struct Study {
    std::vector<BenchScene> scenes;
    std::vector<std::string> methods;
    std::vector<std::string> variants;  ///< of "fixed" and "shipped"
    unsigned seeds = 3;                 ///< seeds 1 to this
    std::vector<double> budgets_s;      ///< ascending
    unsigned threads = 0;
    std::uint32_t width_px = 0;
    std::string clock = "both";
    std::vector<std::string> set;
    std::string baseline = "sppm";
};

/// Scene by scene, seed by seed, variant by variant, all methods in turn: A B C A B C. A method
/// without variants comes once for each seed.
std::vector<RunSettings> plan_runs(const Study& study, const MethodTable& table);

}  // namespace bench
