// The search from the eye for places where photons ought to start, over passes: it ends where
// photons tell more, or where it never finds any.
#pragma once

#include <vector>

#include "guides/adaptive/emission_guide.h"
#include "guides/adaptive/eye_seeding.h"

namespace aips {

class SeedSearch {
  public:
    /// Walks from the visible points of `image`, after so many photon `paths`, and tells `guide`
    /// what was found. `light_choice` is by power. Returns the rays traced.
    std::uint64_t search(const Scene& scene, const Settings& settings,
                         const DiscreteDistribution& light_choice, std::uint64_t pass, float time,
                         const EyeImage& image, std::uint64_t paths, EmissionGuide& guide);

    /// No more walks are done.
    void end() { ended_ = true; }
    /// Whether walks found no way to start a photon, and are no longer done.
    bool given_up() const { return walks_ >= kSeedTrialWalks && found_ == 0; }

    /// Between passes: saves the counts, or restores them.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const { return seeds_.capacity() * sizeof(EmissionSeed); }
    static std::size_t memory_bound_bytes(std::size_t eye_paths);

  private:
    std::vector<EmissionSeed> seeds_;  // of the last search
    std::uint64_t walks_ = 0, found_ = 0;
    bool ended_ = false;
};

}  // namespace aips
