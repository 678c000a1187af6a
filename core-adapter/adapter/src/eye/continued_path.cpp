// Path tracing from a visible point on.
#include "eye/continued_path.h"

#include <algorithm>
#include <cmath>

#include "eye/constants.h"
#include "sample_filter/meet_surface.h"

namespace aips {
namespace {

class ContinuedPath {
  public:
    ContinuedPath(const EyePassInput& input, const ContinuedStart& start, const EyeNumbers& numbers,
                  InvalidSampleFilter& filter, Arena& arena, const ContinuedOutput& output)
        : in_(input),
          start_(start),
          numbers_(numbers),
          filter_(filter),
          arena_(arena),
          output_(output),
          tip_(start.tip) {}

    ContinuedResult trace() {
        const VertexNumbers first = numbers_.vertex(start_.depth);
        const float before = max_component(tip_.throughput);
        const BounceDraw draw{start_.receiving, start_.choice_pdf, first.direction(), first.lobe()};
        if (!bounce(in_, start_.point, start_.wo, draw, filter_, tip_)) return result_;
        for (std::uint32_t n = 1;; ++n) {
            const auto mark = arena_.mark();
            const VertexNumbers numbers = numbers_.vertex(start_.depth + n);
            const std::uint32_t scatterings = tip_.scatterings;
            const bool goes_on = meet(numbers) && (!start_.bsdf_direct || straight()) &&
                                 survives(n, before, numbers.end());
            arena_.rewind(mark);
            if (!goes_on || !may_meet_next(n, tip_.scatterings == scatterings)) break;
        }
        return result_;
    }

  private:
    /// A photon that lands at the visible point after n surfaces that count met the n - 1 others
    /// here.
    bool photons_meet(std::uint32_t n) const { return n < limit_.surfaces; }

    /// After n surfaces. Beyond those that photons meet a ray that flies straight on still brings
    /// what shadow rays have left to it, as the first one does.
    bool may_meet_next(std::uint32_t n, bool flies_on) const {
        return photons_meet(counted_ + 1) || (flies_on && n + 1 < kMostStraightSurfaces);
    }

    /// The next surface: its light, what lights send there, and the way on; false at the path's
    /// end.
    bool meet(const VertexNumbers& numbers) {
        SurfacePoint point;
        ++result_.rays;
        const bool met = meet_surface(in_.scene, tip_.ray, point, arena_, filter_);
        if (point.medium_light != kNoLight)
            add_light(point.medium_light, point.medium_emitted, nullptr);
        tip_.throughput *= point.transmittance;
        if (!met) {
            for_each_escaped(in_, tip_, filter_, [&](LightIndex light, const Rgb& seen) {
                add_light(light, seen, nullptr);
            });
            return false;
        }
        if (point.light != kNoLight && !is_black(point.emitted))
            add_light(point.light, point.emitted, &point);
        if (!point.bsdf) return false;
        const Vec3 wo = -tip_.ray.direction;
        const LobeMask lobes = point.bsdf->lobes();
        if (lobes == kSpecular && specular_ < limit_.specular) {
            ++specular_;
        } else {
            ++counted_;
        }
        if (is_spent(in_.settings, tip_))
            return go_straight(in_, point, wo, numbers, filter_, tip_);
        const bool asks = photons_meet(counted_) && !start_.bsdf_direct;
        if (const LobeMask shared = asks ? lobes & kNonSpecular : 0) {
            DirectLightQuery query{point, wo, tip_.ray.time, tip_.throughput};
            query.shared = shared;
            query.bounce = lobes;
            query.continue_pdf = photons_meet(counted_ + 1) ? 1.0f : 0.0f;
            const DirectLightResult direct =
                in_.direct_light.estimate(query, numbers, filter_, {output_.continued});
            result_.rays += direct.rays;
            tell(output_.light, direct.sample.light, output_.share * direct.brought);
        }
        return go_on(point, wo, lobes, numbers);
    }

    bool go_on(const SurfacePoint& point, Vec3 wo, LobeMask lobes, const VertexNumbers& numbers) {
        return bounce(in_, point, wo, {lobes, 1, numbers.direction(), numbers.lobe()}, filter_,
                      tip_);
    }

    /// Whether the path still flies as it left the visible point.
    bool straight() const { return tip_.scatterings == start_.tip.scatterings + 1; }

    /// Light that the path's ray meets, coming straight from the visible point, or from a surface
    /// beyond that scattered it.
    void add_light(LightIndex light, const Rgb& seen, const SurfacePoint* at) {
        if (!straight() && tip_.counts_in_full) return;
        const LightTarget sums =
            straight() ? output_.direct.of(tip_.seen_by.met()) : LightTarget{output_.continued};
        const Rgb value = tip_.throughput * seen * emission_weight(in_, tip_, light, at);
        const bool added =
            sums.add(in_.scene.lights()[light]->group(), value, filter_.of_light(light), filter_);
        if (added) tell(output_.light, light, (straight() ? 1 : output_.share) * luminance(value));
        if (!straight()) return;
        result_.straight += luminance(value);
        if (light == start_.asked) result_.of_asked += luminance(value);
    }

    /// By the root of what is left of the throughput: by all of it, paths would end where what they
    /// bring still is a good part of the noise.
    bool survives(std::uint32_t n, float before, float u) {
        if (n < kContinuedRouletteFrom) return true;
        const float left = std::min(1.0f, max_component(tip_.throughput) / before);
        const float probability = std::sqrt(left);
        if (!(u < probability)) return false;
        tip_.throughput *= 1 / probability;
        return true;
    }

    const EyePassInput& in_;
    const ContinuedStart& start_;
    const EyeNumbers& numbers_;
    InvalidSampleFilter& filter_;
    Arena& arena_;
    const ContinuedOutput& output_;
    const DepthLimit limit_ = photon_depth(in_.settings);
    PathTip tip_;
    std::uint32_t counted_ = 0;   // surfaces met that count for the depth
    std::uint32_t specular_ = 0;  // those that do not, being specular
    ContinuedResult result_;
};

}  // namespace

ContinuedResult trace_continued_path(const EyePassInput& input, const ContinuedStart& start,
                                     const EyeNumbers& numbers, InvalidSampleFilter& filter,
                                     Arena& arena, const ContinuedOutput& output) {
    return ContinuedPath(input, start, numbers, filter, arena, output).trace();
}

}  // namespace aips
