// The command line of lxsrender.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lxs/host/exit_code.h"

namespace lxs {

enum class Verbosity : std::uint8_t { Quiet, Normal, Verbose };

/// What the processes of --mpi share.
enum class MpiSplit : std::uint8_t {
    Photons,  ///< the rays of each pass: the image has the bits of one process
    Passes    ///< passes: each renders some with a seed of its own, and the images are merged
};

/// Which images are denoised.
enum class Denoising : std::uint8_t {
    None,
    All,
    Last  ///< that at the end; those before it are written as they are, at no such cost
};

struct CommandLine {
    std::string scene;                    ///< file, "-" for standard input
    std::optional<std::string> output;    ///< EXR file, the PNG beside it; or PNG file alone
    double exposure_stops = 0;            ///< the PNG is brighter by 2 to this power
    unsigned threads = 0;                 ///< 0: all processors
    std::optional<std::uint64_t> passes;  ///< budget; at most one of passes and seconds is given
    std::optional<double> seconds;
    std::optional<double> target_error;   ///< budget: square root of relMSE
    bool error_estimate = true;           ///< the film estimates its error
    Denoising denoise = Denoising::None;  ///< of the PNG; the EXR has a layer of it
    std::optional<std::uint64_t> seed;
    std::vector<std::string> overrides;     ///< plugin.parameter=value, of integrator or sampler
    std::optional<std::string> integrator;  ///< instead of the scene's
    std::optional<std::uint32_t> width;   ///< pixels, instead of the scene's; height in proportion
    std::optional<std::uint32_t> height;  ///< pixels, instead of the scene's and of that proportion
    std::optional<std::string> sampler;   ///< instead of the scene's
    std::optional<std::string> layers;    ///< names, instead of the scene's
    bool strict = false;                  ///< what LuxRender only warns of is an error
    std::vector<std::string> plugin_paths;
    std::optional<double> write_every;          ///< seconds from image to image; 0: the last alone
    std::optional<std::string> display_server;  ///< of tev, HOST or HOST:PORT
    std::optional<std::uint16_t> serve;         ///< port of the page to watch it; 0: any
    std::optional<std::string> statistics;      ///< JSON file
    bool advice = true;                     ///< what looks wrong with the render is said at its end
    bool explain = false;                   ///< so is what became of light and photons
    std::optional<std::string> checkpoint;  ///< file to save the render's state in; none: not saved
    double checkpoint_interval = 300;       ///< least seconds between two of them; 0: every pass
    bool resume = false;                    ///< from `checkpoint`, if there is that file
    std::optional<std::string> learned_out;  ///< file for what the render learns
    std::optional<std::string> learned_in;   ///< of another render, to begin with
    std::optional<std::uint32_t> frame;      ///< number of it; given: the seed differs by it
    bool mpi = false;                        ///< with the other processes of an MPI job
    MpiSplit mpi_split = MpiSplit::Photons;
    std::uint32_t seeds_above = 0;  ///< added to the seed
    bool helps = false;             ///< as one of those after the first: it writes nothing
    bool writes = true;             ///< files; not where a program takes the image from memory
    std::optional<std::string> merged_output;  ///< that its image is merged into at the end
    Verbosity verbosity = Verbosity::Normal;

    bool list_plugins = false;
    std::optional<std::string> describe;  ///< name of a plugin
    bool markdown = false;
    bool scene_language = false;
};

/// Fills `command`. Returns an exit code if there is nothing left to do: after --help and --version
/// (printed on standard output), and after a mistake (printed on standard error).
std::optional<ExitCode> parse_command_line(int argc, const char* const* argv, CommandLine& command);

/// Version of the project, e.g. "1.0.0".
std::string version();

}  // namespace lxs
