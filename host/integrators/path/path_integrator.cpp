// The integrator `path`: one sample a pixel and pass, rows in parallel, or Markov chains.
#include "path/path_integrator.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

#include "path/lights_ahead.h"

namespace lxs {

void PathIntegrator::prepare(const RenderContext& context) {
    context_.emplace(context);
    filter_.emplace(context.scene);
    // A chain's target must stay what it is while the chain walks.
    if (context.sampler.metropolis() && settings_.lights == LightStrategy::Learned) {
        settings_.lights = LightStrategy::Power;
        context.log.debug("path: lights are chosen by power, as Markov chains learn no lights");
    }
    for (const Light* light : context.scene.lights())
        filter_->accept_of_light(valid_density(light->power()), *light);
    tracer_.emplace(context.scene, settings_, *filter_);
    context.log.debug("path: " + settings_.text());
    if (const MetropolisSettings* metropolis = context.sampler.metropolis()) {
        metropolis_.emplace(context, *tracer_, *metropolis);
        const LayersWanted wanted = context.film.layers_wanted();
        if (wanted.alpha) resize_pixels();
        if (wanted != LayersWanted{.alpha = wanted.alpha})
            context.log.warning(
                "path: layers for compositing stay empty, as Markov chains don't look at all "
                "pixels alike");
        context.log.debug("path: " + metropolis_->text());
        return;
    }
    resize_pixels();
}

void PathIntegrator::resize_pixels() {
    const RenderContext& context = *context_;
    const std::size_t pixels = std::size_t{context.film.width()} * context.film.height();
    positions_.resize(pixels);
    radiance_.resize(pixels * context.film.light_groups());
    parts_.resize(context.film.layers_wanted().parts() ? pixels * kImageParts : 0);
    seen_.resize(context.film.layers_wanted().surfaces() ? pixels : 0);
    told_.resize(context.film.height());
}

PassReport PathIntegrator::render_pass(std::uint64_t pass) {
    PathCounts counts;
    if (metropolis_) {
        counts = metropolis_->render_pass();
        // Chains don't look at all pixels alike: what covers them is looked at beside.
        if (!seen_.empty()) {
            counts += trace_pixels(pass);
            context_->film.add_surfaces(positions_, seen_);
        }
    } else {
        counts.rays = learn_lights_ahead(*context_, settings_, tracer_->lights());
        counts += render_pixels(pass);
    }
    total_ += counts;
    PassReport report;
    report.rays = counts.rays;
    return report;
}

PathCounts PathIntegrator::render_pixels(std::uint64_t pass) {
    const PathCounts counts = trace_pixels(pass);
    context_->film.add_pass({.positions = positions_,
                             .radiance = radiance_,
                             .groups = context_->film.light_groups(),
                             .weight = 1});
    if (!parts_.empty())
        context_->film.add_parts(
            {.positions = positions_, .radiance = parts_, .groups = kImageParts});
    if (!seen_.empty()) context_->film.add_surfaces(positions_, seen_);
    learn_lights(pass);
    return counts;
}

PathCounts PathIntegrator::trace_pixels(std::uint64_t pass) {
    const std::uint32_t height = context_->film.height();
    std::fill(radiance_.begin(), radiance_.end(), Rgb(0.0f));
    std::fill(parts_.begin(), parts_.end(), Rgb(0.0f));
    std::fill(seen_.begin(), seen_.end(), SeenSurface{});
    std::vector<PathCounts> counts(height);
    const std::size_t bsdf_bytes = context_->scene.facts().max_bsdf_bytes;
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, height), [&](const auto& rows) {
        std::vector<std::byte> buffer(bsdf_bytes + alignof(std::max_align_t));
        std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
        for (std::uint32_t y = rows.begin(); y != rows.end(); ++y) {
            counts[y] = render_row(pass, y, memory);
        }
    });
    PathCounts sum;
    for (const PathCounts& row : counts)
        sum += row;
    return sum;
}

/// Row by row, whichever thread rendered which.
void PathIntegrator::learn_lights(std::uint64_t pass) {
    if (!tracer_->lights().learns()) return;
    std::vector<aips::LightSample> samples;
    for (std::vector<aips::LightSample>& row : told_) {
        samples.insert(samples.end(), row.begin(), row.end());
        row.clear();
    }
    const auto paths = static_cast<std::uint32_t>(positions_.size());
    tracer_->lights().learn(samples, aips::light_samples_due(paths, kToldRays), pass + 1);
}

PathCounts PathIntegrator::render_row(std::uint64_t pass, std::uint32_t y,
                                      std::pmr::monotonic_buffer_resource& memory) {
    const RenderContext& context = *context_;
    const std::uint32_t width = context.film.width();
    const std::uint32_t groups = context.film.light_groups();
    const float open = context.camera.shutter_open();
    const float shutter = context.camera.shutter_close() - open;
    const bool learns = tracer_->lights().learns();
    const std::uint32_t stride =
        aips::paths_per_light_sample(static_cast<std::uint32_t>(positions_.size()), kToldRays);
    PathCounts counts;
    counts.paths = width;
    for (std::uint32_t x = 0; x < width; ++x) {
        const std::size_t pixel = std::size_t{y} * width + x;
        RandomStream random(context.settings.seed, pass, static_cast<std::uint32_t>(pixel));
        const CameraSample sample = context.sampler.camera_sample(pass, x, y);
        const CameraRay camera = context.camera.generate(sample, open + shutter * random.next());
        PathResult result{.radiance = std::span(radiance_).subspan(pixel * groups, groups)};
        if (learns && (pixel + pass) % stride == 0) result.told = &told_[y];
        if (!parts_.empty())
            result.parts = std::span(parts_).subspan(pixel * kImageParts, kImageParts);
        if (!seen_.empty()) result.seen = &seen_[pixel];
        tracer_->trace(camera.ray, random, memory, result);
        if (result.seen) result.seen->depth = camera.depth_at(result.seen->depth);
        positions_[pixel] = sample.film;
        counts.rays += result.rays;
        counts.bounces += result.bounces;
    }
    return counts;
}

void PathIntegrator::state(StateArchive& archive) {
    total_.state(archive);
    filter_->state(archive);
    tracer_->lights().state(archive);
    if (metropolis_) metropolis_->state(archive);
}

void PathIntegrator::learned(StateArchive& archive) {
    tracer_->lights().learned(archive);
}

Statistics PathIntegrator::statistics() const {
    Statistics statistics{{"paths", total_.paths}, {"rays", total_.rays}};
    if (total_.paths > 0) {
        statistics.emplace_back("bounces per path", static_cast<double>(total_.bounces) /
                                                        static_cast<double>(total_.paths));
    }
    if (metropolis_) {
        const Statistics of_chains = metropolis_->statistics();
        statistics.insert(statistics.end(), of_chains.begin(), of_chains.end());
    }
    if (filter_) statistics.emplace_back("refused contributions", filter_->total());
    return statistics;
}

InvalidSampleList PathIntegrator::invalid_samples() const {
    return filter_ ? filter_->list() : InvalidSampleList{};
}

}  // namespace lxs
