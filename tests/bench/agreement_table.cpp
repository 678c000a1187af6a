// `aips-bench agreement`: its findings as Markdown.
#include "agreement_table.h"

#include <fmt/format.h>

namespace bench {
namespace {

std::string percent(const Json& value) {
    return value.is_number() ? fmt::format("{:+.2f} %", 100 * value.get<double>()) : "-";
}

std::string place_text(const Json& place) {
    if (place.is_null()) return "mean";
    return fmt::format("block {}, {}", place.at("row").get<int>(), place.at("column").get<int>());
}

std::string verdict_text(const Json& row) {
    std::string verdict = row.at("verdict");
    if (row.at("misses").is_null()) return verdict;
    return fmt::format("{}: misses {}", verdict, row.at("misses").get<std::string>());
}

std::string row_text(const Json& row) {
    return fmt::format(
        "| {} | {} | {} | {:.4f} | {} | {:.4f} +- {:.4f} | {:.2g} | {} | {:.1f} % | {} |\n",
        row.at("method").get<std::string>(), row.at("against").get<std::string>(),
        row.at("seeds").get<int>(), row.at("mean_ratio").get<double>(),
        percent(row.at("claimed_bias")), row.at("weighted_ratio").get<double>(),
        row.at("standard_error").get<double>(), row.at("smallest_p").get<double>(),
        place_text(row.at("smallest_at")), 100 * row.at("detectable").get<double>(),
        verdict_text(row));
}

std::string heading(const Json& document, const std::string& scene) {
    const Json& first = document.at("tests").front();
    return fmt::format(
        "## {}: agreement at one fixed radius\n\n"
        "A difference is one with p below {:.2g} in a block or the mean (family-wise {:g}).\n\n"
        "| method | against | seeds | mean ratio | claimed bias | weighted, without it | smallest "
        "p | "
        "there | detectable | verdict |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        scene, first.at("threshold").get<double>(), document.at("significance").get<double>());
}

}  // namespace

std::string agreement_table(const Json& document) {
    std::string text;
    if (document.at("tests").empty()) return text;
    for (const std::string scene : document.at("study").at("scenes")) {
        text += heading(document, scene);
        for (const Json& row : document.at("tests")) {
            if (row.at("scene") == scene) text += row_text(row);
        }
        text += '\n';
    }
    return text;
}

}  // namespace bench
