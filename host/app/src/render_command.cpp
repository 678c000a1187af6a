// Carries out a command line.
#include "lxs/host/render_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <new>
#include <system_error>

#include "lxs/host/begin_session.h"
#include "lxs/host/catalogue.h"
#include "lxs/host/checkpoint.h"
#include "lxs/host/failure.h"
#include "lxs/host/final_outputs.h"
#include "lxs/host/learned_file.h"
#include "lxs/host/live_view.h"
#include "lxs/host/render_loop.h"
#include "lxs/host/render_session.h"
#include "lxs/host/scene_language_page.h"
#include "lxs/host/seconds_since.h"
#include "lxs/host/snapshots.h"
#include "lxs/host/thread_count.h"
#include "lxs/images/image_library.h"
#include "shared_render.h"

namespace lxs {
namespace {

/// Prepares the integrator and brings it to where the render begins; returns what was done before.
RenderTotals begin(const CommandLine& command, RenderSession& session,
                   const std::optional<LearnedFile>& known, std::optional<FoundCheckpoint> found,
                   ConsoleLog& log) {
    prepare_integrator(session, command, log);
    check_learns(command, session);
    if (known && !found) take_learned(*known, command, session, log);
    RenderTotals begun;
    if (found) begun = restore(std::move(*found), command, session, log);
    if (session.job) agree_on_begin(session, begun.passes);
    return begun;
}

ExitCode finish(const CommandLine& command, RenderSession& session, const RenderTotals& totals,
                bool interrupted, ConsoleLog& log) {
    if (totals.passes == 0) {
        log.warning("interrupted before the first pass: there is no image to write");
        return ExitCode::Interrupted;
    }
    const ExitCode written = write_final_outputs(command, session, totals, interrupted, log);
    // After the images, which nothing that is wrong with it can cost.
    return write_learned(command, session, log) ? written : ExitCode::OutputFailure;
}

/// Prints what was asked for on standard output.
void print(const std::string& text) {
    if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return;
    throw OutputFailure(
        fmt::format("cannot write standard output: {}", std::generic_category().message(errno)));
}

ExitCode render(const CommandLine& command, const PluginLibrary& plugins, ConsoleLog& log,
                RankJob* job) {
    if (!command.helps) {
        check_checkpoint_place(command, log);
        check_learned_place(command, log);
    }
    const auto known = read_learned(command);
    InputDiagnostics diagnostics(log, command.strict);
    RenderSession session = prepare_session(command, plugins, diagnostics, log);
    log_scene(session, log);
    if (job) join_job(session, command, *job, log);
    const Budget budget = choose_budget(command, *session.film, log);
    log.info(fmt::format("rendering {} with \"{}\"; Ctrl-C ends it early and keeps the picture",
                         budget.text(), session.integrator_name));
    log.debug(fmt::format("seed {}", session.seed));

    if (known) session.fingerprint.set_learned(*known);
    session.film->estimate_errors(command.error_estimate);
    session.film->keep_for_denoising(command.denoise != Denoising::None);
    auto found = find_checkpoint(command, session, log);

    Interruption interruption;  // a rank that helps leaves it to the first to heed one
    if (command.helps)
        return help_render(session, begin(command, session, known, std::move(found), log).passes);
    const auto start = std::chrono::steady_clock::now();
    LiveView live(command, session, budget, log);
    const RenderTotals begun = begin(command, session, known, std::move(found), log);
    CheckpointSchedule checkpoints(command, session, log, begun);
    Snapshots snapshots(command, session, budget, log);
    ErrorWatch error(*session.film, budget.error);
    Progress progress(log, budget, error, command.verbosity == Verbosity::Verbose);
    RenderLoop loop{.session = session,
                    .budget = budget,
                    .interruption = interruption,
                    .progress = progress,
                    .error = error,
                    .end_pass =
                        [&](const RenderTotals& done) {
                            checkpoints.pass_done(done);
                            live.pass_done(done, error, interruption);
                        },
                    .between_passes =
                        [&](const RenderTotals& done) {
                            snapshots.between_passes(done);
                            live.wait_while_paused(done, error, interruption);
                        }};
    if (job) loop.begin_pass = [&] { job->another_pass(true); };
    RenderTotals totals = begun;
    try {
        loop.run(totals);
        if (job) job->another_pass(false);
    } catch (...) {
        save_finished_passes(command, session, totals, log);
        throw;
    }
    checkpoints.finish(totals);
    snapshots.finish(totals);
    live.passes_over(totals, error);
    session.times["render"] = begun.seconds + seconds_since(start) - live.paused_seconds() -
                              session.times["write"] - session.times["checkpoint"];
    const ExitCode code = finish(command, session, totals, interruption.requested(), log);
    live.ended(totals, code == ExitCode::Success || code == ExitCode::Interrupted);
    return code;
}

ExitCode describe(const CommandLine& command, const PluginLibrary& plugins, ConsoleLog& log) {
    const std::string text = describe_plugin(*command.describe, plugins, command.markdown);
    if (text.empty()) {
        const std::string nearest = nearest_name(*command.describe, describable_names(plugins));
        log.error(fmt::format(
            "unknown plugin {}; {}", in_quotes(*command.describe),
            nearest.empty()
                ? fmt::format("--describe knows the names that {} have here, and lists them: as "
                              "in --describe Material",
                              fmt::join(described_kinds(plugins), ", "))
                : fmt::format("did you mean \"{}\"?", nearest)));
        return ExitCode::Usage;
    }
    print(text);
    return ExitCode::Success;
}

ExitCode run(const CommandLine& command, PluginLibrary& plugins, ConsoleLog& log, RankJob* job) {
    load_plugins(command.plugin_paths, plugins);
    if (command.list_plugins) {
        print(list_plugins(plugins));
        return ExitCode::Success;
    }
    if (command.scene_language) {
        print(scene_language_page());
        return ExitCode::Success;
    }
    if (command.describe) return describe(command, plugins, log);
    try {
        return on_threads(command.threads, [&] { return render(command, plugins, log, job); });
    } catch (...) {
        // Whatever it has become on its way through the integrator.
        if (job && job->failure()) throw *job->failure();
        throw;
    }
}

}  // namespace

ExitCode carry_out(const CommandLine& command, ConsoleLog& log, RankJob* job) {
    // Outlives the handlers below: an exception that a module threw may need the module's code.
    PluginLibrary plugins;
    try {
        return run(command, plugins, log, job);
    } catch (const RefusedInput&) {
        return ExitCode::BadInput;
    } catch (const InputError& error) {
        log.verbatim(error.what(), true);
        return ExitCode::BadInput;
    } catch (const SceneFailure& error) {
        log.error(error.what());
        return ExitCode::BadInput;
    } catch (const LearnedFailure& error) {
        log.error(error.what());
        return ExitCode::BadInput;
    } catch (const PluginFailure& error) {
        log.error(error.what());
        return ExitCode::PluginFailure;
    } catch (const ImageLibraryFailure& error) {
        log.error(error.what());
        return ExitCode::PluginFailure;
    } catch (const OutputFailure& error) {
        log.error(error.what());
        return ExitCode::OutputFailure;
    } catch (const CheckpointFailure& error) {
        log.error(error.what());
        return ExitCode::CheckpointRefused;
    } catch (const RankFailure& error) {
        log.error(error.what());
        return error.code();
    } catch (const std::bad_alloc&) {
        log.error("out of memory");
    } catch (const std::exception& error) {
        log.error(fmt::format("internal error: {}", error.what()));
    } catch (...) {
        log.error("internal error: an exception of unknown type");
    }
    return ExitCode::InternalError;
}

}  // namespace lxs
