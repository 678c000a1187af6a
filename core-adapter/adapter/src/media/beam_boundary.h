// Where a beam's surroundings end: what lies beside it is not all medium that its light comes
// through.
//
// The beam estimate spreads each photon over a disc across the beam. Beyond the medium's end there
// are no photons, and the estimate is too dark along it; beyond a thin wall are those of another
// room. So a photon counts only if a short ray from the beam reaches it, and for more where the
// disc ends: let rays go a way a from the beam towards the photon and a way b to the other side, at
// most the radius r. Of each pair of opposite sectors of the disc the share (a^2 + b^2) / (2 r^2)
// is there, and photons count one over that. For the constant kernel this is right wherever light
// varies little over what is there; and as beside a flat boundary one of both sides is free, they
// count no more than twice.
//
// To ask this for each photon is not needed. Of all that a beam gathered a few are drawn in
// proportion to what they brought, and the mean of theirs stands for all: the expectation is the
// same.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/base/state_archive.h"
#include "eye/volume_beam.h"

namespace aips {

class Scene;

class BeamBoundary {
  public:
    /// `scene` outlives it.
    explicit BeamBoundary(const Scene& scene);

    /// Before the gathers of a pass, which rays trace at `time`.
    void begin_pass(std::uint64_t pass, float time, std::size_t beams);
    /// How many photons of beam `number` of this pass are asked for, whose eye path comes from
    /// `film`: where something ended in one of the last passes several, one in the first passes,
    /// and one of a few beams later.
    std::uint32_t asks(const VolumeBeam& beam, std::size_t number, Vec2 film) const;
    /// By what a photon at `photon` counts for the beam at `distance`: 0 if a surface lies between.
    /// Traces two rays. From one thread for each beam.
    float factor(const VolumeBeam& beam, std::size_t number, float distance, Vec3 photon,
                 float radius);
    /// After the gathers of a pass; `films`: of its eye paths.
    void end_pass(std::span<const VolumeBeam> beams, std::span<const Vec2> films);

    /// Saves what earlier passes have found, or restores it.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const { return marks_.capacity() + found_.capacity(); }
    static std::size_t memory_bound_bytes(std::size_t beams);

  private:
    /// How far a ray goes, at most `farthest`.
    float way(Vec3 from, Vec3 direction, float farthest) const;

    const Scene& scene_;
    std::uint64_t pass_ = 0;
    float time_ = 0;
    std::vector<std::uint8_t> marks_;  // [part of the image, hashed]: passes in which it is asked
    std::vector<std::uint8_t> found_;  // [beam] of this pass: something ended near it
};

}  // namespace aips
