// Learning from logged photon paths.
#include "adaptive_guide.h"

#include <algorithm>
#include <limits>

#include "light_choice.h"
#include "vector_growth.h"

namespace aips {
namespace {

/// Paths that are logged: many while little is known, few later.
constexpr std::uint64_t kEagerPaths = 1'000'000;
constexpr std::uint32_t kEagerOneOf = 4, kOneOf = 16;
/// Passes that begin before so many paths are seeded from the eye.
constexpr std::uint64_t kSeededPaths = 2'000'000;
/// Scored photon paths that count in full; older ones fade.
constexpr double kMemoryPaths = 5e5;
/// Cost of an emission, in rays: a little less than a bounce's.
constexpr double kEmissionCost = 0.5;
/// Cost of storing and gathering a landing, in rays: gather and grid take about a third of what
/// tracing takes where landings are many (docs/design-notes.md).
constexpr double kLandingCost = 0.3;

ScoreCacheSettings cache_settings() {
    ScoreCacheSettings settings;
    settings.memory_paths = kMemoryPaths;
    return settings;
}

EmissionGuideSettings emission_settings() {
    EmissionGuideSettings settings;
    settings.memory_paths = kMemoryPaths;
    return settings;
}

}  // namespace

AdaptiveGuide::AdaptiveGuide(const Scene& scene, const Settings& settings,
                             const DiscreteDistribution& light_choice,
                             const PixelImportance& importance)
    : scene_(scene),
      settings_(settings),
      light_choice_(light_choice),
      scores_(importance),
      emission_(scene.lights().size(), light_choice, emission_settings()) {
    if (settings.guide_survival) {
        cache_.emplace(scene.bounds(), cache_settings());
        survival_.emplace(*cache_);
    }
    if (settings.guide_bounces) bounces_.emplace(scene.bounds(), kMemoryPaths);
}

std::uint64_t AdaptiveGuide::begin_pass(std::uint64_t pass, float time, const EyeImage& image,
                                        std::span<const Vec3> positions, const SearchRadii& radii) {
    rest_or_wake();
    if (!awake()) return 0;
    mean_weight_ = scores_.begin_pass(image, positions, radii);
    const bool seeds =
        emission() && settings_.eye_seeding && paths_ < kSeededPaths && !seeding_given_up();
    return seeds ? seed(pass, time, image) : 0;
}

void AdaptiveGuide::rest_or_wake() {
    // Before any path was worth something there is nothing to judge.
    const bool judged = visible_paths_ > 0;
    emission_rest_.update(paths_, !emission_.switched_off());
    survival_rest_.update(paths_, !judged || !survival_switched_off());
    bounces_rest_.update(paths_, !judged || (bounces_ && bounces_->tables().tables_in_use() > 0));
}

std::uint64_t AdaptiveGuide::seed(std::uint64_t pass, float time, const EyeImage& image) {
    SeedCounts counts;
    find_emission_seeds(scene_, settings_, light_choice_, pass, time, image, seeds_, counts);
    walks_ += counts.walks;
    seeds_found_ += seeds_.size();
    std::ranges::stable_sort(seeds_, {}, &EmissionSeed::light);
    emission_.add_seeds(seeds_);
    emission_.update(0);
    return counts.rays;
}

std::uint32_t AdaptiveGuide::log_one_of() const {
    if (!awake()) return 0;
    return paths_ < kEagerPaths ? kEagerOneOf : kOneOf;
}

void AdaptiveGuide::learn(const PathLog& log, std::span<const Landing> landings,
                          std::uint32_t paths) {
    paths_ += paths;
    if (!awake()) return;
    score_landings(log, landings);
    landing_score_at_ = 0;
    for (const PathRecord& path : log.paths)
        learn_path(log, path, landings);
    // In paths that were scored: one in how many that is changes, and would change the scale.
    const auto scored = double(log.paths.size());
    if (emission()) emission_.update(scored);
    if (survival()) {
        cache_->update(scored);
        survival_->set_reference(path_means_.cost_over_score());
        survival_switch_.update(scored, kMemoryPaths);
    }
    if (bounces()) bounces_->update(scored);
    path_means_.update(scored);
}

void AdaptiveGuide::score_landings(const PathLog& log, std::span<const Landing> landings) {
    std::vector<std::uint32_t>& numbers = scored_;
    numbers.clear();
    for (const PathRecord& path : log.paths) {
        for (std::uint32_t i = 0; i < path.landings; ++i)
            numbers.push_back(path.first_landing + i);
    }
    landing_scores_ = scores_.of(landings, numbers);
}

// From the path's end to its start, summing what came after.
void AdaptiveGuide::learn_path(const PathLog& log, const PathRecord& path,
                               std::span<const Landing> landings) {
    if (survival()) judge_survival(log, path, landings);
    const std::size_t first = landing_score_at_;
    landing_score_at_ += path.landings;
    double score = 0;
    double landed = 0, rays = 0;
    std::uint32_t last_rays = path.rays;
    std::uint32_t l = path.landings;
    const auto take_landings_after = [&](std::uint32_t depth) {
        for (; l > 0 && landings[path.first_landing + l - 1].depth > depth; --l) {
            score += landing_scores_[first + l - 1];
            landed += 1;
        }
    };
    for (std::uint32_t v = path.vertices; v-- > 0;) {
        const PathVertex& vertex = log.vertices[path.first_vertex + v];
        take_landings_after(vertex.depth);
        rays += last_rays - vertex.rays;
        last_rays = vertex.rays;
        const double copies = std::max(1.0, double(vertex.survival.photons));
        const double power = double(vertex.power);
        const double cost = rays + kLandingCost * landed;
        const double branch_score = score;
        score *= copies;
        rays *= copies;
        landed *= copies;
        if (!(power > 0)) continue;
        if (survival())
            cache_->add({vertex.position, vertex.normal, branch_score / (power * power), cost});
        if (bounces()) bounces_->add(vertex, branch_score, cost);
    }
    take_landings_after(0);
    rays += last_rays;
    const double cost = kEmissionCost + rays + kLandingCost * landed;
    if (emission()) {
        emission_.add({{path.light, path.start, path.pdf}, score, cost});
    }
    path_means_.add(score, cost);
    if (score > 0) ++visible_paths_;
}

// From the path's start to its end.
void AdaptiveGuide::judge_survival(const PathLog& log, const PathRecord& path,
                                   std::span<const Landing> landings) {
    SurvivalSwitch::Path judged;
    std::uint32_t l = 0, rays = 0;
    const auto add_up_to = [&](std::uint32_t depth, std::uint32_t rays_so_far) {
        double score = 0;
        double cost = double(rays_so_far - rays);
        for (; l < path.landings && landings[path.first_landing + l].depth <= depth; ++l) {
            score += landing_scores_[landing_score_at_ + l];
            cost += kLandingCost;
        }
        rays = rays_so_far;
        judged.add(score, cost);
    };
    judged.add(0, kEmissionCost);
    for (std::uint32_t v = 0; v < path.vertices; ++v) {
        const PathVertex& vertex = log.vertices[path.first_vertex + v];
        add_up_to(vertex.depth, vertex.rays);
        judged.survive(vertex.survival);
    }
    add_up_to(std::numeric_limits<std::uint32_t>::max(), path.rays);
    survival_switch_.add(judged);
}

void AdaptiveGuide::state(StateArchive& archive) {
    emission_.state(archive);
    if (cache_) cache_->state(archive);
    if (survival_) survival_->state(archive);
    survival_switch_.state(archive);
    if (bounces_) bounces_->state(archive);
    path_means_.state(archive);
    for (PartRest* rest : {&emission_rest_, &survival_rest_, &bounces_rest_})
        rest->state(archive);
    for (std::uint64_t* count : {&paths_, &walks_, &seeds_found_, &visible_paths_})
        archive.value(*count);
    archive.amount(mean_weight_);
}

std::size_t AdaptiveGuide::memory_bytes() const {
    return scores_.memory_bytes() + emission_.memory_bytes() +
           (cache_ ? cache_->memory_bytes() : 0) + (bounces_ ? bounces_->memory_bytes() : 0) +
           seeds_.capacity() * sizeof(EmissionSeed) + scored_.capacity() * sizeof(std::uint32_t);
}

std::size_t AdaptiveGuide::memory_bound_bytes(const Scene& scene, const Settings& settings,
                                              std::size_t eye_paths) {
    const std::size_t walks = eye_paths / kSeedGroup + 1;
    // In blocks and joined, or joined and sorted.
    const std::size_t seeds = 2 * kVectorGrowth * walks * kMaxSeedsPerWalk * sizeof(EmissionSeed);
    // The scores themselves are counted with the log.
    return IterationScores::memory_bound_bytes(eye_paths, 0) + seeds +
           (settings.guide_survival ? ScoreCache::memory_bound_bytes(cache_settings()) : 0) +
           (settings.guide_bounces ? BounceGuide::memory_bound_bytes(kMemoryPaths) : 0) +
           EmissionGuide::memory_bound_bytes(light_choice(scene), emission_settings());
}

}  // namespace aips
