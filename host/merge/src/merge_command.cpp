// The command lxsmerge.
#include "lxs/merge/merge_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lxs/host/command_line_mistake.h"
#include "lxs/host/console_log.h"
#include "lxs/host/counted.h"
#include "lxs/host/error_json.h"
#include "lxs/host/failure.h"
#include "lxs/host/output_files.h"
#include "lxs/host/written_files.h"
#include "lxs/imaging/atomic_file.h"
#include "lxs/imaging/image_header.h"
#include "lxs/merge/merger.h"
#include "lxs/merge/statistics_sums.h"
#include "lxs/sdk/plugin.h"

namespace lxs {
namespace {

struct MergeLine {
    std::vector<std::string> inputs, statistics_of_inputs;
    std::string output, statistics;
    bool quiet = false;
};

std::string check_image_name(const std::string& name) {
    return has_suffix(name, ".exr") ? "" : "the name must end in .exr: " + name;
}

std::optional<ExitCode> parse(int argc, const char* const* argv, MergeLine& line) {
    CLI::App app("Merges renders of one scene with different seeds into one image.", "lxsmerge");
    app.set_version_flag("--version", version());
    app.failure_message(&mistake_message);
    app.footer(exit_code_help(kMergeExitCodes));
    app.add_option("images", line.inputs, "images that lxsrender has written, at least two")
        ->required()
        ->expected(2, CLI::detail::expected_max_vector_size)
        ->type_name("A.exr B.exr");
    app.add_option("-o,--output", line.output, "image to write")
        ->required()
        ->type_name("FILE.exr")
        ->check(CLI::Validator(check_image_name, ""));
    CLI::Option* const statistics =
        app.add_option("--stats", line.statistics,
                       "JSON file to write with seeds, counts and error")
            ->type_name("FILE.json");
    app.add_option("--stats-of", line.statistics_of_inputs,
                   "statistics of the images, to be summed up in that file")
        ->needs(statistics)
        ->type_name("A.json B.json");
    app.add_flag("--quiet", line.quiet, "print warnings and errors only");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? ExitCode::Success : ExitCode::Usage;
    }
    return std::nullopt;
}

std::string statistics_of(const MergeLine& line, const Merger& merger,
                          const std::optional<ErrorEstimate>& error,
                          const std::optional<StatisticsSums>& renders) {
    nlohmann::ordered_json json;
    json["version"] = version();
    json["merged"] = line.inputs;
    json["seeds"] = merger.seeds();
    if (error) json["estimated error"] = error_json(*error);
    json["counts"] = {{"passes", merger.passes()},
                      {"samples per pixel", merger.samples_per_pixel()}};
    if (renders) json["renders"] = renders->merged();
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

void write(const std::string& path, std::span<const std::byte> bytes) {
    try {
        write_file_atomically(path, bytes);
    } catch (const std::runtime_error& error) {
        throw OutputFailure(error.what());
    }
}

Merger merge(const std::vector<std::string>& inputs) {
    Merger merger;
    for (const std::string& path : inputs) {
        try {
            merger.add(read_exr(path), path);
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::runtime_error& error) {
            throw MergeRefusal(error.what());
        }
    }
    return merger;
}

std::optional<StatisticsSums> sum_statistics(const MergeLine& line, const Merger& merger) {
    if (line.statistics_of_inputs.empty()) return std::nullopt;
    StatisticsSums sums;
    for (const std::string& path : line.statistics_of_inputs) {
        std::ifstream file(path, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        if (!file) throw MergeRefusal(fmt::format("cannot read '{}'", path));
        sums.add(text, path, merger.seeds());
    }
    return sums;
}

/// Throws OutputFailure if the result can't be written, or would replace what it is made from.
void check_outputs(const MergeLine& line, ConsoleLog& log) {
    for (const std::string& path : {line.output, line.statistics})
        check_writable(path, log);
    const WrittenFiles written({{"the image", line.output}, {"the statistics", line.statistics}});
    for (const std::string& image : line.inputs)
        written.check_read({"the image to merge", image});
    for (const std::string& statistics : line.statistics_of_inputs)
        written.check_read({"the statistics to sum up", statistics});
}

void merge_files(const MergeLine& line, ConsoleLog& log) {
    check_outputs(line, log);
    const Merger merger = merge(line.inputs);
    const std::optional<StatisticsSums> renders = sum_statistics(line, merger);
    const std::optional<ErrorEstimate> error = merger.error();
    ExrImage image = merger.merged();
    if (error) describe(*error, image.metadata);
    write(line.output, encode_exr(image));
    if (!line.statistics.empty()) {
        const std::string text = statistics_of(line, merger, error, renders);
        write(line.statistics, std::as_bytes(std::span(text)));
    }
    std::string said =
        fmt::format("wrote {}: {} of {} samples per pixel together", line.output,
                    counted(merger.images(), "image", "images"), merger.samples_per_pixel());
    if (error) said += fmt::format(", estimated error {:.2g} %", 100 * error->relative());
    log.info(said);
}

}  // namespace

ExitCode run_lxsmerge(int argc, const char* const* argv) {
    MergeLine line;
    if (const auto done = parse(argc, argv, line)) return *done;
    ConsoleLog log(line.quiet ? Verbosity::Quiet : Verbosity::Normal);
    try {
        merge_files(line, log);
    } catch (const MergeRefusal& refusal) {
        log.error(refusal.what());
        return ExitCode::BadInput;
    } catch (const OutputFailure& failure) {
        log.error(failure.what());
        return ExitCode::OutputFailure;
    } catch (const std::bad_alloc&) {
        log.error("out of memory");
        return ExitCode::InternalError;
    }
    return ExitCode::Success;
}

}  // namespace lxs
