// The engine as a surface integrator of the host.
#include "engine_integrator.h"

#include "memory_check.h"
#include "state_shim.h"

namespace aips::shim {

void EngineIntegrator::prepare(const lxs::RenderContext& context) {
    settings_.seed = context.settings.seed;  // chosen by the host, from the parameter too
    settings_.transport_statistics = context.settings.transport_statistics;
    shims_ = std::make_unique<Shims>(context);
    pixels_ = double(context.film.width()) * double(context.film.height());
    engine_ =
        std::make_unique<Engine>(Host{shims_->scene, shims_->camera, shims_->sampler, shims_->film,
                                      shims_->log, shims_->ranks ? &*shims_->ranks : nullptr},
                                 settings_);
    check_memory(engine_->statistics().memory_bound_bytes);
}

lxs::PassReport EngineIntegrator::render_pass(std::uint64_t pass) {
    const PassReport report = engine_->render_pass(pass);
    return {report.photon_paths, report.rays, double(report.eye_paths) / pixels_};
}

void EngineIntegrator::state(lxs::StateArchive& archive) {
    StateShim shim(archive);
    try {
        engine_->state(shim);
    } catch (const StateError& error) {
        throw lxs::StateError(error.what());
    }
}

void EngineIntegrator::learned(lxs::StateArchive& archive) {
    StateShim shim(archive);
    try {
        engine_->learned(shim);
    } catch (const StateError& error) {
        throw lxs::StateError(error.what());
    }
}

lxs::Statistics EngineIntegrator::statistics() const {
    const EngineStatistics s = engine_->statistics();
    lxs::Statistics out{{"eye_paths", s.eye_paths},
                        {"eye_rays", s.eye_rays},
                        {"photon_paths", s.photon_paths},
                        {"photon_rays", s.photon_rays},
                        {"photons_stored", s.photons},
                        {"photons_gathered", s.gathered},
                        {"bounces", s.bounces},
                        {"guided_bounces", s.guided_bounces},
                        {"guide_nodes", s.guide_nodes},
                        {"guide_bytes", s.guide_bytes},
                        {"eye_seconds", s.eye_seconds},
                        {"photon_seconds", s.photon_seconds},
                        {"gather_seconds", s.gather_seconds},
                        {"guide_seconds", s.guide_seconds},
                        {"plan_seconds", s.plan_seconds},
                        {"photons_per_pass", std::uint64_t{s.photons_per_pass}},
                        {"radius", double(s.radius)},
                        {"engine_bytes", std::uint64_t{s.memory_bytes}},
                        {"engine_bound_bytes", std::uint64_t{s.memory_bound_bytes}}};
    if (s.measured_paths > 0) {
        out.emplace_back("measured_paths", s.measured_paths);
        out.emplace_back("visible_paths", s.visible_paths);
        out.emplace_back("mutation_size", s.mutation_size);
    }
    if (s.emitter_searches > 0) {
        out.emplace_back("emitter_paths", s.emitter_paths);
        out.emplace_back("emitter_searches", s.emitter_searches);
        out.emplace_back("emitter_rays", s.emitter_rays);
        out.emplace_back("emitter_images", s.emitter_images);
    }
    if (s.continued_paths > 0) {
        out.emplace_back("continued_paths", s.continued_paths);
        out.emplace_back("eye_share", s.eye_share);
    }
    if (s.score_times_cost > 0) {
        out.emplace_back("emission_gain", s.emission_gain);
        out.emplace_back("survival_gain", s.survival_gain);
        out.emplace_back("photons_split_off", s.split_off);
        out.emplace_back("bounce_gain", s.bounce_gain);
        out.emplace_back("bounce_tables", s.bounce_tables);
        out.emplace_back("score_times_cost", s.score_times_cost);
        out.emplace_back("pruned_paths", s.pruned_paths);
        out.emplace_back("pruned_emission", s.pruned_emission);
    }
    return out;
}

lxs::InvalidSampleList EngineIntegrator::invalid_samples() const {
    lxs::InvalidSampleList list;
    if (!engine_) return list;
    for (const auto& [origin, count] : engine_->statistics().refused)
        list.push_back({origin, count});
    return list;
}

lxs::TransportStatistics EngineIntegrator::transport_statistics() const {
    lxs::TransportStatistics transport;
    if (!engine_) return transport;
    const EngineStatistics s = engine_->statistics();
    for (const LightStatistics& t : s.transport.lights)
        transport.lights.push_back({t.paths, t.counted, t.seen, t.photons});
    for (const MaterialStatistics& t : s.transport.materials) {
        transport.materials.push_back(
            {t.hits, t.stored, t.unseen, t.direct, t.specular, t.black, t.cut, t.cut_specular});
    }
    transport.eye_paths = s.transport.eye_paths;
    transport.cut_eye_paths = s.transport.cut_eye_paths;
    transport.radius = double(s.radius);
    const bool gloss_takes_photons = settings_.store_glossy || s.transport.caustics_on_gloss;
    transport.without_photons = gloss_takes_photons ? lxs::LobeMask{0} : lxs::kGlossy;
    transport.skipped = s.transport.skipped;
    transport.seconds = {{"eye paths", s.eye_seconds},
                         {"photon paths", s.photon_seconds},
                         {"gathering photons", s.gather_seconds},
                         {"guiding photons", s.guide_seconds},
                         {"planning", s.plan_seconds}};
    return transport;
}

}  // namespace aips::shim
