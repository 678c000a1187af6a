// The search from the eye over passes.
#include "guides/adaptive/seed_search.h"

#include <algorithm>

#include "base/vector_growth.h"

namespace aips {

std::uint64_t SeedSearch::search(const Scene& scene, const Settings& settings,
                                 const DiscreteDistribution& light_choice, std::uint64_t pass,
                                 float time, const EyeImage& image, std::uint64_t paths,
                                 EmissionGuide& guide) {
    if (!settings.eye_seeding || paths >= kSeededPaths || ended_ || given_up()) return 0;
    SeedCounts counts;
    find_emission_seeds(scene, settings, light_choice, pass, time, image, seeds_, counts);
    walks_ += counts.walks;
    found_ += seeds_.size();
    std::ranges::stable_sort(seeds_, {}, &EmissionSeed::light);
    guide.add_seeds(seeds_);
    guide.update(0);
    return counts.rays;
}

void SeedSearch::state(StateArchive& archive) {
    archive.value(walks_);
    archive.value(found_);
    archive.value(ended_);
}

std::size_t SeedSearch::memory_bound_bytes(std::size_t eye_paths) {
    const std::size_t walks = eye_paths / kSeedGroup + 1;
    // In blocks and joined, or joined and sorted.
    return 2 * kVectorGrowth * walks * kMaxSeedsPerWalk * sizeof(EmissionSeed);
}

}  // namespace aips
