// One eye path: bounces through the lobes that do not take photons, ends at one that does. Which
// strategy owns which class of paths is tabulated in docs/understand/who-carries-which-light.md.
#include "eye/eye_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "eye/constants.h"
#include "eye/volume_light.h"
#include "refusal/meet_surface.h"

namespace aips {
namespace {

/// State of an eye path between two surfaces.
class EyePath {
  public:
    EyePath(const EyePassInput& input, const CameraRay& camera_ray, const EyeNumbers& numbers,
            RandomStream& random, Refusals& refusals, Arena& arena, std::span<Rgb> radiance)
        : in_(input),
          camera_ray_(camera_ray),
          numbers_(numbers),
          random_(random),
          refusals_(refusals),
          arena_(arena),
          radiance_(radiance),
          media_(input.scene.media()),
          ray_(camera_ray.ray) {}

    EyePathResult trace() {
        follow(1);
        if (result_.has_beam) result_.beam.throughput *= beam_weights_ / beam_weight_;
        return result_;
    }

  private:
    /// From vertex number `depth` on.
    void follow(std::uint32_t depth) {
        for (; depth <= in_.settings.max_eye_depth; ++depth) {
            const auto mark = arena_.mark();
            SurfacePoint point;
            ++result_.rays;
            const bool met = meet_surface(in_.scene, ray_, point, arena_, refusals_);
            if (media_ && media_->scatters(ray_.medium)) cross_medium(point.distance);
            throughput_ *= point.transmittance;
            if (!met) {
                add_escaped();
                break;
            }
            travelled_ += point.distance;
            add_emitted(point);
            const bool go_on = point.bsdf && scatter(point, depth);
            if (result_.has_visible_point) {
                if (!result_.visible_point.bsdf) arena_.rewind(mark);
                break;
            }
            arena_.rewind(mark);
            if (!go_on) break;
        }
    }

    /// Light that the medium scatters into the ray on the way to the next surface: from lights by a
    /// shadow ray, all other by photons.
    void cross_medium(float length) {
        VolumeBeam beam{ray_.origin, ray_.direction, length, ray_.medium, throughput_};
        if (!(length > 0)) return;
        if (in_.settings.direct_light_sampling) {
            result_.rays += estimate_scattered_light(in_.scene, in_.direct_light, beam, ray_.time,
                                                     random_, refusals_, radiance_);
        }
        if (in_.keep_visible_points) keep(beam);
    }

    /// Keeps one of the path's beams, chosen by what it may scatter (reservoir sampling).
    void keep(const VolumeBeam& beam) {
        const Rgb passed = transmittance(media_->extinction(beam.medium), beam.length);
        const float weight = luminance(beam.throughput * (kWhite - passed));
        if (!(weight > 0) || !refusals_.accept(beam.throughput, kPassageOrigin)) return;
        beam_weights_ += weight;
        if (result_.has_beam && random_.next() * beam_weights_ >= weight) return;
        beam_weight_ = weight;
        result_.has_beam = true;
        result_.beam = beam;
        result_.beam_footprint =
            camera_ray_.width + camera_ray_.spread * (travelled_ + 0.5f * beam.length);
    }

    /// Share of the light met by the current ray that shadow rays from the last vertex leave to it.
    float emission_weight(LightIndex light, const SurfacePoint* at) const {
        if (last_was_specular_) return 1;
        const float pdf_light = in_.direct_light.pdf(light, last_vertex_, ray_.direction, at);
        // No density: what it weighs is refused, and counted against the light.
        if (!(pdf_light >= 0)) return std::numeric_limits<float>::quiet_NaN();
        if (bounce_pdf_ == 0) return 0;
        return bounce_pdf_ / (bounce_pdf_ + pdf_light);
    }

    void add(const Rgb& value, LightIndex light) {
        refusals_.add(radiance_[in_.scene.lights()[light]->group()], value,
                      refusals_.of_light(light));
    }

    void add_emitted(const SurfacePoint& point) {
        if (point.light == kNoLight || is_black(point.emitted)) return;
        const float weight = lamp_share_ * emission_weight(point.light, &point);
        add(throughput_ * point.emitted * weight, point.light);
    }

    void add_escaped() {
        if (last_was_specular_ && !in_.settings.include_environment) return;
        const auto lights = in_.scene.lights();
        for (const LightIndex i : in_.direct_light.at_infinity()) {
            const Rgb seen = lights[i]->escaped(ray_.direction);
            if (is_black(seen) || !refusals_.accept(seen, refusals_.of_light(i))) continue;
            add(throughput_ * seen * (lamp_share_ * emission_weight(i, nullptr)), i);
        }
    }

    /// Direct light, then either a visible point or a bounce. False when the path ends.
    bool scatter(const SurfacePoint& point, std::uint32_t depth) {
        const bool last = depth == in_.settings.max_eye_depth;
        const VertexNumbers numbers = numbers_.vertex(depth);
        const Vec3 wo = -ray_.direction;
        const LobeMask lobes = point.bsdf->lobes();
        if (lobes == kSpecular) {
            if (last) return false;
            const Vec2 u = numbers.direction();
            const float u_lobe = numbers.lobe();
            if (branches_ < kMostBranches && !media_)
                look_the_other_way(point, wo, u, u_lobe, depth);
            return bounce(point, wo, kSpecular, 1, u, u_lobe);
        }
        if (lamps_only_) return false;
        lamp_share_ = 1;
        branches_ = kMostBranches;
        const LobeMask receiving = lobes & receiving_lobes(in_.settings);
        const LobeMask bouncing = lobes & ~receiving;
        const float store_pdf = store_probability(point, wo, receiving, last ? 0 : bouncing);

        if (in_.settings.direct_light_sampling && (lobes & kNonSpecular)) {
            const LobeMask shared = bouncing & kNonSpecular;
            const DirectLightQuery query{point,     wo,     ray_.time, throughput_,
                                         receiving, shared, bouncing,  last ? 0 : 1 - store_pdf};
            estimate_direct_light(query, numbers);
        }
        if (receiving && (store_pdf == 1 || numbers.end() < store_pdf)) {
            if (in_.keep_visible_points) store(point, wo, receiving, store_pdf);
            return false;
        }
        if (last || !bouncing) return false;
        throughput_ *= 1 / (1 - store_pdf);
        return bounce(point, wo, bouncing, 1 - store_pdf, numbers.direction(), numbers.lobe());
    }

    /// Of the two ways that a smooth surface offers the path takes one. Lamps seen by smooth
    /// surfaces alone are looked for by the other way too, and count each way by its share: by
    /// chance alone one path in 25 would meet the lamp that a glass reflects, with all its light.
    void look_the_other_way(const SurfacePoint& point, Vec3 wo, Vec2 u, float u_lobe,
                            std::uint32_t depth) {
        const float first = point.bsdf->first_specular(wo);
        if (!(first > 0 && first < 1)) return;
        ++branches_;
        const bool takes_first = u_lobe < first;
        const float within = takes_first ? u_lobe / first : (u_lobe - first) / (1 - first);
        const float other_u = takes_first ? std::min(first + within * (1 - first), 0x1.fffffep-1f)
                                          : std::min(within * first, std::nextafter(first, 0.0f));
        EyePath other(*this);
        other.lamps_only_ = true;
        other.result_ = {};
        other.branches_ = kMostBranches;
        other.lamp_share_ *= takes_first ? 1 - first : first;
        lamp_share_ *= takes_first ? first : 1 - first;
        if (other.bounce(point, wo, kSpecular, 1, u, other_u)) other.follow(depth + 1);
        result_.rays += other.result_.rays;
    }

    void estimate_direct_light(const DirectLightQuery& query, const VertexNumbers& numbers) {
        const DirectLightResult direct =
            in_.direct_light.estimate(query, numbers, refusals_, radiance_);
        result_.rays += direct.rays;
        if (in_.direct_light.learns() && result_.light_sample.pdf == 0)
            result_.light_sample = direct.sample;
    }

    /// Probability of ending here rather than bouncing on: by albedo, kept away from 0 and 1.
    static float store_probability(const SurfacePoint& point, Vec3 wo, LobeMask receiving,
                                   LobeMask bouncing) {
        if (!receiving) return 0;
        if (!bouncing) return 1;
        const float store = luminance(point.bsdf->albedo(wo, receiving));
        const float bounce = luminance(point.bsdf->albedo(wo, bouncing));
        if (!(store + bounce > 0) || !std::isfinite(store + bounce)) return 0.5f;
        return std::clamp(store / (store + bounce), 0.1f, 0.9f);
    }

    void store(const SurfacePoint& point, Vec3 wo, LobeMask receiving, float store_pdf) {
        VisiblePoint& v = result_.visible_point;
        v.position = point.position;
        v.geometric_normal = point.geometric_normal;
        v.shading_normal = point.shading_normal;
        v.wo = wo;
        v.throughput = throughput_ * (1 / store_pdf);
        v.receiving = receiving;
        v.material = point.material;
        v.bsdf = point.bsdf->lambertian(v.kd) ? nullptr : point.bsdf;
        result_.footprint = camera_ray_.width + camera_ray_.spread * travelled_;
        result_.has_visible_point = refusals_.accept(v.throughput, point.material) &&
                                    refusals_.accept(v.kd, point.material);
    }

    bool bounce(const SurfacePoint& point, Vec3 wo, LobeMask mask, float choice_pdf, Vec2 u,
                float u_lobe) {
        BsdfSample sample;
        if (!point.bsdf->sample(wo, u, u_lobe, Transport::Radiance, mask, sample)) return false;
        throughput_ *= sample.weight;
        if (!refusals_.accept(throughput_, point.material) || is_black(throughput_)) return false;
        if (!refusals_.accept_density(sample.pdf, point.material) ||
            !refusals_.accept_direction(sample.wi, point.material)) {
            return false;
        }
        if (!sample.straight) {
            last_was_specular_ = sample.lobe == kSpecular || !in_.settings.direct_light_sampling;
            bounce_pdf_ = choice_pdf * sample.pdf;
            last_vertex_ = point;
            last_vertex_.bsdf = nullptr;
        }
        ray_ = continue_ray(in_.scene, point, sample.wi, sample.component, ray_);
        return true;
    }

    const EyePassInput& in_;
    const CameraRay& camera_ray_;
    const EyeNumbers& numbers_;  // at surfaces
    RandomStream& random_;       // in media
    Refusals& refusals_;
    Arena& arena_;
    std::span<Rgb> radiance_;
    const Media* media_;  // null if no medium scatters

    Ray ray_;
    Rgb throughput_ = kWhite;
    float travelled_ = 0;
    bool last_was_specular_ = true;  // the camera counts as specular: no shadow rays from it
    float bounce_pdf_ = 0;           // of the last scattering that was not straight
    SurfacePoint last_vertex_;       // where that was
    bool lamps_only_ = false;        // another way: nothing else is collected
    float lamp_share_ = 1;           // of lamps met, as other ways from smooth surfaces tell too
    std::uint32_t branches_ = 0;     // vertices from which that was so
    float beam_weights_ = 0;         // of all beams of the path
    float beam_weight_ = 0;          // of the one that is kept
    EyePathResult result_;
};

}  // namespace

EyePathResult trace_eye_path(const EyePassInput& input, const CameraRay& camera_ray,
                             const EyeNumbers& numbers, RandomStream& random, Refusals& refusals,
                             Arena& arena, std::span<Rgb> radiance) {
    return EyePath(input, camera_ray, numbers, random, refusals, arena, radiance).trace();
}

}  // namespace aips
