// The command line of aips-bench.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exit_code.h"

namespace bench {

/// Which of the commands is asked for.
enum class Command : std::uint8_t {
    Run,
    Reference,
    Table,
    Agreement,
    Report,
    Paper,
    Methods,
    RenderOne
};

struct BenchCommandLine {
    Command command = Command::Run;
    std::vector<std::string> scenes;
    std::vector<std::string> methods;
    std::vector<std::string> variants{"fixed", "shipped"};
    std::vector<double> budgets_s{5, 10, 20, 40, 80};
    unsigned seeds = 3;
    unsigned threads = 0;
    std::uint32_t width_px = 0;
    std::string clock = "both";
    std::vector<std::string> set;
    std::string baseline = "sppm";
    std::optional<unsigned> photons_per_pass;
    bool photon_part = false;
    std::string folder;  ///< --out of run, DIR of agreement and report, JOB of render-one
    std::vector<std::string> shown;  ///< of table: DIR, or NAME=DIR with an error
    std::string shown_error;         ///< of table: a figure; "": comparisons
    std::optional<double> shown_budget_s;
    std::string smaller_radius;  ///< of agreement: DIR of the study that tells the bias
    std::string references = "out/bench-references";
    std::string method_table, scene_table, scene_folder;
    std::string report_file, report_page;
    double seconds = 60;  ///< of references
    bool up_to = false;
    std::vector<std::string> figures;  ///< of the paper; empty: all
    double scale = 1;
    std::string paper_table;
    bool any_build = false;
};

/// Fills `command`. Returns an exit code if there is nothing left to do: after --help, and after a
/// mistake (printed on standard error).
std::optional<ExitCode> parse_command_line(int argc, const char* const* argv,
                                           BenchCommandLine& command);

}  // namespace bench
