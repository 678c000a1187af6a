// Fuzz target: files of what was learned. The first byte chooses a render and whether the file or
// its content is damaged; content gets a checksum that fits. What is not refused must steer a pass
// whose image is one.
#include <array>
#include <cmath>
#include <cstdlib>

#include "damaged_bytes.h"
#include "fuzz_target.h"
#include "input_files.h"
#include "input_plugins.h"
#include "lxs/host/checkpoint_file.h"
#include "lxs/host/failure.h"
#include "lxs/host/learned_file.h"

namespace {

using Bytes = std::vector<std::byte>;

constexpr const char* kScene =
    "LookAt 0 -3 0  0 0 0  0 0 1 Camera \"perspective\" \"float fov\" [60]\n"
    "WorldBegin\n"
    "LightSource \"point\" \"point from\" [1 -1 1] \"color L\" [3 3 3]\n"
    "AttributeBegin AreaLightSource \"area\" \"color L\" [1 1 1]\n"
    "Shape \"sphere\" \"float radius\" [0.2] AttributeEnd\n"
    "Material \"matte\" \"color Kd\" [0.5 0.5 0.5]\n"
    "Shape \"disk\" \"float radius\" [2] \"float height\" [-0.5]\n"
    "WorldEnd\n";

struct Kind {
    const char* integrator;
    std::vector<std::string> settings;
};

const std::array<Kind, 5>& kinds() {
    static const std::array<Kind, 5> all = {{
        {"path", {"path.maxdepth=4"}},
        {"aips", {"aips.photonperpass=64", "aips.guidescout=false"}},
        {"aips", {"aips.photonperpass=64", "aips.directlightsampling=false"}},
        {"aips", {"aips.photonperpass=64", "aips.guide=none"}},
        {"sppm", {"sppm.photonperpass=64"}},
    }};
    return all;
}

/// A session on 4 x 3 pixels, ready for its first pass.
struct Render {
    Render(const Kind& kind, std::uint64_t seed) {
        command.seed = seed;
        command.scene = fuzz::folder() / "small.lxs";
        command.output = fuzz::folder() / "out.exr";
        command.integrator = kind.integrator;
        command.overrides = kind.settings;
        command.width = 4;
        command.height = 3;
        command.verbosity = lxs::Verbosity::Quiet;
        lxs::InputDiagnostics diagnostics(log, false);
        session = lxs::prepare_session(command, fuzz::plugins(), diagnostics, log);
        session.integrator->prepare({*session.scene,
                                     *session.camera,
                                     *session.sampler,
                                     *session.film,
                                     log,
                                     {1, session.seed}});
        command.learned_in = command.learned_out = fuzz::folder() / "learned";
    }

    lxs::ConsoleLog log{lxs::Verbosity::Quiet};
    lxs::CommandLine command;
    lxs::RenderSession session;
};

std::string learned_path() {
    return fuzz::folder() / "learned";
}

Bytes learned_of(const Kind& kind) {
    Render render(kind, 1);
    for (std::uint64_t pass = 0; pass < 3; ++pass)
        render.session.integrator->render_pass(pass);
    if (!lxs::write_learned(render.command, render.session, render.log)) std::abort();
    return lxs::read_checkpoint_file(learned_path(), lxs::kLearnedFormat);
}

const std::vector<Bytes>& learned_files() {
    static const auto all = [] {
        fuzz::folder().write("small.lxs", kScene);
        std::vector<Bytes> files;
        for (const Kind& kind : kinds())
            files.push_back(learned_of(kind));
        return files;
    }();
    return all;
}

void write_file(const Bytes& bytes) {
    fuzz::folder().write("learned", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// Writes the content as a whole file.
void seal(Bytes content) {
    lxs::CheckpointWriter writer(learned_path(), lxs::kLearnedFormat);
    writer.bytes(content);
    writer.commit();
}

void begin_with_it(const Kind& kind) {
    Render render(kind, 2);
    const auto file = lxs::read_learned(render.command);
    if (!file) std::abort();
    lxs::take_learned(*file, render.command, render.session, render.log);
    for (std::uint64_t pass = 0; pass < 2; ++pass)
        render.session.integrator->render_pass(pass);
    for (const lxs::Rgb& pixel : render.session.film->image()) {
        for (const float value : {pixel.x, pixel.y, pixel.z}) {
            if (!std::isfinite(value) || value < 0) std::abort();
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::InputBytes input(data, size);
    const std::size_t choice = input.below(2 * kinds().size());
    const Kind& kind = kinds()[choice / 2];
    const Bytes& file = learned_files()[choice / 2];
    const bool whole = input.empty();
    if (choice % 2 == 0) {
        const auto content = lxs::checkpoint_content(file, lxs::kLearnedFormat);
        seal(damaged_bytes(content, input));
    } else {
        write_file(damaged_bytes(file, input));
    }
    try {
        begin_with_it(kind);
    } catch (const lxs::LearnedFailure& refusal) {
        if (whole) std::abort();
        fuzz::check_refusal(refusal);
    }
    return 0;
}
