// What `aips-bench agreement` might find in the synthetic study: every verdict there is.
#include "synthetic_agreement.h"

#include <utility>

#include "agreement_command.h"
#include "synthetic_study.h"

namespace bench::test {
namespace {

struct Ratio {
    double value, half_interval, detectable;
};

Json test_of(const char* scene, const char* method, const char* against, Ratio ratio,
             const char* verdict) {
    return {{"scene", scene},
            {"variant", "fixed"},
            {"method", method},
            {"against", against},
            {"seeds", 12},
            {"mean_ratio", ratio.value},
            {"claimed_bias", nullptr},
            {"weighted_ratio", ratio.value},
            {"weighted_low", ratio.value - ratio.half_interval},
            {"weighted_high", ratio.value + ratio.half_interval},
            {"standard_error", ratio.half_interval / 2},
            {"smallest_p", 0.25},
            {"threshold", 1.5e-6},
            {"smallest_at", nullptr},
            {"detectable", ratio.detectable},
            {"detectable_in_block", ratio.detectable},
            {"misses", nullptr},
            {"verdict", verdict}};
}

Json in_block(Json test, int row, int column) {
    test["smallest_p"] = 2e-9;
    test["smallest_at"] = {{"row", row}, {"column", column}};
    return test;
}

Json with(Json test, const char* key, Json value) {
    test[key] = std::move(value);
    return test;
}

Json synthetic_tests() {
    const Ratio sppm{kSyntheticRatio, kSyntheticHalfInterval, 0.04};
    const char* refs = "references";
    return {with(test_of(kPlainScene, "sppm", refs, sppm, "agrees"), "claimed_bias", -0.013),
            test_of(kPlainScene, "better", refs, {1.001, 0.002, 0.005}, "agrees"),
            test_of(kPlainScene, "better", "sppm", {0.999, 0.001, 0.003}, "agrees"),
            in_block(test_of(kPlainScene, "worse", refs, {0.8, 0.01, 0.02}, "differs"), 0, 5),
            test_of(kPlainScene, "worse", "sppm", {0.97, 0.2, 0.4}, "open"),
            test_of(kNastyScene, "sppm", refs, {1.2, 0.6, 0.9}, "open"),
            with(test_of(kNastyScene, "better", refs, {0.4, 0.01, 0.02}, "does not converge"),
                 "misses", kNastyScene)};
}

}  // namespace

void write_synthetic_agreement(const std::filesystem::path& folder, const Json& summary) {
    write_json(folder / "study/agreement.json", {{"schema", kAgreementSchema},
                                                 {"created", summary.at("created")},
                                                 {"study", summary.at("study")},
                                                 {"significance", 1e-4},
                                                 {"decisive", 0.05},
                                                 {"smaller_radius", "half"},
                                                 {"tests", synthetic_tests()}});
}

}  // namespace bench::test
