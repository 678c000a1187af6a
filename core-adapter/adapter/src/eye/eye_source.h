// Where the eye paths of a pass come from, and at which moment it sees the scene: what modes differ
// in before any photon is shot.
#pragma once

#include <cstdint>
#include <memory>

#include "eye/eye_pass.h"

namespace aips {

class EyeSource {
  public:
    virtual ~EyeSource() = default;
    /// Makes `image` that of pass number `pass`; passes come in order. Returns the eye paths traced
    /// for it: 0 if they are those of an earlier pass.
    virtual std::uint32_t look(std::uint64_t pass, InvalidSampleFilter& filter,
                               EyeImage& image) = 0;
    /// What its eye paths are traced with.
    virtual const EyePassInput& input() const = 0;
    /// One moment of the shutter interval, for all rays of the pass.
    virtual float time(std::uint64_t pass) const = 0;
    /// After restoring `passes` passes: brings back what later ones go on with. Bsdfs are the
    /// host's, which only it can make.
    virtual void restore(std::uint64_t passes, EyeImage& image) = 0;
};

/// New eye paths in each pass, or the first's for all (freezes_eye_pass()). What `input` refers to
/// outlives the source.
std::unique_ptr<EyeSource> make_eye_source(const EyePassInput& input);

/// Eye paths of a pass over so many pixels, unless hitpointperpass says otherwise.
std::uint32_t eye_paths_per_pass(const Settings& settings, std::uint64_t pixels);

}  // namespace aips
