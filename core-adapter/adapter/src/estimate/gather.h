// Density estimation: photons around each visible point.
#pragma once

#include <span>
#include <vector>

#include "aips/core/photon_map/photon_grid.h"
#include "aips/core/radii/optimal_radius.h"
#include "aips/core/sampling/sampling.h"
#include "base/assign_all.h"
#include "estimate/gather_radii.h"
#include "estimate/photon_occlusion.h"
#include "eye/eye_pass.h"
#include "ranks/shared_work.h"
#include "sample_filter/invalid_sample_filter.h"

namespace aips {

/// The part of a visible point's flux that eye paths could carry as well: luminances of it as it
/// is counted, without the share that they do carry.
struct ShareableFlux {
    float sum = 0;
    float squares = 0;  ///< of single photons'
};

/// What photons told of caustics on a visible point's glossy lobes that bounce as well: luminances.
struct GlossyFlux {
    float light = 0;
    float photons = 0;  ///< squares of what single photons brought
    float bounce = 0;   ///< variance of a bounce that brings it all

    void scale(float factor);
};

/// What gathers have done so far.
struct GatherCounts {
    std::uint64_t photons = 0;  ///< accepted, over all visible points
    std::uint64_t rays = 0;     ///< that asked what separates them
};

/// What photons have brought to the visible points of a pass so far.
struct PhotonFlux {
    /// [visible point * groups + group]: sum over photons within the radius of f * power (watts per
    /// steradian), f being left out for Lambertian points (it is constant there).
    std::vector<Rgb> flux;
    /// [visible point]: photons accepted, over all light groups; 2^32 - 1 stands for more. One that
    /// brings no light, be it refused or absorbed, is not accepted.
    std::vector<std::uint32_t> accepted;
    /// [visible point]: sum over these photons of the squared luminance of what flux sums.
    std::vector<float> squares;
    std::vector<ShareableFlux> shareable;  ///< [visible point]; empty if nobody asks for it
    std::vector<GlossyFlux> glossy;        ///< [visible point]: of those that learn; empty likewise
    /// [visible point * kPhotonParts + ImagePart]: what is direct light or caustics of `flux`, over
    /// all light groups; empty if not wanted.
    std::vector<Rgb> parts;
    /// [visible point]: of `flux`, over all light groups, what the inner half of the disc's area
    /// brought; empty if not wanted. Edges have a factor of their own there.
    std::vector<Rgb> inner;
    std::vector<ProbeSums> probes;  ///< [number in GatherRadii::probes]
    GatherCounts counts;

    std::size_t most_points = 0;   ///< visible points of any pass, if that is known
    bool wants_parts = false;      ///< whether gathers fill `parts`
    bool wants_inner = false;      ///< whether gathers fill `inner`
    bool wants_bias = false;       ///< and those in media the inner half of beams' sections
    bool wants_shareable = false;  ///< whether gathers fill `shareable`
    bool wants_glossy = false;     ///< whether they fill `glossy`

    void reset(std::size_t visible_points, std::uint32_t groups, std::size_t probe_count = 0) {
        assign_all(flux, visible_points * groups, Rgb{}, most_points * groups);
        assign_all(accepted, visible_points, std::uint32_t{0}, most_points);
        assign_all(squares, visible_points, 0.0f, most_points);
        assign_all(shareable, wants_shareable ? visible_points : 0, ShareableFlux{}, most_points);
        assign_all(glossy, wants_glossy ? visible_points : 0, GlossyFlux{}, most_points);
        assign_all(parts, wants_parts ? visible_points * kPhotonParts : 0, Rgb{},
                   most_points * kPhotonParts);
        assign_all(inner, wants_inner ? visible_points : 0, Rgb{}, most_points);
        assign_all(probes, probe_count, ProbeSums{}, most_points);
        counts = {};
    }
    /// Multiplies all that was brought.
    void scale(double factor);
    /// Multiplies all that was brought to one visible point, of `groups` light groups. Probes and
    /// `inner` are left as they are.
    void scale_point(std::size_t point, std::uint32_t groups, float factor) {
        for (std::size_t g = 0; g < groups; ++g)
            flux[point * groups + g] *= factor;
        squares[point] *= factor * factor;
        if (!shareable.empty()) {
            shareable[point].sum *= factor;
            shareable[point].squares *= factor * factor;
        }
        if (!glossy.empty()) glossy[point].scale(factor);
        for (std::size_t part = 0; part < (parts.empty() ? 0 : kPhotonParts); ++part)
            parts[point * kPhotonParts + part] *= factor;
    }
    std::size_t memory_bytes() const {
        return flux.capacity() * sizeof(Rgb) + accepted.capacity() * sizeof(std::uint32_t) +
               squares.capacity() * sizeof(float) + shareable.capacity() * sizeof(ShareableFlux) +
               glossy.capacity() * sizeof(GlossyFlux) +
               (parts.capacity() + inner.capacity()) * sizeof(Rgb) +
               probes.capacity() * sizeof(ProbeSums);
    }
};

/// What flux is still to be multiplied by: the constant f of Lambertian points, which it leaves
/// out.
inline Rgb left_out_f(const VisiblePoint& point) {
    return point.bsdf ? kWhite : point.kd * kInvPi;
}

/// Adds the photons in `grid` within its radius of each visible point. Photons on a surface that
/// faces elsewhere, or on the other side of the visible point's, are left out. Every point sums
/// its photons in the grid's order, so the result does not depend on the number of threads. Of the
/// points of other ranks nothing is gathered here. `occlusion` says which photons are asked for
/// whether something separates them from the point, and is told of those; null: none.
void gather_photons(const EyeImage& image, const PhotonGrid& grid, const GatherRadii& radii,
                    InvalidSampleFilter& filter, PhotonFlux& flux,
                    PhotonOcclusion* occlusion = nullptr);

/// After a gather: tells the other ranks what it brought to this one's points, and takes theirs.
/// `before`: PhotonFlux::counts before it; `work` began then.
void exchange_flux(const EyeImage& image, const GatherCounts& before, SharedWork& work,
                   PhotonFlux& flux, PhotonOcclusion* occlusion = nullptr);

/// Whether a photon is on the visible point's own surface: similar normals, whose cosine is
/// `agreement` up to its sign, and within a slab around the point's tangent plane, which keeps
/// light from leaking across thin walls.
bool on_same_surface(const VisiblePoint& point, Vec3 position, float agreement, float radius);

/// What glossy lobes that bounce as well reflect of one photon: of caustics.
struct GlossyPart {
    Rgb shared;     ///< f * power of these lobes, unless the bounce can't find the light
    float pdf = 0;  ///< with which the bounce goes where the photon came from
    Rgb counted;    ///< what is in the contribution
};

/// f * power of one photon (watts per steradian) within `radius` of a visible point, without the
/// constant f of Lambertian points, and without the eye's share of light that both may carry; black
/// if the point rejects it: on another surface, on its other side, or absorbed. Glossy lobes that
/// bounce as well count by their share; `glossy`, unless null, takes what they do.
Rgb contribution(const VisiblePoint& point, const GridPhoton& photon, float radius,
                 GlossyPart* glossy = nullptr);

}  // namespace aips
