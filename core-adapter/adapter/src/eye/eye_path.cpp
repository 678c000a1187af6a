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
#include "sample_filter/meet_surface.h"
#include "views/surface_view.h"

namespace aips {
namespace {

/// State of an eye path between two surfaces.
class EyePath {
  public:
    EyePath(const EyePassInput& input, const CameraRay& camera_ray, const EyeNumbers& numbers,
            RandomStream& random, InvalidSampleFilter& filter, Arena& arena,
            const EyePathOutput& output)
        : in_(input),
          camera_ray_(camera_ray),
          numbers_(numbers),
          random_(random),
          filter_(filter),
          arena_(arena),
          output_(output),
          radiance_(output.radiance),
          emitters_(output.emitters.empty() ? output.radiance : LightSums{output.emitters, {}}),
          seen_(output.surface) {
        tip_.ray = camera_ray.ray;
    }

    EyePathResult trace() {
        follow(1);
        if (result_.has_beam) result_.beam.throughput *= beam_choice_.factor();
        return result_;
    }

    /// Meets emitters through specular surfaces alone; returns the rays traced.
    std::uint32_t look_for_emitters() {
        emitters_only_ = true;
        follow(1);
        return result_.rays;
    }

  private:
    /// From vertex number `depth` on.
    void follow(std::uint32_t depth) {
        for (; may_meet(in_.settings, tip_, depth - specular_); ++depth) {
            const auto mark = arena_.mark();
            SurfacePoint point;
            ++result_.rays;
            const bool met = meet_surface(in_.scene, tip_.ray, point, arena_, filter_,
                                          emitters_only_ ? Sought::Specular : Sought::All);
            if (!emitters_only_) cross_medium(point.distance, depth);
            if (point.medium_light != kNoLight) add_emitted_by_medium(point);
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
            if (result_.end.usable) {
                if (!result_.end.point.bsdf) arena_.rewind(mark);
                break;
            }
            if (!keeps_bsdf_) arena_.rewind(mark);
            keeps_bsdf_ = false;
            if (!go_on) break;
        }
    }

    /// Light that the medium scatters into the ray: of lights by a shadow ray, else by photons.
    void cross_medium(float length, std::uint32_t depth) {
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
                in_.scene, in_.direct_light, beam, tip_.ray.time, numbers_.segment(depth), filter_,
                {radiance_.of(tip_.seen_by.scattered_in()), output_.light});
        if (in_.keep_visible_points) keep(beam);
    }

    /// Keeps one of the path's beams, chosen by what it may scatter.
    void keep(const VolumeBeam& beam) {
        const Rgb passed = transmittance(media_->extinction(beam.medium), beam.length);
        const float weight = luminance(beam.throughput * (kWhite - passed));
        if (!(weight > 0) || !filter_.accept(beam.throughput, kPassageOrigin)) return;
        if (!beam_choice_.takes(weight, [&] { return random_.next(); })) return;
        result_.has_beam = true;
        result_.beam = beam;
        result_.beam.medium = media_->alone(beam.medium);
        result_.beam_footprint =
            camera_ray_.width + camera_ray_.spread * (travelled_ + 0.5f * beam.length);
    }

    /// Of emitters that were met.
    void add(const Rgb& value, LightIndex light) {
        if (emitters_only_ && !behind_specular_) return;
        const LightTarget sums = (behind_specular_ ? emitters_ : radiance_).of(tip_.seen_by.met());
        const std::uint32_t group = in_.scene.lights()[light]->group();
        if (sums.add(group, value, filter_.of_light(light), filter_))
            tell(behind_specular_ ? emitter_light_ : output_.light, light, luminance(value));
    }

    void add_emitted(const SurfacePoint& point) {
        if (point.light == kNoLight || is_black(point.emitted)) return;
        const float weight = emitter_share_ * emission_weight(in_, tip_, point.light, &point);
        add(tip_.throughput * point.emitted * weight, point.light);
    }

    /// Of the medium that the ray crosses.
    void add_emitted_by_medium(const SurfacePoint& point) {
        const float weight =
            emitter_share_ * emission_weight(in_, tip_, point.medium_light, nullptr);
        add(tip_.throughput * point.medium_emitted * weight, point.medium_light);
    }

    void add_escaped() {
        if (tip_.from_specular && !in_.settings.include_environment) return;
        for_each_escaped(in_, tip_, filter_, [&](LightIndex light, const Rgb& seen) {
            const float weight = emitter_share_ * emission_weight(in_, tip_, light, nullptr);
            add(tip_.throughput * seen * weight, light);
        });
    }

    /// Direct light, then either a visible point or a bounce. False when the path ends.
    bool scatter(const SurfacePoint& point, std::uint32_t depth) {
        const DepthLimit limit = eye_depth(in_.settings);
        const VertexNumbers numbers = numbers_.vertex(depth);
        const Vec3 wo = -tip_.ray.direction;
        const LobeMask lobes = point.bsdf->lobes();
        const std::uint32_t counted = depth - specular_;
        const bool passes_specular = lobes == kSpecular && specular_ < limit.specular;
        if (passes_specular) ++specular_;
        if (is_spent(in_.settings, tip_))
            return go_straight(in_, point, wo, numbers, filter_, tip_);
        const bool last = counted >= limit.surfaces && !passes_specular;
        if (counted > limit.surfaces || (last && lobes == kSpecular)) {
            const bool passes = pass_straight(in_, point, wo, numbers, filter_, tip_);
            result_.cut = !passes && lobes == kSpecular;
            return passes;
        }
        if (lobes == kSpecular) {
            behind_specular_ = true;
            const Vec2 u = numbers.direction();
            const float u_lobe = choose_way(point, wo, numbers, depth);
            return bounce(in_, point, wo, {kSpecular, 1, u, u_lobe}, filter_, tip_);
        }
        if (emitters_only_) return false;
        emitter_share_ = 1;
        branches_ = kMostBranches;
        emitters_ = radiance_;
        emitter_light_ = output_.light;
        const LobeMask receiving = lobes & receiving_lobes(in_.settings);
        const LobeMask bouncing = lobes & ~receiving;
        LobeMask onward = bouncing;
        if (last) onward &= tip_.counts_in_full ? LobeMask{} : kSpecular;
        const PointGloss gloss = last ? PointGloss{} : gloss_at(point, wo, bouncing);
        const bool takes_gloss = gloss.bounce != 0;
        // Once photons are gathered beside the bounce, whatever the path does; at later surfaces
        // it chooses, and so for indirect light alone where it may end anyway.
        const bool beside =
            takes_gloss && !result_.before.usable && (!receiving || asks_for_caustics(gloss));
        float store_pdf = store_probability(*point.bsdf, wo, receiving, onward);
        if (takes_gloss && !beside && !receiving) store_pdf = kLaterGloss;
        const bool may = receiving && in_.shares && in_.keep_visible_points;
        EyeShare eye;
        if (may) eye = in_.shares->at(point.position, normal_towards(wo, point));
        // The BSDF-sampled ray from the visible point shares the lights with shadow rays.
        const DiscPlace place = may ? ask_disc(point, wo, receiving, eye) : DiscPlace::NotAsked;
        const bool fills =
            place == DiscPlace::Gap && in_.gaps->lost_share(output_.film) >= eye.fills_from;
        const bool goes_on = may && (eye.any() || output_.explores || fills);
        DirectLightResult direct;
        if (in_.settings.direct_light_sampling && (lobes & kNonSpecular)) {
            DirectLightQuery query{point, wo, tip_.ray.time, tip_.scattered_throughput()};
            query.owned = receiving;
            query.owned_pdf = goes_on ? store_pdf : 0;
            query.bounce = bouncing;
            query.shared = bouncing & kNonSpecular;
            query.continue_pdf = last ? 0 : 1 - store_pdf;
            direct = estimate_direct_light(query, numbers);
        }
        const bool ends = store_pdf == 1 || (store_pdf > 0 && numbers.end() < store_pdf);
        if (beside || ends) {
            if (!in_.keep_visible_points) return false;
            const LobeMask taking = takes_gloss ? LobeMask(receiving | kGlossy) : receiving;
            PathPoint& at = ends ? result_.end : result_.before;
            store(point, wo, taking, beside ? 1 : store_pdf, at);
            VisiblePoint& v = at.point;
            v.gloss = gloss;
            v.gloss.bounce_pdf = 1 - store_pdf;
            v.bounced = !ends;
            v.place = place;
            if (goes_on) v.eye_share = eye.share;
        }
        if (ends) {
            result_.end.point.fills = fills;
            if (result_.end.usable && goes_on)
                go_on_from({point, wo, receiving, depth, store_pdf, tip_}, direct);
            return false;
        }
        if (!onward) return false;
        tip_.throughput *= 1 / (1 - store_pdf);
        if (last) return pass_straight(in_, point, wo, numbers, filter_, tip_);
        const BounceDraw draw{bouncing, 1 - store_pdf, numbers.direction(), numbers.lobe(),
                              gloss.photons};
        return bounce(in_, point, wo, draw, filter_, tip_);
    }

    /// How glossy lobes among those that bounce take photons.
    PointGloss gloss_at(const SurfacePoint& point, Vec3 wo, LobeMask bouncing) const {
        if (!(bouncing & kGlossy) || !in_.shares || !in_.settings.caustics_on_gloss ||
            !in_.keep_visible_points)
            return {};
        const bool later = result_.before.usable;
        PointGloss gloss;
        if (!later) gloss.photons = in_.shares->gloss_at(point.position, normal_towards(wo, point));
        gloss.learns = !later && output_.learns_gloss && asks_for_caustics(gloss);
        if (gloss.photons.any() || asks_for_caustics(gloss)) gloss.bounce = bouncing;
        return gloss;
    }

    /// Whether photons bring caustics to a glossy lobe, or are to tell whether they should.
    bool asks_for_caustics(const PointGloss& gloss) const {
        const bool tells = output_.learns_gloss && output_.explores && !result_.before.usable;
        return gloss.photons.caustics > 0 || tells || in_.shares->gloss_needs_photons;
    }

    /// The number that decides between the ways that a specular surface offers.
    float choose_way(const SurfacePoint& point, Vec3 wo, const VertexNumbers& numbers,
                     std::uint32_t depth) {
        const float u_lobe = numbers.lobe();
        const float first = point.bsdf->first_specular(wo);
        if (!(first > 0 && first < 1)) return u_lobe;
        if (branches_ < kMostBranches && !media_) {
            look_the_other_way(point, wo, {first, u_lobe, numbers.direction()}, depth);
        } else if (in_.emitters && choices_ < std::tuple_size_v<SpecularChoices>) {
            return numbers_.choice(choices_++);
        }
        return u_lobe;
    }

    /// Of the two ways that a specular surface offers the path takes one. Emitters seen by specular
    /// surfaces alone are looked for by the other way too, and count each way by its share: by
    /// chance alone one path in 25 would meet the emitter that a glass reflects, with all its
    /// light. Beside emitter paths both ways go on to look both ways: what is met is to depend on
    /// no number but film position and choices.
    void look_the_other_way(const SurfacePoint& point, Vec3 wo, const TwoWays& ways,
                            std::uint32_t depth) {
        ++branches_;
        EyePath other(*this);
        other.emitters_only_ = true;
        other.seen_ = {};
        other.result_ = {};
        if (!in_.emitters) other.branches_ = kMostBranches;
        other.emitter_share_ *= ways.other_share();
        emitter_share_ *= ways.share();
        if (bounce(in_, point, wo, {kSpecular, 1, ways.u, ways.other()}, filter_, other.tip_))
            other.follow(depth + 1);
        result_.rays += other.result_.rays;
    }

    DirectLightResult estimate_direct_light(const DirectLightQuery& query,
                                            const VertexNumbers& numbers) {
        const DirectLightResult direct = in_.direct_light.estimate(
            query, numbers, filter_, radiance_.of(tip_.seen_by.scattered_in()));
        result_.rays += direct.rays;
        tell(output_.light, direct.sample.light, direct.brought);
        if (in_.direct_light.learns() && result_.light_sample.pdf == 0)
            result_.light_sample = direct.sample;
        return direct;
    }

    /// The path goes on from its visible point, or its BSDF-sampled ray alone does.
    void go_on_from(ContinuedStart start, const DirectLightResult& direct) {
        VisiblePoint& v = result_.end.point;
        start.tip.throughput *= 1 / start.choice_pdf;
        start.bsdf_direct = !(v.eye_share > 0 || output_.explores || v.fills);
        const bool asks = direct.sample.pdf > 0;
        if (asks) start.asked = direct.sample.light;
        const ContinuedResult went = trace_continued_path(
            in_, start, numbers_, filter_, arena_,
            {radiance_, output_.continued, output_.light, v.continued_share()});
        v.continued = v.eye_share > 0 || output_.explores;
        v.eye_rays = float(went.rays);
        result_.rays += went.rays;
        v.direct = {direct.alone, direct.brought, went.straight,
                    asks ? went.of_asked / direct.sample.pdf : 0, start.choice_pdf};
    }

    /// A place in the gather disc, where photons are known to lose light and it may be filled.
    DiscPlace ask_disc(const SurfacePoint& point, Vec3 wo, LobeMask receiving,
                       const EyeShare& eye) {
        if (!in_.gaps || !eye.may_fill() || in_.gaps->lost_share(output_.film) < 0)
            return DiscPlace::NotAsked;
        const VisiblePoint there = visible_point(point, wo, receiving, kWhite, {});
        const bool lost =
            in_.gaps->loses(there, output_.film, tip_.ray.time, random_, arena_, result_.rays);
        return lost ? DiscPlace::Gap : DiscPlace::Surface;
    }

    /// Photons are gathered for lobes `receiving`, by a choice of this probability.
    void store(const SurfacePoint& point, Vec3 wo, LobeMask receiving, float choice_pdf,
               PathPoint& at) {
        VisiblePoint& v = at.point;
        v = visible_point(point, wo, receiving, tip_.scattered_throughput() * (1 / choice_pdf),
                          tip_.seen_by);
        v.photon_bounces = photon_bounces(in_.settings, tip_);
        at.footprint = camera_ray_.width + camera_ray_.spread * travelled_;
        at.usable =
            filter_.accept(v.throughput, point.material) && filter_.accept(v.kd, point.material);
        keeps_bsdf_ = at.usable;
    }

    const EyePassInput& in_;
    const CameraRay& camera_ray_;
    const EyeNumbers& numbers_;  // at surfaces
    RandomStream& random_;       // in media
    InvalidSampleFilter& filter_;
    Arena& arena_;
    const EyePathOutput& output_;
    LightSums radiance_, emitters_;
    LuminanceByLight* emitter_light_ = output_.emitter_light;  // null: not asked for
    SurfaceView seen_;
    const Media* media_ = in_.scene.media();  // null if no medium scatters

    PathTip tip_;
    float travelled_ = 0;
    bool emitters_only_ = false;    // nothing else is collected
    bool behind_specular_ = false;  // some surface was specular
    float emitter_share_ = 1;     // of emitters met, as other ways from specular surfaces tell too
    std::uint32_t specular_ = 0;  // surfaces met that do not count for the depth, being specular
    std::uint32_t branches_ = 0;  // vertices from which that was so
    bool keeps_bsdf_ = false;     // the surface just left is a visible point
    std::size_t choices_ = 0;     // used at specular surfaces beyond these
    BeamChoice beam_choice_;
    EyePathResult result_;
};

}  // namespace

EyePathResult trace_eye_path(const EyePassInput& input, const CameraRay& camera_ray,
                             const EyeNumbers& numbers, RandomStream& random,
                             InvalidSampleFilter& filter, Arena& arena,
                             const EyePathOutput& output) {
    return EyePath(input, camera_ray, numbers, random, filter, arena, output).trace();
}

std::uint32_t trace_emitter_path(const EyePassInput& input, const CameraRay& camera_ray,
                                 const EyeNumbers& numbers, RandomStream& random,
                                 InvalidSampleFilter& filter, Arena& arena, std::span<Rgb> emitters,
                                 LuminanceByLight* light) {
    return EyePath(input, camera_ray, numbers, random, filter, arena,
                   {.emitters = emitters, .emitter_light = light})
        .look_for_emitters();
}

}  // namespace aips
