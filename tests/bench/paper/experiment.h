// The paper's experiments as data: paper.json, with what is varied spelled out, at a scale.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace bench {

/// Which table an experiment gives.
enum class ExperimentKind : std::uint8_t {
    Passes,        ///< errors after equally many passes and at equal time, memory
    Convergence,   ///< the same, and errors over the passes
    Time,          ///< errors at equal time
    Distribution,  ///< where photons land, over the passes
};

/// One way to render in an experiment: a method with overrides of its own.
struct PaperCase {
    std::string name;              ///< in names of files
    std::string label;             ///< in tables
    std::string method;            ///< of tests/bench/methods.json
    std::vector<std::string> set;  ///< plugin.parameter=value
    std::string against;           ///< name of the case that ratios refer to
};

struct PaperScene {
    std::string name;
    double seconds = 0;  ///< CPU time of a run; 0: by passes
};

struct Experiment {
    std::string figure, title;
    ExperimentKind kind = ExperimentKind::Passes;
    std::string study;  ///< folder; experiments of one study share runs
    std::vector<PaperScene> scenes;
    std::uint32_t width_px = 0, height_px = 0;
    std::string part = "image";  ///< whose errors are compared: the image's or the photons' alone
    std::uint64_t passes = 0;    ///< 0: by time
    std::vector<PaperCase> cases;
};

struct PaperTable {
    unsigned photons_per_pass = 0;  ///< of all photon methods
    std::vector<Experiment> experiments;
};

/// A case that is varied becomes one for each value; the one at the paper's own value keeps its
/// name, so that it is one and the same run wherever it appears. Throws StudyError.
PaperTable read_paper_table(const std::filesystem::path& file);

/// Those whose figure is among `figures` ("9" means all that begin so), all if it is empty. Throws
/// StudyError for a figure that there isn't.
std::vector<Experiment> choose_experiments(const PaperTable& table,
                                           const std::vector<std::string>& figures);

/// Width, height, passes and seconds times `scale` (0 < scale <= 1), at least 8 pixels and 2
/// passes. Photons per pass stay: the guide learns from them.
Experiment scaled(Experiment experiment, double scale);

}  // namespace bench
