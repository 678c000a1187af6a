// The runs that an experiment of the paper consists of, and in which order.
#include "experiment_plan.h"

namespace bench {
namespace {

RunSettings settings_for(const Experiment& experiment, const PaperCase& one,
                         const MethodTable& methods) {
    const Method& method = find_method(methods.methods, one.method);
    RunSettings settings;
    settings.width_px = experiment.width_px;
    settings.height_px = experiment.height_px;
    settings.method = one.name;
    settings.variant = method.has_variants ? kShipped : kAny;
    settings.integrator = method.integrator;
    settings.sampler = method.sampler;
    settings.set = overrides(methods, method, settings.variant, {});
    settings.set.insert(settings.set.end(), one.set.begin(), one.set.end());
    settings.clock = "cpu";
    if (experiment.passes > 0) settings.passes = pass_marks(experiment.passes);
    return settings;
}

}  // namespace

std::vector<std::uint64_t> pass_marks(std::uint64_t passes) {
    std::vector<std::uint64_t> marks;
    for (std::uint64_t mark = 1; mark < passes; mark *= 2)
        marks.push_back(mark);
    marks.push_back(passes);
    return marks;
}

std::vector<double> time_marks(double seconds) {
    return {seconds / 4, seconds / 2, seconds};
}

std::vector<RunSettings> plan_experiment(const Experiment& experiment,
                                         const std::vector<BenchScene>& scenes,
                                         const MethodTable& methods, unsigned seeds,
                                         unsigned threads) {
    std::vector<RunSettings> runs;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const std::string checksum = scene_checksum(scenes[i].file);
        for (unsigned seed = 1; seed <= seeds; ++seed) {
            for (const PaperCase& one : experiment.cases) {
                RunSettings settings = settings_for(experiment, one, methods);
                settings.scene = scenes[i].name;
                settings.scene_file = scenes[i].file.string();
                settings.scene_sha1 = checksum;
                settings.seed = seed;
                settings.threads = threads;
                const double seconds = experiment.scenes[i].seconds;
                if (seconds > 0) settings.budgets_s = time_marks(seconds);
                runs.push_back(std::move(settings));
            }
        }
    }
    return runs;
}

}  // namespace bench
