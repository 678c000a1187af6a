// Fuzz target: checkpoint files. The first byte chooses a render (integrator, sampler) and whether
// the file or its content is damaged; content gets a checksum that fits. What is not refused must
// go on with an image that is one.
#include <array>
#include <cmath>
#include <cstdlib>

#include "damaged_bytes.h"
#include "fuzz_target.h"
#include "input_files.h"
#include "input_plugins.h"
#include "lxs/host/checkpoint.h"
#include "lxs/host/checkpoint_file.h"
#include "lxs/host/failure.h"

namespace {

using Bytes = std::vector<std::byte>;

constexpr const char* kScene =
    "LookAt 0 -3 0  0 0 0  0 0 1 Camera \"perspective\" \"float fov\" [60]\n"
    "WorldBegin\n"
    "AttributeBegin AreaLightSource \"area\" \"color L\" [1 1 1]\n"
    "Shape \"sphere\" \"float radius\" [0.2] AttributeEnd\n"
    "Material \"matte\" \"color Kd\" [0.5 0.5 0.5]\n"
    "Shape \"disk\" \"float radius\" [2] \"float height\" [-0.5]\n"
    "WorldEnd\n";

struct Kind {
    const char* integrator;
    const char* sampler;
    std::vector<std::string> settings;
    bool denoise = false;
};

const std::array<Kind, 10>& kinds() {
    static const std::array<Kind, 10> all = {{
        {"path", "lowdiscrepancy", {"path.maxdepth=4"}},
        {"path", "metropolis", {"path.maxdepth=4"}},
        {"aips", "lowdiscrepancy", {"aips.photonperpass=64", "aips.guide=adaptive"}},
        {"aips", "lowdiscrepancy", {"aips.photonperpass=64", "aips.guide=paper"}},
        {"aips", "lowdiscrepancy", {"aips.photonperpass=64", "aips.radius=adaptive"}},
        {"sppm", "lowdiscrepancy", {"sppm.photonperpass=64", "sppm.photonsampler=amc"}},
        {"ppm", "lowdiscrepancy", {"ppm.photonperpass=64"}},
        {"exphotonmap", "lowdiscrepancy", {"exphotonmap.photonperpass=64"}},
        {"path", "lowdiscrepancy", {"path.maxdepth=4"}, true},
        {"aips", "lowdiscrepancy", {"aips.photonperpass=64"}, true},
    }};
    return all;
}

/// A session on 4 x 3 pixels, ready for its first pass.
struct Render {
    explicit Render(const Kind& kind) {
        command.scene = fuzz::folder() / "small.lxs";
        command.output = fuzz::folder() / "out.exr";
        command.integrator = kind.integrator;
        command.sampler = kind.sampler;
        command.overrides = kind.settings;
        command.width = 4;
        command.height = 3;
        command.verbosity = lxs::Verbosity::Quiet;
        lxs::InputDiagnostics diagnostics(log, false);
        session = lxs::prepare_session(command, fuzz::plugins(), diagnostics, log);
        session.film->keep_for_denoising(kind.denoise);
        session.integrator->prepare({*session.scene,
                                     *session.camera,
                                     *session.sampler,
                                     *session.film,
                                     log,
                                     {1, session.seed}});
        session.fingerprint = {};  // as seal() writes it
        command.checkpoint = fuzz::folder() / "check";
        command.checkpoint_interval = 0;
        command.resume = true;
    }

    void pass(std::uint64_t number) {
        session.integrator->render_pass(number);
        session.film->end_pass();
    }

    lxs::ConsoleLog log{lxs::Verbosity::Quiet};
    lxs::CommandLine command;
    lxs::RenderSession session;
};

Bytes checkpoint_of(const Kind& kind) {
    Render render(kind);
    lxs::RenderTotals totals;
    lxs::CheckpointSchedule schedule(render.command, render.session, render.log, totals);
    while (totals.passes < 4)
        render.pass(totals.passes++);
    schedule.finish(totals);
    return lxs::read_checkpoint_file(*render.command.checkpoint);
}

const std::vector<Bytes>& checkpoints() {
    static const auto all = [] {
        fuzz::folder().write("small.lxs", kScene);
        std::vector<Bytes> made;
        for (const Kind& kind : kinds())
            made.push_back(checkpoint_of(kind));
        return made;
    }();
    return all;
}

void write_file(std::span<const std::byte> bytes) {
    fuzz::folder().write("check",
                         std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

/// `content` under the right fingerprint and checksum.
void seal(Bytes content) {
    lxs::CheckpointWriter writer(fuzz::folder() / "check");
    lxs::Fingerprint fingerprint;
    fingerprint.state(writer);
    writer.bytes(content);
    writer.commit();
}

/// What the file holds after the fingerprint.
std::span<const std::byte> content_of(const Bytes& file) {
    const auto content = lxs::checkpoint_content(file);
    lxs::CheckpointReader reader(content);
    lxs::Fingerprint fingerprint;
    fingerprint.state(reader);
    return content.last(reader.remaining());
}

void resume(const Kind& kind) {
    Render render(kind);
    auto found = lxs::find_checkpoint(render.command, render.session, render.log);
    if (!found) std::abort();
    const lxs::RenderTotals totals =
        lxs::restore(std::move(*found), render.command, render.session, render.log);
    render.pass(totals.passes);
    const lxs::FileFilm& film = *render.session.film;
    for (const auto& image : {film.image(), film.denoised()}) {
        for (const lxs::Rgb& pixel : image) {
            for (const float value : {pixel.x, pixel.y, pixel.z}) {
                if (!std::isfinite(value) || value < 0) std::abort();
            }
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::InputBytes input(data, size);
    const std::size_t choice = input.below(2 * kinds().size());
    const std::size_t kind = choice / 2;
    const Bytes& file = checkpoints()[kind];
    const bool whole = input.empty();
    if (choice % 2 == 0) {
        seal(damaged_bytes(content_of(file), input));
    } else {
        write_file(damaged_bytes(file, input));
    }
    try {
        resume(kinds()[kind]);
    } catch (const lxs::CheckpointFailure& refusal) {
        if (whole) std::abort();
        fuzz::check_refusal(refusal);
    }
    return 0;
}
