// What the log says of a scene, and the integrator's own preparations.
#include "lxs/host/begin_session.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lxs/host/counted.h"
#include "lxs/host/failure.h"

namespace lxs {
namespace {

/// How wavelengths are named among what is skipped; empty if they are not.
std::string skipped_wavelengths(const RenderSession& session) {
    const SpectralNeed& need = session.scene->spectral_need();
    if (session.scene->facts().disperses || need.misrepresented()) return {};
    if (!need.given) return "wavelengths (nothing disperses)";
    return fmt::format(
        "wavelengths (nothing disperses; RGB represents spectra to {:.1f} %, worst {})",
        100 * need.worst.difference, need.worst.pair);
}

/// "12 triangles and 3 round shapes", what there is of them.
std::string shapes_in(const SceneFacts& facts) {
    std::vector<std::string> kinds;
    if (facts.triangles > 0) kinds.push_back(counted(facts.triangles, "triangle", "triangles"));
    if (facts.quadrics > 0)
        kinds.push_back(counted(facts.quadrics, "round shape", "round shapes") +
                        " (spheres, disks, ...)");
    return kinds.empty() ? "no shapes" : fmt::format("{}", fmt::join(kinds, " and "));
}

}  // namespace

void log_scene(const RenderSession& session, ConsoleLog& log) {
    const SceneFacts facts = session.scene->facts();
    log.info(fmt::format("scene: {}, {}, {}; the image has {} x {} pixels", shapes_in(facts),
                         counted(session.scene->lights().size(), "light", "lights"),
                         counted(session.scene->material_names().size(), "material", "materials"),
                         session.film->width(), session.film->height()));
    std::vector<std::string_view> skipped;
    if (!facts.has_image_textures) skipped.emplace_back("image textures (no texture system)");
    if (!facts.has_media) skipped.emplace_back("media");
    if (!facts.has_motion) skipped.emplace_back("motion");
    const std::string wavelengths = skipped_wavelengths(session);
    if (!wavelengths.empty()) skipped.emplace_back(wavelengths);
    if (!skipped.empty()) {
        log.debug(fmt::format("skipped, as the scene has none: {}", fmt::join(skipped, ", ")));
    }
    log.debug(
        fmt::format("film before its first pass: {} MB", session.film->memory_bytes() / 1'000'000));
}

void prepare_integrator(RenderSession& session, const CommandLine& command, ConsoleLog& log) {
    const RenderContext context{*session.scene,
                                *session.camera,
                                *session.sampler,
                                session.no_film ? *session.no_film : *session.film,
                                log,
                                {command.threads, session.seed, command.advice},
                                session.job};
    try {
        session.integrator->prepare(context);
    } catch (const InputError&) {
        throw;
    } catch (const PluginFailure&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw SceneFailure(fmt::format("{}: \"{}\" can't render it: {}", command.scene,
                                       session.integrator_name, error.what()));
    }
}

}  // namespace lxs
