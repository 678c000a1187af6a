// Density estimation at edges: where part of a gather disc is no surface, no photon can land there.
//
// Divided by the area of a full disc the estimate would be half of the truth at a straight edge,
// and dark seams as wide as the radius would run along all of them.
#pragma once

#include <cstdint>
#include <vector>

#include "aips/adapter/settings.h"
#include "estimate/photon_noise.h"
#include "estimate/surface_share.h"
#include "eye/disc_gaps.h"

namespace aips {

/// Multiplies what photons bring by estimates of 1 / (share of the disc that is surface). They do
/// not depend on the photons of the pass. All that steers them is of earlier passes:
///
/// - Where radii are adaptive, noise is weighed against bias here as it is there. The correction
///   multiplies both light and noise of k photons, and is best if it falls short by the factor
///   1 + 1/k. So the first places are believed, in the mean as many as that takes.
/// - Pixels that have shown an edge lately are asked with more rays than others.
///
/// What photons bring too little after that, eye paths may bring (DiscGaps).
class EdgeCorrection final : public DiscGaps {
  public:
    /// `scene`, `settings` and `occlusion` outlive it. With `occlusion` surface counts for none
    /// where something separates it from the point; null: it always counts.
    EdgeCorrection(const Scene& scene, const Settings& settings, std::uint32_t width,
                   std::uint32_t height, const PhotonOcclusion* occlusion = nullptr);

    /// Corrects what the photons of a pass have brought; returns the rays traced for it. `radii`
    /// are those that `flux` was gathered within. What the inner halves of discs brought is
    /// corrected by rays of its own, at edges that are known, and changes nothing else. Bits do not
    /// depend on the number of threads.
    std::uint64_t correct(std::uint64_t pass, float time, const EyeImage& image,
                          const GatherRadii& radii, PhotonFlux& flux);

    /// By how far its factors are bounded, and by the places that it believes.
    float lost_share(Vec2 film) const override;
    bool loses(const VisiblePoint& point, Vec2 film, float time, RandomStream& random, Arena& arena,
               std::uint32_t& rays) const override;

    /// Luminance that the photons of the last pass brought to all eye paths, over what it was
    /// without correction; 1 if nothing came.
    double brightened() const { return brightened_; }

    /// Saves what earlier passes have told, or restores it into a new one for the same film.
    void state(StateArchive& archive);

    std::size_t memory_bytes() const {
        return noise_.memory_bytes() + gaps_.capacity() * sizeof(Gap) + edges_.capacity() +
               found_.capacity() + walls_.capacity() + found_walls_.capacity() +
               met_walls_.capacity() + factors_.capacity() * sizeof(float);
    }
    static std::size_t memory_bound_bytes(std::size_t pixels, std::size_t visible_points) {
        return PhotonNoise::memory_bound_bytes(pixels) + (4 + sizeof(Gap)) * pixels +
               visible_points * (1 + sizeof(float));
    }

  private:
    /// What discs of a pixel lost lately.
    struct Gap {
        float radius = 0;  // of the last one that was not all surface; scene units
        float asked = 0;   // places, older ones fading
        float lost = 0;    // of these
    };

    SurfaceQuestion question(std::uint32_t pixel, Vec2 film) const;
    void learn_gaps(const EyeImage& image);
    float believed(std::uint32_t pixel) const;
    void apply(const EyeImage& image, PhotonFlux& flux);
    void remember(const EyeImage& image, const GatherRadii& radii);
    static void age(std::vector<std::uint8_t>& passes, std::vector<std::uint8_t>& found);

    const Scene& scene_;
    const Settings& settings_;
    std::uint32_t width_, height_;
    const PhotonOcclusion* occlusion_;
    PhotonNoise noise_;                // if radii are adaptive
    std::vector<std::uint8_t> edges_;  // [pixel]: passes for which it counts as one at an edge
    std::vector<std::uint8_t> found_;  // [pixel]: whether this pass has found one there
    // The same for surface that something separates from a visible point; of occlusion alone.
    std::vector<std::uint8_t> walls_, found_walls_;
    std::vector<Gap> gaps_;                // [pixel]
    std::vector<float> factors_;           // [visible point], of the last pass
    std::vector<std::uint8_t> met_walls_;  // [visible point]: surface that is separated from it
    double brightened_ = 1;                // by these
};

}  // namespace aips
