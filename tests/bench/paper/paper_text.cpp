// paper.json of a study as Markdown: a table for each figure of the paper.
#include "paper_text.h"

#include <fmt/format.h>

namespace bench {
namespace {

std::string number(const Json& value) {
    return value.is_number() ? fmt::format("{:.3g}", value.get<double>()) : "-";
}

std::string seconds(const Json& value) {
    return value.is_number() ? fmt::format("{:.1f}", value.get<double>()) : "-";
}

std::string count(const Json& value) {
    return value.is_number() ? fmt::format("{:.0f}", value.get<double>()) : "-";
}

std::string mebibytes(const Json& bytes) {
    return bytes.is_number() ? fmt::format("{:.1f}", bytes.get<double>() / (1 << 20)) : "-";
}

/// "0.8 [0.7, 0.9]"
std::string ratio(const Json& figure) {
    if (!figure.at("ratio").is_number()) return "-";
    std::string text = number(figure.at("ratio"));
    if (figure.at("low").is_number())
        text += fmt::format(" [{}, {}]", number(figure.at("low")), number(figure.at("high")));
    if (figure.at("left_out") > 0)
        text += fmt::format(" ({} left out)", figure.at("left_out").dump());
    return text;
}

/// The three figures' ratios, or means, as cells.
std::string cells(const Json& errors, std::string (*text)(const Json& figure)) {
    return fmt::format("{} | {} | {}", text(errors.at("mse")), text(errors.at("relmse")),
                       text(errors.at("relmse_rest")));
}

std::string variance_cells(const Json& row) {
    return number(row.at("relative_variance")) + " | " + number(row.at("variance_ratio"));
}

std::string mean(const Json& figure) {
    return number(figure.at("mean"));
}

const char* part_name(const Json& experiment) {
    return experiment.at("part") == "photons" ? "photons' part of the image" : "whole image";
}

std::string passes_table(const Json& experiment, const Json& scene) {
    std::string text = fmt::format(
        "{}, {} x {} pixels, {}, after {} passes.\n\n"
        "| | MSE | relMSE | relMSE of the rest | MSE ratio | relMSE ratio | rest ratio | "
        "variance | variance ratio | against |"
        "\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        scene.at("scene").get<std::string>(), experiment.at("width_px").dump(),
        experiment.at("height_px").dump(), part_name(experiment), experiment.at("passes").dump());
    for (const Json& row : scene.at("rows")) {
        const Json& errors = row.at("equal_passes");
        text += fmt::format("| {} | {} | {} | {} | {} |\n", row.at("label").get<std::string>(),
                            cells(errors, mean), cells(errors, ratio), variance_cells(row),
                            row.at("against").get<std::string>());
    }
    return text;
}

/// Ratios at equal time, and what the passes took.
std::string cost_table(const Json& scene) {
    std::string text = fmt::format(
        "\n| | CPU s | MSE ratio at {} CPU s | relMSE ratio | rest ratio | guide nodes | guide MiB "
        "| process MiB |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n",
        seconds(scene.at("equal_time_s")));
    for (const Json& row : scene.at("rows")) {
        text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", row.at("label").get<std::string>(),
                            seconds(row.at("cpu_s")), cells(row.at("equal_time"), ratio),
                            count(row.at("guide_nodes")), mebibytes(row.at("guide_bytes")),
                            mebibytes(row.at("peak_memory_bytes")));
    }
    return text;
}

/// A column for each case, a row for each number of passes.
std::string curve_table(const Json& scene, const char* figure, const char* title) {
    const Json& rows = scene.at("rows");
    std::string head = fmt::format("\n| passes, {} |", title), rule = "| --- |";
    for (const Json& row : rows) {
        head += fmt::format(" {} |", row.at("label").get<std::string>());
        rule += " --- |";
    }
    std::string text = head + '\n' + rule + '\n';
    for (std::size_t i = 0; i < rows.front().at("curve").size(); ++i) {
        text += fmt::format("| {} |", rows.front().at("curve")[i].at("pass").dump());
        for (const Json& row : rows) {
            const Json& curve = row.at("curve");
            text += fmt::format(" {} |", i < curve.size() ? number(curve[i].at(figure)) : "-");
        }
        text += '\n';
    }
    return text;
}

std::string time_table(const Json& experiment, const Json& scene) {
    std::string text = fmt::format(
        "{}, {} x {} pixels, {}, at {} CPU s.\n\n"
        "| | passes | MSE | relMSE | relMSE of the rest | MSE ratio | relMSE ratio | rest ratio | "
        "variance | variance ratio | against |\n| --- | --- | --- | --- | --- | --- | --- | --- | "
        "--- "
        "| --- | --- |\n",
        scene.at("scene").get<std::string>(), experiment.at("width_px").dump(),
        experiment.at("height_px").dump(), part_name(experiment),
        seconds(scene.at("equal_time_s")));
    for (const Json& row : scene.at("rows")) {
        const Json& errors = row.at("equal_time");
        text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", row.at("label").get<std::string>(),
                            count(row.at("passes")), cells(errors, mean), cells(errors, ratio),
                            variance_cells(row), row.at("against").get<std::string>());
    }
    return text;
}

std::string distribution_table(const Json& experiment, const Json& scene) {
    std::string text = fmt::format(
        "{}, {} x {} pixels. Shares are of all photons gathered in those passes; correlations are "
        "rank correlations over blocks of pixels.\n\n"
        "| | passes | share in highlights | share at edges | unevenness | distance from unguided | "
        "density with error | added density with error | added density with node error |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        scene.at("scene").get<std::string>(), experiment.at("width_px").dump(),
        experiment.at("height_px").dump());
    for (const Json& row : scene.at("rows")) {
        for (const Json& stage : row.at("stages")) {
            text += fmt::format("| {} | {} to {} | {} | {} | {} | {} | {} | {} | {} |\n",
                                row.at("label").get<std::string>(), stage.at("first_pass").dump(),
                                stage.at("last_pass").dump(), number(stage.at("highlight_share")),
                                number(stage.at("edge_share")), number(stage.at("unevenness")),
                                number(stage.at("distance")), number(stage.at("error_correlation")),
                                number(stage.at("added_error_correlation")),
                                number(stage.at("added_node_error_correlation")));
        }
    }
    return text;
}

std::string scene_text(const Json& experiment, const Json& scene) {
    const std::string kind = experiment.at("kind");
    if (kind == "time") return time_table(experiment, scene);
    std::string text = passes_table(experiment, scene) + cost_table(scene);
    if (kind == "convergence") {
        text += curve_table(scene, "mse", "MSE");
        text += curve_table(scene, "relmse_rest", "relMSE of the rest");
    }
    return text;
}

std::string experiment_text(const Json& experiment) {
    std::string text = fmt::format("## Fig. {}: {}\n", experiment.at("figure").get<std::string>(),
                                   experiment.at("title").get<std::string>());
    for (const Json& scene : experiment.at("scenes"))
        text += '\n' + scene_text(experiment, scene);
    for (const Json& scene : experiment.at("distribution"))
        text += '\n' + distribution_table(experiment, scene);
    return text;
}

}  // namespace

std::string paper_text(const Json& paper) {
    std::string text = fmt::format(
        "# The paper's figures, redone\n\nScale {}, {} seeds, {} photon paths in each pass, "
        "references of {} s, {}, "
        "revision {}, {}. Errors are means over seeds; ratios are geometric means over seeds, in "
        "brackets their 95 % intervals. Below 1 is better than what it is compared with. The rest "
        "are all pixels but the worst 0.1 %; variance is relative and over seeds, without any "
        "reference."
        "\n",
        number(paper.at("scale")), paper.at("seeds").dump(), paper.at("photons_per_pass").dump(),
        number(paper.at("reference_seconds")),
        paper.at("machine").at("processor").get<std::string>(),
        paper.at("revision").get<std::string>(), paper.at("created").get<std::string>());
    for (const Json& experiment : paper.at("experiments"))
        text += '\n' + experiment_text(experiment);
    return text;
}

}  // namespace bench
