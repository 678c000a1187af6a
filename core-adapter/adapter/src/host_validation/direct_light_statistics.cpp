// Directions to a light from one place: drawn by the light, and met by rays of a known density.
#include "direct_light_statistics.h"

#include "aips/core/base/arena.h"
#include "emit_at_random.h"
#include "tolerances.h"

namespace aips {
namespace {

/// Draws of that mean.
constexpr int kStraightDraws = 64;

/// Surfaces that light passes straight on the way to a light, beyond which nothing is compared.
constexpr int kMostPassed = 16;

/// How far behind an emitter it is looked at from (diagonals of the scene).
constexpr float kBehind = 1e-3f;

/// Looks from there (draws).
constexpr int kBehindDraws = 64;

bool near(float a, float b) {
    return std::abs(a - b) <= kSame * std::max(std::abs(a), std::abs(b));
}

class Place {
  public:
    Place(const Scene& scene, LightIndex number, const SurfacePoint& point, float time,
          RandomStream& random, DirectLightStatistics& statistics)
        : scene_(scene),
          number_(number),
          light_(*scene.lights()[number]),
          point_(point),
          time_(time),
          random_(random),
          statistics_(statistics) {}

    /// Directions in which the light is seen; empty if it is not.
    std::vector<Vec3> pilots() {
        std::vector<Vec3> found;
        bool reached = false;
        for (int i = 0; i < kPilots; ++i) {
            DirectSample s;
            if (!draw(s)) continue;
            found.push_back(s.wi);
            look_at_visibility(s);
            reached = reached ||
                      (!is_black(s.radiance) && !is_black(scene_.visibility(point_, s, time_)));
        }
        return reached ? found : std::vector<Vec3>();
    }

    void ask(const DirectionProposal& q, std::uint32_t samples) {
        for (std::uint32_t i = 0; i < samples; ++i)
            statistics_.by_samples.add(sample(q));
        for (std::uint32_t i = 0; i < samples; ++i)
            statistics_.by_density.add(meet(q));
    }

  private:
    bool draw(DirectSample& s) {
        if (!light_.sample_direct(point_, random_.next2(), s)) return false;
        return statistics_.values.look(
            is_valid_radiance(s.radiance) && s.pdf > 0 && std::isfinite(s.pdf) && s.distance > 0 &&
                std::abs(length_squared(s.wi) - 1) < 1e-3f,
            [&] {
                return "a direct sample of radiance " + figure(luminance(s.radiance)) + ", pdf " +
                       figure(s.pdf) + ", distance " + figure(s.distance) +
                       ", direction of length " + figure(length(s.wi));
            });
    }

    bool trace(Vec3 direction, SurfacePoint& met) {
        arena_.reset();
        return scene_.intersect(scene_.spawn(point_, direction, time_), met, arena_);
    }

    /// Whether the light is that of a medium which the ray to `met` crossed.
    bool in_medium(const SurfacePoint& met) const { return met.medium_light == number_; }
    /// Whether it has no place where a ray meets it.
    bool placeless(const SurfacePoint& met) const { return light_.at_infinity() || in_medium(met); }
    Rgb seen_light(Vec3 direction, const SurfacePoint& met) const {
        if (light_.at_infinity()) return light_.escaped(direction);
        return in_medium(met) ? met.medium_emitted : met.emitted;
    }

    /// q / (p + q) for a direction that reaches the light.
    double sample(const DirectionProposal& q) {
        DirectSample s;
        if (!draw(s)) return 0;
        coordinates(s);
        statistics_.deltas.look(s.delta == light_.is_delta(), [&] {
            return std::string("a direct sample with delta ") + (s.delta ? "true" : "false");
        });
        if (s.delta) return 0;
        SurfacePoint met;
        const bool hit = trace(s.wi, met);
        if (!light_.at_infinity() && !in_medium(met) && !reaches(s, hit, met)) return 0;
        const float p = light_.pdf_direct(point_, s.wi, placeless(met) ? nullptr : &met);
        const Rgb seen = seen_light(s.wi, met);
        // Of a medium both are estimates.
        statistics_.radiances.look(in_medium(met) || near(luminance(seen), luminance(s.radiance)),
                                   [&] {
                                       return "radiance " + figure(luminance(s.radiance)) +
                                              " sampled, " + figure(luminance(seen)) + " seen";
                                   });
        statistics_.pdfs.look(near(p, s.pdf), [&] {
            return "pdf " + figure(s.pdf) + " sampled, pdf_direct() " + figure(p);
        });
        const double known = q.pdf(s.wi);
        return p >= 0 ? known / (p + known) : 0;
    }

    /// Whether the sampled light point is the first thing in its direction.
    bool reaches(const DirectSample& s, bool hit, const SurfacePoint& met) {
        const bool there = hit && near(met.distance, s.distance) && met.light == number_;
        const bool nearer = hit && met.distance < s.distance * (1 + kSame);
        // A light that is drawn where it is black need not be there.
        if ((there || !nearer) && !is_black(s.radiance)) {
            statistics_.missed.look(there, [&] {
                return "a light point at distance " + figure(s.distance) + ", where a ray meets " +
                       (hit ? "something at " + figure(met.distance) : std::string("nothing"));
            });
        }
        return there;
    }

    /// What of light that goes on along `direction` passes the surface straight, by its Bsdf.
    static Rgb straight_share(const SurfacePoint& met, Vec3 direction) {
        Rgb share;
        if (!met.bsdf || !(met.bsdf->lobes() & kSpecular)) return share;
        for (int i = 0; i < kStraightDraws; ++i) {
            BsdfSample s;
            const float u_lobe = (float(i) + 0.5f) / kStraightDraws;
            if (met.bsdf->sample(-direction, {0.5f, 0.5f}, u_lobe, Transport::Power, kSpecular,
                                 s) &&
                s.straight)
                share += s.weight * (1.0f / kStraightDraws);
        }
        return share;
    }

    /// What stands between the place and a light point.
    struct Way {
        bool known = false;  ///< it is not too near to the light to tell
        Rgb share = kWhite;  ///< of light that passes it straight, media included
        bool free = true;    ///< there is no surface
        SurfacePoint last;   ///< the last of them
    };
    Way way_to(const DirectSample& s) {
        Way way;
        Ray ray = scene_.spawn(point_, s.wi, time_);
        float gone = 0;
        for (int i = 0; i < kMostPassed; ++i) {
            arena_.reset();
            SurfacePoint met;
            const bool hit = scene_.intersect(ray, met, arena_);
            way.share *= met.transmittance;
            if (is_black(way.share)) return way;  // a medium lets nothing pass
            gone += met.distance;
            const bool before = hit && gone < s.distance * (1 - kSame);
            if (!before) {
                // Of a medium that emits it goes on to the next surface.
                if (in_medium(met)) return way;
                way.known = !hit || (met.light == number_ && near(gone, s.distance));
                return way;
            }
            way.free = false;
            way.last = met;
            way.share *= straight_share(met, s.wi);
            way.known = is_black(way.share);
            if (way.known) return way;
            ray = scene_.spawn(met, s.wi, time_);
        }
        return way;
    }

    void look_at_visibility(const DirectSample& s) {
        const Way way = way_to(s);
        if (!way.known) return;
        const Rgb visible = scene_.visibility(point_, s, time_);
        if (is_black(way.share)) {
            statistics_.blocked.look(is_black(visible), [&] {
                return "light from distance " + figure(s.distance) + " through " +
                       material_subject(scene_, way.last.material);
            });
            return;
        }
        statistics_.open.look(!is_black(visible), [&] {
            return way.free ? "no light, and nothing in its way"
                            : "no light through " + material_subject(scene_, way.last.material);
        });
        if (is_black(visible)) return;
        const float found = luminance(visible), expected = luminance(way.share);
        const float larger = std::max(found, expected);
        statistics_.shares.look(std::abs(found - expected) <= kSameShare * larger, [&] {
            return "a share of " + figure(found) + " where " + figure(expected) + " passes" +
                   (way.free ? std::string() : " " + material_subject(scene_, way.last.material));
        });
    }

    void coordinates(const DirectSample& s) {
        PrimaryPoint u{};
        u.fill(0.5f);
        if (!light_.emission_coordinates(point_, s, u)) return;
        const bool within = std::all_of(u.begin(), u.end(), [](auto x) { return x >= 0 && x < 1; });
        Emission e;
        const bool emitted = within && light_.emit(u, e);
        const Vec3 to = point_.position - e.ray.origin;
        const float off = length(to - e.ray.direction * std::max(0.0f, dot(to, e.ray.direction)));
        const float slack = 5e-3f * std::max(scene_.bounds().diagonal(), length(to));
        statistics_.coordinates.look(emitted && off <= slack, [&] {
            return emitted ? "a photon that passes the point at distance " + figure(off)
                           : std::string("coordinates that emit nothing");
        });
    }

    /// p / (p + q) for a direction in which the light is seen.
    double meet(const DirectionProposal& q) {
        const Vec3 w = q.sample(random_);
        const double known = q.pdf(w);
        SurfacePoint met;
        if (!light_.at_infinity()) {
            const bool hit = trace(w, met) && met.light == number_;
            if (!hit && !in_medium(met)) return 0;
        }
        const float p = light_.pdf_direct(point_, w, placeless(met) ? nullptr : &met);
        const Rgb seen = seen_light(w, met);
        const bool sound =
            statistics_.values.look(p >= 0 && std::isfinite(p) && is_valid_radiance(seen),
                                    [&] { return "pdf_direct() " + figure(p); });
        if (!sound) return 0;
        if (luminance(seen) > 0) {
            statistics_.unasked.look(p > 0, [&] {
                return "radiance " + figure(luminance(seen)) + " where pdf_direct() is 0";
            });
        }
        return p / (p + known);
    }

    const Scene& scene_;
    LightIndex number_;
    const Light& light_;
    const SurfacePoint& point_;
    float time_;
    RandomStream& random_;
    DirectLightStatistics& statistics_;
    Arena arena_;
};

/// A place of no surface.
SurfacePoint point_at(Vec3 position) {
    SurfacePoint point;
    point.position = position;
    return point;
}

}  // namespace

void look_from_behind(const Scene& scene, LightIndex number, float time, RandomStream& random,
                      CheckStatistics& statistics) {
    const Light& light = *scene.lights()[number];
    if (light.at_infinity()) return;
    const float step = kBehind * scene.bounds().diagonal();
    for (int i = 0; i < kBehindDraws; ++i) {
        Emission emission;
        if (!emit_at_random(light, random, emission)) continue;
        const Vec3 direction = emission.ray.direction;
        Ray ray = emission.ray;
        ray.time = time;
        ray.origin = ray.origin - direction * step;
        Arena arena;
        SurfacePoint met;
        if (!scene.intersect(ray, met, arena) || met.light != number || met.distance > 2 * step ||
            dot(direction, met.geometric_normal) <= 0 || is_black(met.emitted))
            continue;
        statistics.look(light.pdf_direct(point_at(ray.origin), direction, &met) > 0, [&] {
            return "radiance " + figure(luminance(met.emitted)) +
                   " behind it, where pdf_direct() is 0";
        });
    }
}

void ask_direct_light(const Scene& scene, LightIndex light, const Ray& ray, std::uint32_t samples,
                      std::uint32_t places, RandomStream& random,
                      DirectLightStatistics& statistics) {
    Arena arena;
    SurfacePoint point;
    if (!scene.intersect(ray, point, arena)) return;
    Place place(scene, light, point, ray.time, random, statistics);
    std::vector<Vec3> pilots = place.pilots();
    if (pilots.empty() || statistics.places >= places) return;
    ++statistics.places;
    place.ask(DirectionProposal(std::move(pilots)), samples);
}

}  // namespace aips
