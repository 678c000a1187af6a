// Parts of a render, and their merging.
#include "lxs/merge/render_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

#include "lxs/merge/merge_command.h"

namespace lxs {
namespace {

namespace fs = std::filesystem;

/// ball.exr, 2 -> ball_part2.exr.
std::string part_name(const std::string& file, std::uint32_t number) {
    const fs::path path(file);
    const std::string name =
        fmt::format("{}_part{}{}", path.stem().string(), number, path.extension().string());
    return (path.parent_path() / name).string();
}

}  // namespace

CommandLine part_of_render(const CommandLine& asked, std::uint32_t rank, std::uint32_t count) {
    CommandLine part = asked;
    if (part.passes) *part.passes = *part.passes / count + (rank < *part.passes % count ? 1 : 0);
    part.seeds_above = rank;
    part.output = part_name(*asked.output, rank + 1);
    if (part.checkpoint) part.checkpoint = part_name(*asked.checkpoint, rank + 1);
    if (rank == 0) {
        part.merged_output = asked.output;
        return part;
    }
    part.learned_out.reset();
    part.statistics.reset();
    part.display_server.reset();
    part.serve.reset();
    part.verbosity = Verbosity::Quiet;
    return part;
}

ExitCode merge_parts(const CommandLine& asked, std::uint32_t count) {
    std::vector<std::string> words{"lxsmerge", "-o", *asked.output};
    if (asked.verbosity == Verbosity::Quiet) words.emplace_back("--quiet");
    for (std::uint32_t rank = 0; rank < count; ++rank)
        words.push_back(part_name(*asked.output, rank + 1));
    std::vector<const char*> arguments(words.size());
    std::ranges::transform(words, arguments.begin(),
                           [](const std::string& w) { return w.c_str(); });
    const ExitCode code = run_lxsmerge(static_cast<int>(arguments.size()), arguments.data());
    if (code != ExitCode::Success) return code;
    for (std::uint32_t rank = 0; rank < count; ++rank) {
        const fs::path image = part_name(*asked.output, rank + 1);
        std::error_code ignored;
        fs::remove(image, ignored);
        fs::remove(fs::path(image).replace_extension(".png"), ignored);
    }
    return code;
}

}  // namespace lxs
