// `aips-bench report`: a study as one HTML file that needs no network.
#pragma once

#include <filesystem>

#include "run_errors.h"

namespace bench {

struct ReportRequest {
    std::filesystem::path study;  ///< folder that `run` left
    std::filesystem::path references;
    std::filesystem::path page;    ///< bundled page, made by the target bench-report-assets
    std::filesystem::path output;  ///< HTML file
};

/// All that the page shows, from the study's summary and images.
Json report_data(const std::filesystem::path& study, const Json& summary,
                 ReferenceCache& references);

/// Writes the page. Throws StudyError if the study or the page can't be read, and
/// lxs::OutputFailure.
void write_report(const ReportRequest& request);

}  // namespace bench
