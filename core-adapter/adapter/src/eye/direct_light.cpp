// Next-event estimation (Veach 1997, chapter 9: one-sample light choice, balance heuristic).
#include "eye/direct_light.h"

#include <algorithm>
#include <utility>

#include "base/vector_growth.h"
#include "eye/constants.h"
#include "eye/light_choice.h"

namespace aips {

DirectLight::DirectLight(const Scene& scene, bool learns)
    : scene_(scene), choice_(light_choice(scene)) {
    if (learns && !choice_.empty())
        tables_.emplace(scene.bounds(), choice_, light_table_settings(choice_.size()));
    for (LightIndex i = 0; i < scene.lights().size(); ++i) {
        if (scene.lights()[i]->at_infinity()) at_infinity_.push_back(i);
    }
}

DirectLightResult DirectLight::estimate(const DirectLightQuery& query, const VertexNumbers& numbers,
                                        Refusals& refusals, std::span<Rgb> radiance) const {
    DirectLightResult result;
    if (choice_.empty()) return result;
    const auto chosen = choice_at(query.point).sample(numbers.light_choice());
    const auto index = static_cast<LightIndex>(chosen.index);
    result.sample = {query.point.position, query.point.geometric_normal, index, chosen.pdf, 0};
    const Light& light = *scene_.lights()[index];
    DirectSample sample;
    if (!light.sample_direct(query.point, numbers.light(), sample)) return result;
    if (!refusals.accept_sample(sample, index) || sample.pdf == 0) return result;

    const Bsdf& bsdf = *query.point.bsdf;
    const float pdf_light = sample.pdf * chosen.pdf;
    Rgb f, alone;
    if (query.owned) f += bsdf.evaluate(query.wo, sample.wi, Transport::Radiance, query.owned);
    alone = f;
    if (query.shared) {
        const Rgb shared = bsdf.evaluate(query.wo, sample.wi, Transport::Radiance, query.shared);
        const float pdf_bounce =
            sample.delta ? 0 : query.continue_pdf * bsdf.pdf(query.wo, sample.wi, query.bounce);
        if (!refusals.accept_density(pdf_bounce, query.point.material)) return result;
        f += shared * (pdf_light / (pdf_light + pdf_bounce));
        alone += shared;
    }
    if (is_black(f) || is_black(sample.radiance)) return result;
    if (!refusals.accept(f, query.point.material)) return result;
    const float cosine = abs_dot(sample.wi, query.point.shading_normal);
    const Rgb unoccluded = query.throughput * f * sample.radiance * (cosine / pdf_light);
    if (!refusals.accept(unoccluded, query.point.material)) return result;
    const Rgb passed = scene_.visibility(query.point, sample, query.time);
    result.rays = 1;
    refusals.add(radiance[light.group()], unoccluded * passed, kPassageOrigin);
    result.brought = luminance(unoccluded * passed);
    result.alone =
        luminance(query.throughput * alone * sample.radiance * passed * (cosine / pdf_light));
    result.sample.value = luminance(f * sample.radiance * passed * (cosine / sample.pdf));
    return result;
}

float DirectLight::pdf(LightIndex light, const SurfacePoint& from, Vec3 wi,
                       const SurfacePoint* at) const {
    return choice_at(from).pdf(light) * scene_.lights()[light]->pdf_direct(from, wi, at);
}

void DirectLight::learn(std::span<const LightSample> samples, std::uint64_t due,
                        std::uint64_t passes) {
    if (!learns()) return;
    waiting_.insert(waiting_.end(), samples.begin(), samples.end());
    due_ += due;
    if (due_ < due_at_most()) return;
    for (const LightSample& sample : waiting_)
        tables_->add(sample);
    tables_->update(waiting_.size());
    learned_ += std::exchange(due_, 0);
    passes_before_ = passes;
    waiting_.clear();
    if (!learns()) waiting_.shrink_to_fit();
}

bool DirectLight::learns() const {
    return tables_ && learned_ < kEnoughRays;
}

std::uint64_t DirectLight::due_at_most() const {
    return learns() ? std::clamp(learned_ / 2, kFewestNewRays, kMostNewRays) : 1;
}

void DirectLight::state(StateArchive& archive) {
    if (!tables_) return;
    tables_->state(archive);
    archive.value(learned_);
    archive.value(passes_before_);
    archive.value(due_);
    StateArchive::check(due_ < due_at_most(), "shadow rays that would have been learned from");
    const std::size_t waiting = archive.count(waiting_.size(), 9 * sizeof(float));
    StateArchive::check(waiting <= due_, "more shadow rays than were to tell");
    waiting_.resize(waiting);
    for (LightSample& s : waiting_) {
        for (Vec3* v : {&s.position, &s.normal}) {
            for (float* x : {&v->x, &v->y, &v->z})
                archive.value(*x);
        }
        archive.value(s.light);
        archive.value(s.pdf);
        archive.value(s.value);
    }
}

std::size_t DirectLight::memory_bytes() const {
    return (tables_ ? tables_->memory_bytes() : 0) + waiting_.capacity() * sizeof(LightSample);
}

std::size_t DirectLight::memory_bound_bytes(const Scene& scene, std::size_t samples) {
    const std::size_t lights = scene.lights().size();
    return LightTables::memory_bound_bytes(light_table_settings(lights), lights) +
           (kMostNewRays + samples) * kVectorGrowth * sizeof(LightSample);
}

}  // namespace aips
