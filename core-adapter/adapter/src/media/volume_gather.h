// Light that photons bring into media: their collisions, and the beam radiance estimate of eye
// paths that cross them.
//
// References: Jensen & Christensen 1998 (photons in media), Jarosz, Zwicker & Jensen 2008, "The
// beam radiance estimate for volumetric photon mapping", Knaus & Zwicker 2011 (its progressive
// radius).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "aips/core/photon_map/segment_grid.h"
#include "estimate/constants.h"
#include "estimate/group_sums.h"
#include "estimate/pass_photons.h"
#include "estimate/pixel_estimate.h"
#include "eye/eye_pass.h"
#include "media/beam_boundary.h"
#include "sample_filter/invalid_sample_filter.h"

namespace aips {

/// A collision of a photon in a medium.
struct VolumePhoton {
    Vec3 position;
    Vec3 direction;  ///< unit, back to where the photon came from
    Rgb power;       ///< watts * transmittance / density of the collision * scattering there
    const void* medium = nullptr;
    std::uint32_t light_group = 0;
    ImagePart part = ImagePart::Direct;  ///< as Photon::part
    std::uint32_t bounces = 0;           ///< before it, as Photon::bounces
};

/// What is to be known of the flux beside its sum by light group.
struct VolumeWants {
    bool parts = false;  ///< direct light and caustics
    bool inner = false;  ///< what the inner half of the beams' sections brings
};

class VolumeGather {
  public:
    VolumeGather(const Scene& scene, const Settings& settings);

    /// A pass whose eye paths left these beams starts.
    void begin_pass(std::uint64_t pass, float time, const PassPhotons& photons,
                    const EyeImage& image, VolumeWants wants = {});
    /// Photons are appended here.
    std::vector<VolumePhoton>& waiting() { return waiting_; }
    bool full() const { return waiting_.size() > kWaitingPhotons; }
    /// Of all that wait from number `first` on.
    void scale_power(std::size_t first, float factor);
    /// Adds what waits to the beams' flux. Every beam sums its photons in a fixed order.
    void gather(const EyeImage& image, InvalidSampleFilter& filter);
    /// After the last gather of a pass.
    void end_pass(const EyeImage& image);
    void scale_flux(float factor);
    /// Adds sum(flux) / (pi r^2 N) of each beam to what photons bring to its eye path, N being the
    /// photon paths of the pass, and the variance of its luminance to the path's in `variances`
    /// (one for each eye path, or empty: not asked for).
    void add_to(const EyeImage& image, std::uint64_t photon_paths, InvalidSampleFilter& filter,
                std::vector<Rgb>& radiance, std::span<float> variances) const;

    /// Of that, direct light and caustics: [beam * kPhotonParts + ImagePart]; empty if not wanted.
    std::vector<Rgb> parts(const EyeImage& image, std::uint64_t photon_paths) const;

    /// Adds what photons bring to beams, all light groups together, within the radius and within
    /// the inner half of its area; nothing if that is not wanted.
    void add_discs(const EyeImage& image, std::uint64_t photon_paths, DiscEstimates& discs) const;

    /// Between passes: saves the radius that the first pass began with and where media end, or
    /// restores it; all else is of one pass.
    void state(StateArchive& archive);

    float radius() const { return radius_; }
    std::uint64_t gathered() const { return gathered_; }
    /// Traced to see where media end.
    std::uint64_t rays() const { return rays_; }
    std::size_t memory_bytes() const;
    /// With up to `iteration` collisions in an iteration.
    static std::size_t memory_bound_bytes(const Scene& scene, std::size_t eye_paths,
                                          std::size_t iteration);

  private:
    struct BeamSums;
    struct Found;
    void sort();
    /// Photons within the radius of a beam, or one of thinning_.
    void find(const VolumeBeam& beam, Found& found) const;
    void gather_beam(const VolumeBeam& beam, InvalidSampleFilter& filter, Found& found,
                     BeamSums& sums) const;
    /// By what all counts that a beam gathered, as photons of it count that are asked for.
    float boundary_factor(const EyeImage& image, std::size_t number, const Found& found,
                          BeamSums& sums);
    /// One over the area within the radius and the photon paths of the pass.
    double per_disc_and_path(std::uint64_t photon_paths) const;
    /// Radiance of a beam that photons of `sum` bring it.
    Rgb radiance_of(const VolumeBeam& beam, const Rgb& sum, double scale) const;

    const Scene& scene_;
    Settings settings_;
    double initial_radius_ = 0;  // from the first beams' pixel footprints
    float radius_ = 0;
    std::uint64_t pass_ = 0;
    std::uint32_t thinning_ = 1;  // PassPhotons::thinning
    std::vector<VolumePhoton> waiting_;
    SegmentGrid grid_;
    std::vector<Vec3> positions_;        // of waiting_, for the sort
    std::vector<VolumePhoton> photons_;  // [slot of grid_]
    std::vector<Rgb> flux_;              // [beam * groups + group]
    std::vector<Rgb> part_flux_;         // [beam * kPhotonParts + part]; empty if not wanted
    std::vector<Rgb> inner_flux_;        // [beam]; empty if not wanted
    std::vector<float> squares_;         // [beam]: of the luminances that flux_ sums
    std::uint64_t gathered_ = 0, rays_ = 0;
    std::optional<BeamBoundary> boundary_;  // if photons are asked for what separates them
};

}  // namespace aips
