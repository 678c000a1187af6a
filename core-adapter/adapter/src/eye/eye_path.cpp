// One eye path: bounces through the lobes that do not take photons, ends at one that does. Which
// strategy owns which class of paths is tabulated in docs/understand/who-carries-which-light.md.
#include "eye/eye_path.h"

#include <tuple>

#include "eye/constants.h"
#include "eye/continued_path.h"
#include "eye/disc_gaps.h"
#include "eye/store_probability.h"
#include "eye/surface_normals.h"
#include "eye/two_ways.h"
#include "eye/volume_light.h"
#include "refusal/meet_surface.h"
#include "views/surface_view.h"

namespace aips {
namespace {

/// State of an eye path between two surfaces.
class EyePath {
  public:
    EyePath(const EyePassInput& input, const CameraRay& camera_ray, const EyeNumbers& numbers,
            RandomStream& random, Refusals& refusals, Arena& arena, const EyePathOutput& output)
        : in_(input),
          camera_ray_(camera_ray),
          numbers_(numbers),
          random_(random),
          refusals_(refusals),
          arena_(arena),
          output_(output),
          radiance_(output.radiance),
          lamps_(output.lamps.empty() ? output.radiance : LightSums{output.lamps, {}}),
          seen_(output.surface) {
        tip_.ray = camera_ray.ray;
    }

    EyePathResult trace() {
        follow(1);
        if (result_.has_beam) result_.beam.throughput *= beam_choice_.factor();
        return result_;
    }

    /// Meets lamps through smooth surfaces alone; returns the rays traced.
    std::uint32_t look_for_lamps() {
        lamps_only_ = true;
        follow(1);
        return result_.rays;
    }

  private:
    /// From vertex number `depth` on.
    void follow(std::uint32_t depth) {
        for (; may_meet(in_.settings, tip_, depth - smooth_); ++depth) {
            const auto mark = arena_.mark();
            SurfacePoint point;
            ++result_.rays;
            const bool met = meet_surface(in_.scene, tip_.ray, point, arena_, refusals_,
                                          lamps_only_ ? Sought::Smooth : Sought::All);
            if (!lamps_only_) cross_medium(point.distance);
            tip_.throughput *= point.transmittance;
            if (!met) {
                add_escaped();
                break;
            }
            travelled_ += point.distance;
            add_emitted(point);
            if (seen_.wanted())
                seen_.meet(point, tip_.ray.direction, tip_.throughput,
                           camera_ray_.depth_at(travelled_));
            const bool go_on = point.bsdf && scatter(point, depth);
            if (seen_.wanted() && go_on) seen_.leave(tip_.ray.direction, tip_.throughput);
            if (result_.has_visible_point) {
                if (!result_.visible_point.bsdf) arena_.rewind(mark);
                break;
            }
            arena_.rewind(mark);
            if (!go_on) break;
        }
    }

    /// Light that the medium scatters into the ray: of lights by a shadow ray, else by photons.
    void cross_medium(float length) {
        if (!media_ || !media_->scatters(tip_.ray.medium) || !(length > 0)) return;
        if (is_spent(in_.settings, tip_)) return;
        const VolumeBeam beam{.origin = tip_.ray.origin,
                              .direction = tip_.ray.direction,
                              .length = length,
                              .medium = tip_.ray.medium,
                              .throughput = tip_.throughput,
                              .scatterings = tip_.seen_by,
                              .photon_bounces = photon_bounces(in_.settings, tip_)};
        if (in_.settings.direct_light_sampling)
            result_.rays += estimate_scattered_light(
                in_.scene, in_.direct_light, beam, tip_.ray.time, random_, refusals_,
                {radiance_.of(tip_.seen_by.scattered_in()), output_.light});
        if (in_.keep_visible_points) keep(beam);
    }

    /// Keeps one of the path's beams, chosen by what it may scatter.
    void keep(const VolumeBeam& beam) {
        const Rgb passed = transmittance(media_->extinction(beam.medium), beam.length);
        const float weight = luminance(beam.throughput * (kWhite - passed));
        if (!(weight > 0) || !refusals_.accept(beam.throughput, kPassageOrigin)) return;
        if (!beam_choice_.takes(weight, [&] { return random_.next(); })) return;
        result_.has_beam = true;
        result_.beam = beam;
        result_.beam.medium = media_->alone(beam.medium);
        result_.beam_footprint =
            camera_ray_.width + camera_ray_.spread * (travelled_ + 0.5f * beam.length);
    }

    /// Of lamps that were met.
    void add(const Rgb& value, LightIndex light) {
        if (lamps_only_ && !behind_smooth_) return;
        const LightTarget sums = (behind_smooth_ ? lamps_ : radiance_).of(tip_.seen_by.met());
        const std::uint32_t group = in_.scene.lights()[light]->group();
        if (sums.add(group, value, refusals_.of_light(light), refusals_))
            tell(behind_smooth_ ? lamp_light_ : output_.light, light, luminance(value));
    }

    void add_emitted(const SurfacePoint& point) {
        if (point.light == kNoLight || is_black(point.emitted)) return;
        const float weight = lamp_share_ * emission_weight(in_, tip_, point.light, &point);
        add(tip_.throughput * point.emitted * weight, point.light);
    }

    void add_escaped() {
        if (tip_.from_smooth && !in_.settings.include_environment) return;
        for_each_escaped(in_, tip_, refusals_, [&](LightIndex light, const Rgb& seen) {
            const float weight = lamp_share_ * emission_weight(in_, tip_, light, nullptr);
            add(tip_.throughput * seen * weight, light);
        });
    }

    /// Direct light, then either a visible point or a bounce. False when the path ends.
    bool scatter(const SurfacePoint& point, std::uint32_t depth) {
        const DepthLimit limit = eye_depth(in_.settings);
        const VertexNumbers numbers = numbers_.vertex(depth);
        const Vec3 wo = -tip_.ray.direction;
        const LobeMask lobes = point.bsdf->lobes();
        const std::uint32_t counted = depth - smooth_;
        const bool passes_smooth = lobes == kSpecular && smooth_ < limit.smooth;
        if (passes_smooth) ++smooth_;
        if (is_spent(in_.settings, tip_))
            return go_straight(in_, point, wo, numbers, refusals_, tip_);
        const bool last = counted >= limit.surfaces && !passes_smooth;
        if (counted > limit.surfaces || (last && lobes == kSpecular)) {
            const bool passes = pass_straight(in_, point, wo, numbers, refusals_, tip_);
            result_.cut = !passes && lobes == kSpecular;
            return passes;
        }
        if (lobes == kSpecular) {
            behind_smooth_ = true;
            const Vec2 u = numbers.direction();
            const float u_lobe = choose_way(point, wo, numbers, depth);
            return bounce(in_, point, wo, {kSpecular, 1, u, u_lobe}, refusals_, tip_);
        }
        if (lamps_only_) return false;
        lamp_share_ = 1;
        branches_ = kMostBranches;
        lamps_ = radiance_;
        lamp_light_ = output_.light;
        const LobeMask receiving = lobes & receiving_lobes(in_.settings);
        const LobeMask bouncing = lobes & ~receiving;
        LobeMask onward = bouncing;
        if (last) onward &= tip_.counts_in_full ? LobeMask{} : kSpecular;
        const float store_pdf = store_probability(*point.bsdf, wo, receiving, onward);
        const bool may = receiving && in_.shares && in_.keep_visible_points;
        EyeShare eye;
        if (may) eye = in_.shares->at(point.position, normal_towards(wo, point));
        // The first ray from the visible point shares the lights with shadow rays.
        const DiscPlace place = may ? ask_disc(point, wo, receiving, eye) : DiscPlace::NotAsked;
        const bool fills =
            place == DiscPlace::Gap && in_.gaps->lost_share(output_.film) >= eye.fills_from;
        const bool goes_on = may && (eye.any() || output_.explores || fills);
        DirectLightResult direct;
        if (in_.settings.direct_light_sampling && (lobes & kNonSpecular)) {
            DirectLightQuery query{point, wo, tip_.ray.time, tip_.throughput};
            query.owned = receiving;
            query.owned_pdf = goes_on ? store_pdf : 0;
            query.bounce = bouncing;
            query.shared = bouncing & kNonSpecular;
            query.continue_pdf = last ? 0 : 1 - store_pdf;
            direct = estimate_direct_light(query, numbers);
        }
        if (receiving && (store_pdf == 1 || numbers.end() < store_pdf)) {
            if (!in_.keep_visible_points) return false;
            store(point, wo, receiving, store_pdf);
            result_.visible_point.place = place;
            result_.visible_point.fills = fills;
            if (result_.has_visible_point && goes_on) {
                result_.visible_point.eye_share = eye.share;
                go_on_from({point, wo, receiving, depth, store_pdf, tip_}, direct);
            }
            return false;
        }
        if (!onward) return false;
        tip_.throughput *= 1 / (1 - store_pdf);
        if (last) return pass_straight(in_, point, wo, numbers, refusals_, tip_);
        const BounceDraw draw{bouncing, 1 - store_pdf, numbers.direction(), numbers.lobe()};
        return bounce(in_, point, wo, draw, refusals_, tip_);
    }

    /// The number that decides between the ways that a smooth surface offers.
    float choose_way(const SurfacePoint& point, Vec3 wo, const VertexNumbers& numbers,
                     std::uint32_t depth) {
        const float u_lobe = numbers.lobe();
        const float first = point.bsdf->first_specular(wo);
        if (!(first > 0 && first < 1)) return u_lobe;
        if (branches_ < kMostBranches && !media_) {
            look_the_other_way(point, wo, {first, u_lobe, numbers.direction()}, depth);
        } else if (in_.lamps && choices_ < std::tuple_size_v<SmoothChoices>) {
            return numbers_.choice(choices_++);
        }
        return u_lobe;
    }

    /// Of the two ways that a smooth surface offers the path takes one. Lamps seen by smooth
    /// surfaces alone are looked for by the other way too, and count each way by its share: by
    /// chance alone one path in 25 would meet the lamp that a glass reflects, with all its light.
    /// Beside lamp paths both ways go on to look both ways: what is met is to depend on no number
    /// but film position and choices.
    void look_the_other_way(const SurfacePoint& point, Vec3 wo, const TwoWays& ways,
                            std::uint32_t depth) {
        ++branches_;
        EyePath other(*this);
        other.lamps_only_ = true;
        other.seen_ = {};
        other.result_ = {};
        if (!in_.lamps) other.branches_ = kMostBranches;
        other.lamp_share_ *= ways.other_share();
        lamp_share_ *= ways.share();
        if (bounce(in_, point, wo, {kSpecular, 1, ways.u, ways.other()}, refusals_, other.tip_))
            other.follow(depth + 1);
        result_.rays += other.result_.rays;
    }

    DirectLightResult estimate_direct_light(const DirectLightQuery& query,
                                            const VertexNumbers& numbers) {
        const DirectLightResult direct = in_.direct_light.estimate(
            query, numbers, refusals_, radiance_.of(tip_.seen_by.scattered_in()));
        result_.rays += direct.rays;
        tell(output_.light, direct.sample.light, direct.brought);
        if (in_.direct_light.learns() && result_.light_sample.pdf == 0)
            result_.light_sample = direct.sample;
        return direct;
    }

    /// The path goes on from its visible point, or its first ray alone does.
    void go_on_from(ContinuedStart start, const DirectLightResult& direct) {
        VisiblePoint& v = result_.visible_point;
        start.tip.throughput = v.throughput;
        start.first_ray = !(v.eye_share > 0 || output_.explores || v.fills);
        const bool asks = direct.sample.pdf > 0;
        if (asks) start.asked = direct.sample.light;
        const ContinuedResult went = trace_continued_path(
            in_, start, numbers_, refusals_, arena_,
            {radiance_, output_.continued, output_.light, v.continued_share()});
        v.continued = v.eye_share > 0 || output_.explores;
        v.eye_rays = float(went.rays);
        result_.rays += went.rays;
        v.direct = {direct.alone, direct.brought, went.straight,
                    asks ? went.of_asked / direct.sample.pdf : 0, start.choice_pdf};
    }

    /// A place in the search disc, where photons are known to lose light and it may be filled.
    DiscPlace ask_disc(const SurfacePoint& point, Vec3 wo, LobeMask receiving,
                       const EyeShare& eye) {
        if (!in_.gaps || !eye.may_fill() || in_.gaps->lost_share(output_.film) < 0)
            return DiscPlace::NotAsked;
        const VisiblePoint there = visible_point(point, wo, receiving, kWhite, {});
        const bool lost =
            in_.gaps->loses(there, output_.film, tip_.ray.time, random_, arena_, result_.rays);
        return lost ? DiscPlace::Gap : DiscPlace::Surface;
    }

    void store(const SurfacePoint& point, Vec3 wo, LobeMask receiving, float store_pdf) {
        VisiblePoint& v = result_.visible_point;
        v = visible_point(point, wo, receiving, tip_.throughput * (1 / store_pdf), tip_.seen_by);
        v.photon_bounces = photon_bounces(in_.settings, tip_);
        result_.footprint = camera_ray_.width + camera_ray_.spread * travelled_;
        result_.has_visible_point = refusals_.accept(v.throughput, point.material) &&
                                    refusals_.accept(v.kd, point.material);
    }

    const EyePassInput& in_;
    const CameraRay& camera_ray_;
    const EyeNumbers& numbers_;  // at surfaces
    RandomStream& random_;       // in media
    Refusals& refusals_;
    Arena& arena_;
    const EyePathOutput& output_;
    LightSums radiance_, lamps_;
    LuminanceByLight* lamp_light_ = output_.lamp_light;  // null: not asked for
    SurfaceView seen_;
    const Media* media_ = in_.scene.media();  // null if no medium scatters

    PathTip tip_;
    float travelled_ = 0;
    bool lamps_only_ = false;     // nothing else is collected
    bool behind_smooth_ = false;  // some surface was smooth
    float lamp_share_ = 1;        // of lamps met, as other ways from smooth surfaces tell too
    std::uint32_t smooth_ = 0;    // surfaces met that do not count for the depth, being smooth
    std::uint32_t branches_ = 0;  // vertices from which that was so
    std::size_t choices_ = 0;     // used at smooth surfaces beyond these
    BeamChoice beam_choice_;
    EyePathResult result_;
};

}  // namespace

EyePathResult trace_eye_path(const EyePassInput& input, const CameraRay& camera_ray,
                             const EyeNumbers& numbers, RandomStream& random, Refusals& refusals,
                             Arena& arena, const EyePathOutput& output) {
    return EyePath(input, camera_ray, numbers, random, refusals, arena, output).trace();
}

std::uint32_t trace_lamp_path(const EyePassInput& input, const CameraRay& camera_ray,
                              const EyeNumbers& numbers, RandomStream& random, Refusals& refusals,
                              Arena& arena, std::span<Rgb> lamps, LuminanceByLight* light) {
    return EyePath(input, camera_ray, numbers, random, refusals, arena,
                   {.lamps = lamps, .lamp_light = light})
        .look_for_lamps();
}

}  // namespace aips
