// What a report says of `aips-bench agreement`.
#include "report_agreement.h"

#include <fmt/format.h>

#include "agreement_command.h"

namespace bench {
namespace {

/// What the page shows of a test. Files from before there were intervals have none.
Json test_facts(const Json& test) {
    Json facts;
    for (const char* key :
         {"scene", "method", "against", "seeds", "mean_ratio", "claimed_bias", "weighted_ratio",
          "smallest_p", "threshold", "smallest_at", "detectable", "misses", "verdict"})
        facts[key] = test.at(key);
    for (const char* key : {"weighted_low", "weighted_high"})
        facts[key] = test.value(key, Json());
    return facts;
}

Json facts_of(const Json& found, const Json& summary) {
    const std::string created = found.at("created"), last_run = summary.at("created");
    const std::string smaller_radius = found.at("smaller_radius");
    Json tests = Json::array();
    for (const Json& test : found.at("tests"))
        tests.push_back(test_facts(test));
    return {{"created", created},
            {"is_older", created < last_run},  // ISO 8601, UTC
            {"significance", found.at("significance")},
            {"decisive", found.at("decisive")},
            {"claims_bias", !smaller_radius.empty()},
            {"tests", std::move(tests)}};
}

}  // namespace

Json report_agreement(const std::filesystem::path& study_folder, const Json& summary) {
    const std::filesystem::path file = study_folder / "agreement.json";
    if (!std::filesystem::exists(file)) return nullptr;
    const Json found = read_json(file, kAgreementSchema);
    try {
        return facts_of(found, summary);
    } catch (const Json::exception& error) {
        throw StudyError(fmt::format("'{}' is damaged: {}", file.string(), error.what()));
    }
}

}  // namespace bench
