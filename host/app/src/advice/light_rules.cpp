// Advice on light that the integrator misses, and on radii that are too wide.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "advice/advice_rules.h"
#include "lxs/host/explanation.h"
#include "lxs/sdk/frame.h"
#include "lxs/sdk/rays.h"
#include "lxs/sdk/warp.h"

namespace lxs {
namespace {

constexpr std::size_t kMostAskedLights = 8;
constexpr int kSent = 256;               ///< rays from each
constexpr std::size_t kMostPlaces = 48;  ///< on specular surfaces in view that each is asked from
constexpr int kMostBends = 8;            ///< on each ray
constexpr double kBentShare = 0.01;      ///< of a light's own light, from which on it is missed
constexpr double kLobeShare = 0.1;       ///< of what is scattered, below which a lobe is left alone
constexpr int kLeastWays = 3;            ///< from places in view that count, few being chance
constexpr double kLeastChance = 0.005;   ///< of a ray to meet the light, below which dots show
constexpr double kLeastSupport = 0.5;
constexpr int kSupports = 8;

/// Of the light of one lamp that lands where the eye sees it.
struct LandedLight {
    double all = 0;      ///< that is scattered towards the eye, in the lamp's own units
    double bent = 0;     ///< of this, by lobes that are asked for, come through glass or by mirrors
    int from_view = 0;   ///< such ways by specular surfaces that are in view
    int ways = 0;        ///< those, and ways that the lamp's own rays took
    double chances = 0;  ///< over these, of a ray from where they land to meet the lamp

    bool is_found_by_chance() const {
        return (bent > kBentShare * all || from_view >= kLeastWays) && ways > 0 &&
               chances <= kLeastChance * ways;
    }
};

/// Chance that a ray in any direction meets the light from a place: 0 for a point.
double chance_to_meet(const Light& light, const SurfaceHit& from) {
    DirectSample sample;
    if (!light.sample_direct(from.p, from.ng, Vec2(0.5f), sample) || !(sample.pdf > 0)) return 0;
    return sample.delta ? 0 : 1 / (2 * static_cast<double>(kPi) * static_cast<double>(sample.pdf));
}

/// A ray of light on its way.
struct LightRay {
    std::optional<MetSurface> met;
    double power = 1;
    bool bent = false;  ///< by glass or a mirror
};

/// Follows light through specular surfaces to where the eye sees it land; false if it does nowhere.
bool land(SceneProbe& probe, ProbeNumbers& numbers, LightRay& light) {
    for (int i = 0; i < kMostBends && light.met && light.met->hit.bsdf; ++i) {
        const MetSurface& met = *light.met;
        if (met.hit.bsdf->lobes() != kSpecular) return probe.sees_eye(met);
        BsdfSample sample;
        const Vec2 u = numbers.next2();
        if (!met.hit.bsdf->sample(-met.ray.direction, u, numbers.next(), Transport::Power,
                                  kSpecular, sample))
            return false;
        light.bent |= !sample.straight;
        light.power *= static_cast<double>(luminance(sample.weight));
        light.met = probe.meet(continue_ray(met.hit, sample, met.ray));
    }
    return false;
}

/// What lobes of the surface scatter towards the eye, of light as it came.
double towards_eye(const SceneProbe& probe, const MetSurface& met, LobeMask lobes) {
    const Vec3 wo = (probe.eye() - met.hit.p).normalized();
    const Rgb f = met.hit.bsdf->evaluate(wo, -met.ray.direction, Transport::Radiance, lobes);
    return static_cast<double>(luminance(f));
}

/// Where the rays of a light go, and what `lobes` do with them.
void send_rays(SceneProbe& probe, const Light& light, LobeMask lobes, ProbeNumbers& numbers,
               LandedLight& landed) {
    for (int k = 0; k < kSent; ++k) {
        const PrimaryPoint u{numbers.next(), numbers.next(), numbers.next(), numbers.next()};
        EmissionSample emission;
        if (!light.sample_emission(u, emission)) continue;
        emission.ray.time = probe.time();
        LightRay ray{probe.meet(emission.ray), static_cast<double>(luminance(emission.power))};
        if (!land(probe, numbers, ray)) continue;
        landed.all += ray.power * towards_eye(probe, *ray.met, kDiffuse | kGlossy);
        const double scattered = ray.power * towards_eye(probe, *ray.met, lobes);
        if (!ray.bent || !(scattered > 0)) continue;
        landed.bent += scattered;
        ++landed.ways;
        landed.chances += chance_to_meet(light, ray.met->hit);
    }
}

/// Where light goes on from the specular surfaces in view: its own rays seldom meet small ones.
void send_by_what_is_seen(SceneProbe& probe, const Light& light, LobeMask lobes,
                          ProbeNumbers& numbers, LandedLight& landed) {
    const auto& specular = probe.specular();
    for (std::size_t i = 0; i < specular.size(); i += specular.size() / kMostPlaces + 1) {
        DirectSample sample;
        const SurfaceHit& hit = specular[i].hit;
        if (!light.sample_direct(hit.p, hit.ng, numbers.next2(), sample) || !(sample.pdf > 0) ||
            is_black(sample.radiance) ||
            is_black(probe.scene().transmittance(shadow_ray(hit, sample, probe.time()))))
            continue;
        LightRay ray{specular[i]};
        ray.met->ray.direction = -sample.wi;
        if (!land(probe, numbers, ray) || !ray.bent) continue;
        const double all = towards_eye(probe, *ray.met, kDiffuse | kGlossy);
        if (!(towards_eye(probe, *ray.met, lobes) > kLobeShare * all)) continue;
        ++landed.from_view;
        ++landed.ways;
        landed.chances += chance_to_meet(light, ray.met->hit);
    }
}

/// What `lobes` scatter of the light of a lamp.
LandedLight light_on(SceneProbe& probe, const Light& light, LobeMask lobes) {
    LandedLight landed;
    ProbeNumbers numbers(2);
    send_rays(probe, light, lobes, numbers, landed);
    send_by_what_is_seen(probe, light, lobes, numbers, landed);
    return landed;
}

/// Share of the disc of `radius` around what is seen there that is of the same surface.
double support(SceneProbe& probe, const MetSurface& seen, float radius) {
    const Vec3 up = from_behind(seen.ray, seen.hit) ? -seen.hit.ng : seen.hit.ng;
    const Frame frame(up);
    const float height = 0.5f * radius;
    int supported = 0;
    for (int i = 0; i < kSupports; ++i) {
        const float angle = 2 * kPi * (static_cast<float>(i) + 0.5f) / kSupports;
        const float distance = i % 2 == 0 ? 0.5f * radius : 0.9f * radius;
        Ray ray;
        ray.origin = seen.hit.p + frame.to_world(Vec3(distance * std::cos(angle),
                                                      distance * std::sin(angle), height));
        ray.direction = -up;
        ray.t_max = 2 * height;
        ray.time = probe.time();
        const auto met = probe.meet(ray);
        supported += met && std::abs(met->hit.ng.dot(up)) > std::sqrt(0.5f);
    }
    return double(supported) / kSupports;
}

}  // namespace

AdviceText path_misses_caustics(const AdviceFacts& facts) {
    const SceneFacts scene = facts.session.scene->facts();
    if (facts.session.integrator_name != "path" || !scene.has_specular) return {};
    const auto lights = facts.probe.scene().lights();
    for (std::size_t i = 0; i < std::min(lights.size(), kMostAskedLights); ++i) {
        if (!(lights[i]->power() > 0)) continue;
        const LandedLight matte = light_on(facts.probe, *lights[i], kDiffuse);
        const LandedLight glossy = light_on(facts.probe, *lights[i], kGlossy);
        if (!matte.is_found_by_chance() && !glossy.is_found_by_chance()) continue;
        const LandedLight& landed = matte.is_found_by_chance() ? matte : glossy;
        return fmt::format(
            "light of {} comes through glass or by mirrors onto what is seen, where \"path\" {}. "
            "Use SurfaceIntegrator \"aips\" (--integrator aips).",
            light_name(facts.session, i),
            landed.chances == 0 ? "misses it altogether"
                                : "finds it by chance alone, as bright dots");
    }
    return {};
}

AdviceText gloss_misses_caustics(const AdviceFacts& facts) {
    const LobeMask lobes = facts.transport.without_photons;
    if (lobes == 0 || !facts.session.scene->facts().has_specular) return {};
    const auto lights = facts.probe.scene().lights();
    for (std::size_t i = 0; i < std::min(lights.size(), kMostAskedLights); ++i) {
        if (!(lights[i]->power() > 0)) continue;
        const LandedLight landed = light_on(facts.probe, *lights[i], lobes);
        // What some rays find is noise; what none can find is lost.
        if (!landed.is_found_by_chance() || landed.chances > 0) continue;
        return fmt::format(
            "light of {} comes through glass or by mirrors onto glossy surfaces, which take no "
            "photons, and is missing there, as no ray meets a lamp without extent. Use "
            "SurfaceIntegrator \"aips\" with its defaults, \"bool storeglossy\" [\"true\"], or a "
            "lamp "
            "with some extent.",
            light_name(facts.session, i));
    }
    return {};
}

AdviceText radius_is_wider_than_objects(const AdviceFacts& facts) {
    const auto radius = static_cast<float>(facts.transport.radius);
    if (!(radius > 0)) return {};
    int points = 0, wide = 0;
    constexpr std::size_t kEvery = 4;
    const auto& seen = facts.probe.seen();
    for (std::size_t i = 0; i < seen.size(); i += kEvery) {
        if (!seen[i].hit.bsdf || !(seen[i].hit.bsdf->lobes() & kDiffuse)) continue;
        ++points;
        wide += support(facts.probe, seen[i], radius) < kLeastSupport;
    }
    if (points == 0 || 2 * wide < points) return {};
    return fmt::format(
        "photons are gathered within {:.2g} units, which is wider than most of what is seen: light "
        "is blurred and leaks. Give a smaller startradius, or none.",
        double(radius));
}

}  // namespace lxs
