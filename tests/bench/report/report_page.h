// A report's page: what the bundle of npm packages left, with a study's data put in.
#pragma once

#include <string>

#include "study_file.h"

namespace bench {

/// Where a page's data goes; the bundled page contains it once.
inline constexpr const char* kReportDataMark = "AIPS_BENCH_REPORT_DATA";

/// The JSON in one line as an HTML script element can hold it: every "<" as \u003c, so that neither
/// "</script>" nor "<!--" occurs in it; another parser reads the same values.
std::string script_safe_json(const Json& data);

/// `page` with the data in place of the mark. Throws StudyError if the mark isn't there exactly
/// once.
std::string fill_page(const std::string& page, const Json& data);

}  // namespace bench
