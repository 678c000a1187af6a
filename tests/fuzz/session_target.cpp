// Fuzz target: a whole scene made ready to render as lxsrender does it (reader, film, camera,
// lights, Embree, integrator), then a few of its pixels.
#include <cstdlib>
#include <fstream>

#include "fuzz_target.h"
#include "input_files.h"
#include "input_plugins.h"
#include "lxs/host/failure.h"
#include "lxs/host/render_session.h"

namespace {

/// A path tracer of little depth on 4 x 4 pixels, whatever the scene asks for: what is tried here
/// is the scene.
lxs::CommandLine command_line() {
    lxs::CommandLine command;
    command.scene = fuzz::folder() / "scene.lxs";
    command.output = fuzz::folder() / "out.exr";
    command.integrator = "path";
    command.overrides = {"path.maxdepth=4"};
    command.sampler = "lowdiscrepancy";
    command.width = 4;
    command.height = 4;
    command.verbosity = lxs::Verbosity::Quiet;
    return command;
}

void render(const lxs::CommandLine& command, lxs::ConsoleLog& log) {
    lxs::InputDiagnostics diagnostics(log, false);
    lxs::RenderSession session = lxs::prepare_session(command, fuzz::plugins(), diagnostics, log);
    session.integrator->prepare(
        {*session.scene, *session.camera, *session.sampler, *session.film, log, {1, session.seed}});
    session.integrator->render_pass(0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const lxs::CommandLine command = command_line();
    static lxs::ConsoleLog log(lxs::Verbosity::Quiet);
    const std::string text(reinterpret_cast<const char*>(data), data ? size : 0);
    // Subdivision may make ten million triangles of one; the target `mesh` bounds and tries it.
    if (text.find("levels") != std::string::npos || text.find("subdiv") != std::string::npos)
        return 0;
    fuzz::folder().write("scene.lxs", text);
    try {
        render(command, log);
    } catch (const lxs::RefusedInput&) {  // its messages went to the log
    } catch (const lxs::SceneFailure& refusal) {
        fuzz::check_refusal(refusal);
    } catch (const lxs::OutputFailure& refusal) {
        fuzz::check_refusal(refusal);
    }
    return 0;
}
