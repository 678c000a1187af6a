// The pass loop.
#include "render/pass_loop.h"

#include <stdexcept>

#include "base/side_by_side.h"
#include "base/stopwatch.h"
#include "plan/memory_bound.h"
#include "render/lights_ahead.h"
#include "render/precision_warning.h"
#include "render/same_render.h"

namespace aips {
namespace {

/// What the one strategy that has some shares with eye paths, or null.
template <class Shared>
const Shared* shared_by(const LightStrategies& strategies,
                        const Shared* (LightStrategy::*part)() const) {
    for (const auto& strategy : strategies) {
        if (const Shared* shared = (*strategy.*part)()) return shared;
    }
    return nullptr;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "nothing" : text;
}

/// Those that share the work of each pass; null: each process does all of it, for its own log.
Ranks* sharing_ranks(const Host& host, const Settings& settings) {
    if (!host.ranks || host.ranks->count() == 1) return nullptr;
    const char* reason = nullptr;
    // Marks of media are addresses. The others sum over visible points that they have to ask.
    if (host.scene.media()) reason = "media scatter light";
    if (settings.debug_layers) reason = "debug layers are asked for";
    if (settings.transport_statistics) reason = "transport statistics are asked for";
    if (!reason) return host.ranks;
    host.log.warning(std::string("each process traces all of each pass, as ") + reason);
    return nullptr;
}

void log_learned(const LearnedParts& parts, Log& log) {
    log.info("learned before: " + joined(parts.taken()));
    if (!parts.left_out().empty())
        log.info("skipped of what was learned before, as it does not fit: " +
                 joined(parts.left_out()));
}

}  // namespace

PassLoop::PassLoop(const Host& host, const Settings& settings, std::uint32_t eye_paths,
                   bool needs_points, LightStrategies strategies)
    : host_(host),
      settings_(settings),
      eye_paths_(eye_paths),
      direct_light_(host.scene, settings.learn_lights),
      filter_(host.scene),
      eye_(make_eye_source({host_.scene, host_.camera, host_.sampler, direct_light_, settings_,
                            host.film.width(), host.film.height(), eye_paths, needs_points,
                            shared_by(strategies, &LightStrategy::eye_shares),
                            shared_by(strategies, &LightStrategy::emitter_images),
                            host.film.layers_wanted(), sharing_ranks(host, settings),
                            shared_by(strategies, &LightStrategy::disc_gaps)})),
      strategies_(std::move(strategies)) {
    statistics_.memory_bound_bytes = eye_memory_bound(host.scene, settings, eye_paths);
    // Parts of eye paths, and of as many splats, of which there may be more while vectors grow.
    const LayersWanted& layers = eye_->input().layers;
    if (layers.surfaces) statistics_.memory_bound_bytes += eye_paths * sizeof(SeenSurface);
    if (layers.parts)
        statistics_.memory_bound_bytes += std::size_t{3} * eye_paths * kImageParts * sizeof(Rgb);
    for (const auto& strategy : strategies_)
        statistics_.memory_bound_bytes += strategy->memory_bound_bytes();
    if (settings.debug_layers && direct_light_.learned()) {
        light_layers_.emplace(host.film);
        statistics_.memory_bound_bytes +=
            LightLayers::memory_bound_bytes(std::size_t{host.film.width()} * host.film.height());
    }
    refuse_powers();
}

PassReport PassLoop::render_pass(std::uint64_t number) {
    PassReport report;
    std::uint64_t eye_rays = number == 0 ? look_ahead() : 0;
    eye_rays += begin_pass(number);
    report.eye_paths = trace_eye_paths(number);
    if (number == 0) warn_of_lost_precision(image_, host_.log);
    if (report.eye_paths) {
        eye_rays += image_.rays;
        count_transport();
    }
    report.rays = eye_rays;
    const StrategyPass pass{number,           eye_->time(number), image_,
                            report.eye_paths, eye_rays,           filter_};
    FilmPass film_pass{
        .positions = image_.positions, .groups = image_.groups, .eye = image_.radiance};
    FilmPass parts{.positions = image_.positions, .groups = kImageParts, .eye = image_.parts};
    for (const auto& strategy : strategies_) {
        const CarriedLight light = strategy->carry(pass, report);
        add_light(light, film_pass);
        if (!light.parts.empty()) parts.photons = light.parts;
    }
    host_.film.add_pass(film_pass);
    if (!image_.parts.empty()) add_parts(film_pass, parts);
    if (!image_.surfaces.empty()) host_.film.add_surfaces(image_.positions, image_.surfaces);
    learn(pass, film_pass);
    if (light_layers_) light_layers_->show(image_, direct_light_);
    count(report, eye_rays);
    return report;
}

/// Strategies and the choice of lights know nothing of each other.
void PassLoop::learn(const StrategyPass& pass, const FilmPass& film_pass) {
    const auto end_pass = [&] {
        for (const auto& strategy : strategies_)
            strategy->end_pass(pass, film_pass);
    };
    if (!pass.eye_paths) return end_pass();
    side_by_side(end_pass, [&] {
        direct_light_.learn(image_.light_samples, light_samples_due(pass.eye_paths),
                            pass.number + 1);
    });
}

std::uint64_t PassLoop::look_ahead() {
    const Stopwatch watch(statistics_.eye_seconds);
    return learn_lights_ahead(eye_->input(), eye_->time(0), direct_light_);
}

std::uint64_t PassLoop::begin_pass(std::uint64_t pass) {
    const Stopwatch watch(statistics_.eye_seconds);
    std::uint64_t rays = 0;
    for (const auto& strategy : strategies_)
        rays += strategy->begin_pass({pass, eye_->time(pass), eye_->input(), filter_});
    return rays;
}

std::uint32_t PassLoop::trace_eye_paths(std::uint64_t pass) {
    const Stopwatch watch(statistics_.eye_seconds);
    return eye_->look(pass, filter_, image_);
}

void PassLoop::add_light(const CarriedLight& light, FilmPass& film_pass) {
    if (light.splats) film_pass.splats = light.splats;
    if (light.radiance.empty()) return;
    if (light.mean == PassMean::Weighted) {
        if (!film_pass.photons.empty())
            throw std::logic_error("two strategies weigh their passes; the film has one such mean");
        film_pass.photons = light.radiance;
        film_pass.photon_weight = light.weight;
        return;
    }
    if (film_pass.eye.data() != eye_radiance_.data()) {
        eye_radiance_.assign(film_pass.eye.begin(), film_pass.eye.end());
        film_pass.eye = eye_radiance_;
    }
    for (std::size_t i = 0; i < light.radiance.size(); ++i)
        eye_radiance_[i] += light.radiance[i];
}

/// Of eye paths that were traced for this pass.
void PassLoop::count_transport() {
    seen_light_.add(image_.light);
    statistics_.transport.cut_eye_paths += image_.cut_paths;
}

/// Emitters that splats show are met by specular surfaces alone.
void PassLoop::add_parts(const FilmPass& film_pass, FilmPass& parts) {
    parts.photon_weight = film_pass.photon_weight;
    if (film_pass.splats) {
        const auto& [positions, radiance] = *film_pass.splats;
        splat_parts_.assign(positions.size() * kImageParts, Rgb{});
        for (std::size_t i = 0; i < radiance.size(); ++i)
            splat_parts_[i / image_.groups * kImageParts + std::size_t(ImagePart::Direct)] +=
                radiance[i];
        parts.splats = {positions, splat_parts_};
    }
    host_.film.add_parts(parts);
}

void PassLoop::count(const PassReport& report, std::uint64_t eye_rays) {
    ++statistics_.passes;
    statistics_.eye_paths += report.eye_paths;
    statistics_.eye_rays += eye_rays;
    // Some passes may be without photons.
    if (report.radius > 0) statistics_.radius = report.radius;
}

/// Lights that nothing is ever asked of, as what they say of their power is none.
void PassLoop::refuse_powers() {
    const auto lights = host_.scene.lights();
    for (LightIndex i = 0; i < lights.size(); ++i)
        filter_.accept_density(lights[i]->power(), filter_.of_light(i));
}

EngineStatistics PassLoop::statistics() const {
    EngineStatistics s = statistics_;
    for (const auto& strategy : strategies_)
        strategy->add_to(s);
    s.transport.eye_paths = s.eye_paths;
    const auto& seen = seen_light_.sums();
    for (std::size_t i = 0; i < seen.size(); ++i)
        sum_at(s.transport.lights, i).seen += seen[i] / double(s.eye_paths);
    s.memory_bytes = memory_bytes();
    s.refused = filter_.by_origin();
    return s;
}

std::size_t PassLoop::memory_bytes() const {
    std::size_t bytes =
        image_.memory_bytes() + (eye_radiance_.capacity() + splat_parts_.capacity()) * sizeof(Rgb) +
        direct_light_.memory_bytes() + (light_layers_ ? light_layers_->memory_bytes() : 0);
    for (const auto& strategy : strategies_)
        bytes += strategy->memory_bytes();
    return bytes;
}

void PassLoop::state(StateArchive& archive) {
    state_of_identity(archive, host_, settings_, eye_paths_);
    for (std::uint64_t* count :
         {&statistics_.passes, &statistics_.eye_paths, &statistics_.eye_rays})
        archive.value(*count);
    archive.amount(statistics_.radius);
    seen_light_.state(archive);
    archive.value(statistics_.transport.cut_eye_paths);
    filter_.state(archive);
    direct_light_.state(archive);
    if (archive.restoring()) eye_->restore(statistics_.passes, image_);
    for (const auto& strategy : strategies_)
        strategy->state(archive, image_);
    for (const auto& strategy : strategies_)
        strategy->state_of_seconds(archive);
    archive.amount(statistics_.eye_seconds);
}

void PassLoop::learned(StateArchive& archive) {
    if (archive.restoring() && statistics_.passes > 0)
        throw std::logic_error("what was learned elsewhere is taken before the first pass");
    state_of_version(archive);
    LearnedParts parts(archive);
    direct_light_.learned(parts);
    for (const auto& strategy : strategies_)
        strategy->learned(parts);
    parts.end();
    if (archive.restoring()) log_learned(parts, host_.log);
}

}  // namespace aips
