// A report's page: what the bundle of npm packages left, with a study's data put in.
#include "report_page.h"

#include <string_view>

namespace bench {

std::string script_safe_json(const Json& data) {
    std::string safe;
    for (const char c : data.dump(-1, ' ', false, Json::error_handler_t::replace)) {
        if (c == '<')
            safe += "\\u003c";  // "<" stands in strings alone
        else
            safe += c;
    }
    return safe;
}

std::string fill_page(const std::string& page, const Json& data) {
    const std::string_view mark = kReportDataMark;
    const auto at = page.find(mark);
    if (at == std::string::npos || page.find(mark, at + 1) != std::string::npos) {
        throw StudyError("the report's page does not contain its mark for data exactly once");
    }
    return page.substr(0, at) + script_safe_json(data) + page.substr(at + mark.size());
}

}  // namespace bench
