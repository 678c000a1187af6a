// The runs that an experiment of the paper consists of, and in which order.
#pragma once

#include <vector>

#include "experiment.h"
#include "method_table.h"
#include "run_settings.h"
#include "scene_table.h"

namespace bench {

/// Snapshots are taken after 1, 2, 4, ... passes and the last.
std::vector<std::uint64_t> pass_marks(std::uint64_t passes);

/// Snapshots are taken after a quarter, half and all of the seconds.
std::vector<double> time_marks(double seconds);

/// Scene by scene, seed by seed (1 to `seeds`), all cases in turn. `scenes` are those of the
/// experiment in its order; radius schedules are as shipped. A run's method is its case's name.
/// Throws StudyError for an unknown method.
std::vector<RunSettings> plan_experiment(const Experiment& experiment,
                                         const std::vector<BenchScene>& scenes,
                                         const MethodTable& methods, unsigned seeds,
                                         unsigned threads);

}  // namespace bench
