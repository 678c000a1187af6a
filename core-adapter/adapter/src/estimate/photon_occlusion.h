// What separates a photon from a visible point: light does not pass walls, however thin.
//
// Density estimation takes the photons around a point for light that arrives at the point. A wall
// thinner than the radius makes that false: photons of the next room land on the same floor. So a
// photon counts only if a short ray along the surface reaches it. The same ray decides how much of
// the gather disc is surface (edge_correction.h), so that the estimate stays unbiased as radii
// fall.
//
// Most discs have nothing in them that separates. Each pass asks for a few photons of some visible
// points; where one of them could not be reached, all photons of that part of the image are asked
// for in later passes, and at that point at once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aips/adapter/settings.h"
#include "aips/core/base/state_archive.h"
#include "aips/core/photon_map/photon_grid.h"
#include "aips/core/sampling/random.h"
#include "base/constants.h"
#include "estimate/constants.h"
#include "eye/eye_pass.h"

namespace aips {

/// By how much such rays stand off two surfaces at `a` and `b`: a share of the radius, and what
/// rounding takes.
float occlusion_clearance(Vec3 a, Vec3 b, float radius);

/// Whether something stands between a visible point and a place in its gather disc, on a surface
/// with the unit normal `normal` there, turned to the side that the light comes from. The ray runs
/// just above both, and over the bulge of a surface that curves away; what is thinner than a
/// thousandth of `radius` may be missed. Surfaces that let light pass straight do not separate.
bool separated(const Scene& scene, const VisiblePoint& point, Vec3 position, Vec3 normal,
               float radius, float time);

/// How many photons of a visible point are asked for.
enum class OcclusionTest : std::uint8_t { None, Some, All };

/// Where photons are asked for, learned from pass to pass by parts of the image.
class PhotonOcclusion {
  public:
    /// `scene` outlives it.
    PhotonOcclusion(const Scene& scene, std::uint64_t seed, std::uint32_t width,
                    std::uint32_t height);

    /// Before the gathers of a pass, which rays trace at `time`.
    void begin_pass(std::uint64_t pass, float time, const EyeImage& image);

    /// What the gathers of this pass ask for at a visible point.
    OcclusionTest test_of(const VisiblePoint& point, std::size_t number, Vec2 film_position) const;
    /// Whether all photons of this part of the image are asked for.
    bool asks_all(Vec2 film_position) const { return marks_[cell_of(film_position)] != 0; }
    /// Photons that OcclusionTest::Some asks for at most, and the numbers that choose them.
    std::uint32_t some() const { return pass_ < kWarmUpPasses ? kFirstOcclusionAsks : 1; }
    RandomStream numbers(const VisiblePoint& point) const;
    /// Whether a photon is separated from the point.
    bool blocks(const VisiblePoint& point, const GridPhoton& photon, float radius) const {
        return separated(scene_, point, photon.position, photon.normal, radius, time_);
    }
    /// The same for who does not gather: as far as all photons are asked for there.
    bool blocks_if_asked(const VisiblePoint& point, Vec2 film_position, const GridPhoton& photon,
                         float radius) const {
        return asks_all(film_position) && blocks(point, photon, radius);
    }
    /// Something separates at this visible point. From one thread for each point.
    void found(std::size_t number) { found_[number] = 1; }
    /// Squared contributions of photons at a point that all were asked for, and of those that
    /// reached it; added up. From one thread for each point.
    void add_squares(std::size_t number, double all, double reached) {
        squares_[number].all += float(all);
        squares_[number].reached += float(reached);
    }

    /// Tells other ranks what this one's points have found, and takes theirs.
    void exchange(std::uint32_t rank, StateArchive& archive, const PointOwners& owners);
    /// After the gathers of a pass.
    void end_pass(const EyeImage& image);

    /// Share of squared contributions that reaches the visible points of a part of the image, by
    /// which contributions of photons there count: what is behind a wall brings nothing.
    float reached_share(Vec2 film_position) const;

    /// Saves what earlier passes have found, or restores it into a new one for the same film.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const;
    static std::size_t memory_bound_bytes(std::size_t pixels, std::size_t visible_points);

  private:
    struct Squares {
        float all = 0, reached = 0;
    };
    std::size_t cell_of(Vec2 film_position) const;
    void mark_around(std::size_t cell);

    const Scene& scene_;
    std::uint64_t seed_;
    std::uint32_t width_, height_, columns_, rows_;
    std::vector<std::uint8_t> marks_;   // [cell]: passes for which all its photons are asked for
    std::vector<float> all_, reached_;  // [cell]: squares, faded
    std::vector<std::uint8_t> found_;   // [visible point] of this pass
    std::vector<Squares> squares_;      // [visible point] of this pass
    std::uint64_t pass_ = 0;
    float time_ = 0;
};

}  // namespace aips
