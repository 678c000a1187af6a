// The integrator `path`: one sample a pixel and pass, rows in parallel, or Markov chains.
#include "path/path_integrator.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace lxs {

void MaterialRefusals::refuse(std::uint32_t material) {
    const std::size_t index = std::min<std::size_t>(material, counts_.size() - 1);
    counts_[index].fetch_add(1, std::memory_order_relaxed);
}

std::uint64_t MaterialRefusals::total() const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i)
        sum += count(i);
    return sum;
}

std::uint64_t MaterialRefusals::count(std::size_t index) const {
    return counts_[index].load(std::memory_order_relaxed);
}

void MaterialRefusals::state(StateArchive& archive) {
    std::vector<std::uint64_t> counts(counts_.begin(), counts_.end());
    archive.fixed(counts);
    std::copy(counts.begin(), counts.end(), counts_.begin());
}

void PathIntegrator::prepare(const RenderContext& context) {
    context_.emplace(context);
    refusals_ = std::make_unique<MaterialRefusals>(context.scene.material_names().size());
    tracer_.emplace(context.scene, settings_, *refusals_);
    context.log.info("path: " + settings_.text());
    if (const MetropolisSettings* metropolis = context.sampler.metropolis()) {
        metropolis_.emplace(context, *tracer_, *metropolis);
        context.log.info("path: " + metropolis_->text());
        return;
    }
    const std::size_t pixels = std::size_t{context.film.width()} * context.film.height();
    positions_.resize(pixels);
    radiance_.resize(pixels * context.film.light_groups());
}

PassReport PathIntegrator::render_pass(std::uint64_t pass) {
    const PathCounts counts = metropolis_ ? metropolis_->render_pass() : render_pixels(pass);
    total_ += counts;
    warn_of_refusals();
    PassReport report;
    report.rays = counts.rays;
    return report;
}

PathCounts PathIntegrator::render_pixels(std::uint64_t pass) {
    const std::uint32_t height = context_->film.height();
    std::fill(radiance_.begin(), radiance_.end(), Rgb(0.0f));
    std::vector<PathCounts> counts(height);
    const std::size_t bsdf_bytes = context_->scene.facts().max_bsdf_bytes;
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, height), [&](const auto& rows) {
        std::vector<std::byte> buffer(bsdf_bytes + alignof(std::max_align_t));
        std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
        for (std::uint32_t y = rows.begin(); y != rows.end(); ++y) {
            counts[y] = render_row(pass, y, memory);
        }
    });
    context_->film.add_pass({.positions = positions_,
                             .radiance = radiance_,
                             .groups = context_->film.light_groups(),
                             .weight = 1});
    PathCounts sum;
    for (const PathCounts& row : counts)
        sum += row;
    return sum;
}

PathCounts PathIntegrator::render_row(std::uint64_t pass, std::uint32_t y,
                                      std::pmr::monotonic_buffer_resource& memory) {
    const RenderContext& context = *context_;
    const std::uint32_t width = context.film.width();
    const std::uint32_t groups = context.film.light_groups();
    const float open = context.camera.shutter_open();
    const float shutter = context.camera.shutter_close() - open;
    PathCounts counts;
    counts.paths = width;
    for (std::uint32_t x = 0; x < width; ++x) {
        const std::size_t pixel = std::size_t{y} * width + x;
        RandomStream random(context.settings.seed, pass, static_cast<std::uint32_t>(pixel));
        const CameraSample sample = context.sampler.camera_sample(pass, x, y);
        const CameraRay camera = context.camera.generate(sample, open + shutter * random.next());
        PathResult result{.radiance = std::span(radiance_).subspan(pixel * groups, groups)};
        tracer_->trace(camera.ray, random, memory, result);
        positions_[pixel] = sample.film;
        counts.rays += result.rays;
        counts.bounces += result.bounces;
    }
    return counts;
}

void PathIntegrator::warn_of_refusals() {
    if (warned_ || refusals_->total() == 0) return;
    warned_ = true;
    const auto names = context_->scene.material_names();
    for (std::size_t i = 0; i <= names.size(); ++i) {
        if (refusals_->count(i) == 0) continue;
        const std::string where =
            i < names.size() ? fmt::format("at material \"{}\"", names[i]) : "from outside";
        context_->log.warning(fmt::format(
            "path: refused a contribution {} that is no finite positive number", where));
    }
}

void PathIntegrator::state(StateArchive& archive) {
    total_.state(archive);
    refusals_->state(archive);
    archive.value(warned_);
    if (metropolis_) metropolis_->state(archive);
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
    if (!refusals_) return statistics;
    statistics.emplace_back("refused contributions", refusals_->total());
    const auto names = context_->scene.material_names();
    for (std::size_t i = 0; i <= names.size(); ++i) {
        if (refusals_->count(i) == 0) continue;
        statistics.emplace_back(
            "refused contributions at " + (i < names.size() ? names[i] : "the environment"),
            refusals_->count(i));
    }
    return statistics;
}

}  // namespace lxs
