// Next-event estimation (Veach 1997, chapter 9: one-sample light choice, balance heuristic).
#include "direct_light.h"

#include "light_choice.h"

namespace aips {

DirectLight::DirectLight(const Scene& scene) : scene_(scene), choice_(light_choice(scene)) {
    for (LightIndex i = 0; i < scene.lights().size(); ++i) {
        if (scene.lights()[i]->at_infinity()) at_infinity_.push_back(i);
    }
}

unsigned DirectLight::estimate(const DirectLightQuery& query, RandomStream& random,
                               Refusals& refusals, std::span<Rgb> radiance) const {
    if (choice_.empty()) return 0;
    const float u_choice = random.next();
    const Vec2 u_light = random.next2();
    const auto chosen = choice_.sample(u_choice);
    const Light& light = *scene_.lights()[chosen.index];
    DirectSample sample;
    if (!light.sample_direct(query.point, u_light, sample)) return 0;
    const auto index = static_cast<LightIndex>(chosen.index);
    if (!refusals.accept_sample(sample, index) || sample.pdf == 0) return 0;

    const Bsdf& bsdf = *query.point.bsdf;
    const float pdf_light = sample.pdf * chosen.pdf;
    Rgb f;
    if (query.owned) f += bsdf.evaluate(query.wo, sample.wi, Transport::Radiance, query.owned);
    if (query.shared) {
        const Rgb shared = bsdf.evaluate(query.wo, sample.wi, Transport::Radiance, query.shared);
        const float pdf_bounce =
            sample.delta ? 0 : query.continue_pdf * bsdf.pdf(query.wo, sample.wi, query.bounce);
        if (!refusals.accept_density(pdf_bounce, query.point.material)) return 0;
        f += shared * (pdf_light / (pdf_light + pdf_bounce));
    }
    if (is_black(f) || is_black(sample.radiance)) return 0;
    if (!refusals.accept(f, query.point.material)) return 0;
    const float cosine = abs_dot(sample.wi, query.point.shading_normal);
    const Rgb unoccluded = query.throughput * f * sample.radiance * (cosine / pdf_light);
    if (!refusals.accept(unoccluded, query.point.material)) return 0;
    const Rgb passed = scene_.visibility(query.point, sample, query.time);
    refusals.add(radiance[light.group()], unoccluded * passed, kPassageOrigin);
    return 1;
}

float DirectLight::pdf(LightIndex light, const SurfacePoint& from, Vec3 wi,
                       const SurfacePoint* at) const {
    return choice_.pdf(light) * scene_.lights()[light]->pdf_direct(from, wi, at);
}

}  // namespace aips
