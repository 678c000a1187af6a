// A run's JSON file: made from what was measured, found again when a study is resumed.
#include "run_record.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "bench_revision.h"
#include "checksum.h"
#include "lxs/host/plugin_library.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos)
            return line.substr(colon + 2);
    }
    return "unknown";
}

void make_paths_relative(Json& snapshots, const fs::path& folder) {
    for (Json& snapshot : snapshots) {
        for (const char* key : {"exr", "png"}) {
            Json& path = snapshot[key];
            if (path.is_string()) {
                path = fs::path(path.get<std::string>()).lexically_relative(folder).string();
            }
        }
    }
}

}  // namespace

Build this_build() {
    std::vector<fs::path> files{own_executable()};
    for (const auto& entry : fs::directory_iterator(lxs::own_plugin_folder())) {
        if (entry.path().extension() == ".so") files.push_back(entry.path());
    }
    std::sort(files.begin() + 1, files.end());
    return {kRevision, sha1_of_files(files)};
}

Json machine() {
    utsname system{};
    ::uname(&system);
    return {{"processor", processor_name()},
            {"hardware_threads", std::thread::hardware_concurrency()},
            {"system", fmt::format("{} {} {}", system.sysname, system.release, system.machine)}};
}

std::string utc_now() {
    return fmt::format(
        "{:%Y-%m-%dT%H:%M:%SZ}",
        fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

fs::path run_file(const fs::path& folder, const RunSettings& settings) {
    return folder / "runs" / (run_name(settings) + ".json");
}

std::optional<Json> finished_run(const fs::path& folder, const RunSettings& settings,
                                 const Build& build) {
    const fs::path file = run_file(folder, settings);
    if (!fs::exists(file)) return std::nullopt;
    Json run = read_json(file, kRunSchema);
    const bool same_build = run.value("revision", "") == build.revision &&
                            run.value("binaries_sha1", "") == build.binaries_sha1;
    const bool same = run.value("status", "") == "done" && (same_build || build.accepts_others) &&
                      run.value("settings", Json()) == to_json(settings);
    if (!same) return std::nullopt;
    for (const Json& snapshot : run.at("snapshots")) {
        if (!fs::exists(folder / snapshot.at("exr").get<std::string>())) return std::nullopt;
    }
    return run;
}

Json run_document(const fs::path& folder, const RunSettings& settings, const Build& build,
                  const std::string& started, const ProcessEnd& end, const Json& measured) {
    Json run{{"schema", kRunSchema}, {"status", end.done ? "done" : "failed"}};
    if (!end.done) run["message"] = end.message;
    run["revision"] = build.revision;
    run["binaries_sha1"] = build.binaries_sha1;
    run["settings"] = to_json(settings);
    run["machine"] = machine();
    run["started"] = started;
    if (end.done) {
        run.update(measured);
        make_paths_relative(run["snapshots"], folder);
        run["references"] = nullptr;
        run["at_budget"] = Json::array();
    }
    return run;
}

}  // namespace bench
