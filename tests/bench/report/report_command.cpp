// `aips-bench report`: a study as one HTML file that needs no network.
#include "report_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "display_image.h"
#include "lxs/host/failure.h"
#include "lxs/imaging/atomic_file.h"
#include "photon_strips.h"
#include "report_agreement.h"
#include "report_curves.h"
#include "report_images.h"
#include "report_page.h"
#include "study_summary.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kMemoryPoints = 50;
/// What a page may take, what is left to its crops at least, and what photon pictures may take.
constexpr double kPageBytes = 9e6, kLeastPictureBytes = 1.5e6, kMostStripBytes = 3e6;

Json finished(const Json& runs) {
    Json done = Json::array();
    for (const Json& run : runs) {
        if (run.at("status") == "done") done.push_back(run);
    }
    return done;
}

Json failures(const Json& runs) {
    Json failed = Json::array();
    for (const Json& run : runs) {
        if (run.at("status") == "done") continue;
        failed.push_back({{"settings", run.at("settings")}, {"message", run.value("message", "")}});
    }
    return failed;
}

/// What the page shows of them.
Json comparison_facts(const Json& comparisons) {
    Json shown = Json::array();
    for (const Json& entry : comparisons) {
        Json facts;
        for (const char* key : {"scene", "variant", "method", "clock", "budget_s", "part", "metric",
                                "ratio", "low", "high", "seeds"})
            facts[key] = entry.at(key);
        shown.push_back(std::move(facts));
    }
    return shown;
}

/// Every few passes, the first and the last among them.
Json memory_trace(const Json& trace) {
    const std::size_t step = trace.size() / kMemoryPoints + 1;
    Json points = Json::array();
    for (std::size_t i = 0; i < trace.size(); ++i) {
        if (i % step == 0 || i + 1 == trace.size())
            points.push_back({trace[i].at("pass"), trace[i].at("resident_bytes")});
    }
    return points;
}

/// The page shows three digits; all others would make up a third of its size.
void shorten_numbers(Json& json) {
    if (json.is_number_float()) json = std::stod(fmt::format("{:.6g}", json.get<double>()));
    if (!json.is_structured()) return;
    for (Json& part : json)
        shorten_numbers(part);
}

/// What the page says of resources: without snapshots, which make up most of a run.
Json run_facts(const Json& runs) {
    Json facts = Json::array();
    for (const Json& run : runs) {
        Json entry;
        for (const char* key : {"scene", "method", "variant", "seed"})
            entry[key] = run.at("settings").at(key);
        for (const char* key : {"phases", "totals", "peak_memory_bytes", "refused_film_samples"})
            entry[key] = run.at(key);
        entry["engine"] = Json::object();
        for (const auto& [name, value] : run.at("integrator_statistics").items()) {
            if (name.ends_with("_seconds")) entry["engine"][name] = value;
        }
        entry["memory"] = memory_trace(run.at("trace"));
        facts.push_back(std::move(entry));
    }
    return facts;
}

std::string read_page(const fs::path& page) {
    if (!fs::exists(page)) {
        throw StudyError(
            fmt::format("the report's page '{}' is not built; build the target "
                        "bench-report-assets (it needs npm)",
                        page.string()));
    }
    return read_file(page);
}

}  // namespace

Json report_data(const fs::path& study_folder, const Json& summary, ReferenceCache& references) {
    const Json& study = summary.at("study");
    const Json done = finished(summary.at("runs"));
    Json data;
    for (const char* key :
         {"created", "revisions", "machine", "study", "scenes", "methods", "seed_statistics"})
        data[key] = summary.at(key);
    data["comparisons"] = comparison_facts(summary.at("comparisons"));
    data["curves"] = report_curves(done, study);
    data["speedups"] = report_speedups(done, study);
    data["error_palette"] = colour_names(kErrorColours);
    data["agreement"] = report_agreement(study_folder, summary);
    data["runs"] = run_facts(done);
    data["failures"] = failures(summary.at("runs"));
    shorten_numbers(data);
    double left = kPageBytes - double(script_safe_json(data).size());
    const double strips = std::clamp(left - kLeastPictureBytes, 0.0, kMostStripBytes);
    data["photon_strips"] = report_photon_strips(study_folder, done, study, strips);
    shorten_numbers(data["photon_strips"]);
    left -= double(data["photon_strips"].dump().size());
    data["images"] =
        report_images(study_folder, done, study, references, std::max(left, kLeastPictureBytes));
    shorten_numbers(data["images"]);
    return data;
}

void write_report(const ReportRequest& request) {
    const std::string page = read_page(request.page);
    const fs::path file = request.study / "summary.json";
    const Json summary = read_json(file, kSummarySchema);
    ReferenceCache references(request.references);
    std::string html;
    try {
        html = fill_page(page, report_data(request.study, summary, references));
    } catch (const Json::exception& error) {
        throw StudyError(fmt::format("'{}' is damaged: {}", file.string(), error.what()));
    }
    make_folder(request.output.parent_path());
    try {
        lxs::write_file_atomically(request.output.string(), std::as_bytes(std::span(html)));
    } catch (const std::runtime_error& error) {
        throw lxs::OutputFailure(error.what());
    }
}

}  // namespace bench
