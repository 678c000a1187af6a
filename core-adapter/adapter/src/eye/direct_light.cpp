// Next-event estimation (Veach 1997, chapter 9: one-sample light choice, balance heuristic).
#include "eye/direct_light.h"

#include "base/vector_growth.h"
#include "eye/light_choice.h"

namespace aips {

DirectLight::DirectLight(const Scene& scene, bool learns)
    : scene_(scene), choice_(light_choice(scene)) {
    if (learns && !choice_.empty()) learned_.emplace(scene.bounds(), choice_);
    for (LightIndex i = 0; i < scene.lights().size(); ++i) {
        if (scene.lights()[i]->at_infinity()) at_infinity_.push_back(i);
    }
}

DirectLightResult DirectLight::estimate(const DirectLightQuery& query, const VertexNumbers& numbers,
                                        InvalidSampleFilter& filter,
                                        const LightTarget& radiance) const {
    DirectLightResult result;
    if (choice_.empty()) return result;
    const auto chosen = choice_at(query.point).sample(numbers.light_choice());
    const auto index = static_cast<LightIndex>(chosen.index);
    result.sample = {query.point.position, query.point.geometric_normal, index, chosen.pdf, 0};
    const Light& light = *scene_.lights()[index];
    DirectSample sample;
    if (!light.sample_direct(query.point, numbers.light(), sample)) return result;
    if (!filter.accept_sample(sample, index) || sample.pdf == 0) return result;

    const Bsdf& bsdf = *query.point.bsdf;
    const float pdf_light = sample.pdf * chosen.pdf;
    Rgb f, alone;
    bool refused = false;
    // The shadow ray's share of `value` beside a ray that `mask` draws with this probability.
    const auto shared = [&](const Rgb& value, LobeMask mask, float probability) {
        if (sample.delta || !(probability > 0)) return value;
        const float pdf_bounce = probability * bsdf.pdf(query.wo, sample.wi, mask);
        refused |= !filter.accept_density(pdf_bounce, query.point.material);
        return value * (pdf_light / (pdf_light + pdf_bounce));
    };
    if (query.shared) {
        f = alone = shared(bsdf.evaluate(query.wo, sample.wi, Transport::Radiance, query.shared),
                           query.bounce, query.continue_pdf);
    }
    if (query.owned) {
        const Rgb owned = bsdf.evaluate(query.wo, sample.wi, Transport::Radiance, query.owned);
        alone += owned;
        f += shared(owned, query.owned, query.owned_pdf);
    }
    if (refused) return result;
    if (is_black(f) || is_black(sample.radiance)) return result;
    if (!filter.accept(f, query.point.material)) return result;
    const float cosine = abs_dot(sample.wi, query.point.shading_normal);
    const Rgb unoccluded = query.throughput * f * sample.radiance * (cosine / pdf_light);
    if (!filter.accept(unoccluded, query.point.material)) return result;
    const Rgb passed = scene_.visibility(query.point, sample, query.time);
    result.rays = 1;
    radiance.add(light.group(), unoccluded * passed, kPassageOrigin, filter);
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

std::size_t DirectLight::memory_bound_bytes(const Scene& scene, std::size_t samples) {
    return LearnedLights::memory_bound_bytes(scene.lights().size()) +
           (kMostNewRays + samples) * kVectorGrowth * sizeof(LightSample);
}

}  // namespace aips
