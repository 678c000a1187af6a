// Learning from logged photon paths.
#include "guides/adaptive/adaptive_guide.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "aips/core/base/constants.h"
#include "base/parallel_for.h"
#include "base/vector_growth.h"
#include "eye/light_choice.h"

namespace aips {
namespace {

/// Scored photon paths that what was learned in another render counts for.
constexpr double kRememberedPaths = 1e5;

ScoreCacheSettings cache_settings() {
    ScoreCacheSettings settings;
    settings.memory_paths = kLearningPaths;
    return settings;
}

EmissionGuideSettings emission_settings() {
    EmissionGuideSettings settings;
    settings.memory_paths = kLearningPaths;
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
    if (settings.guide_bounces) bounces_.emplace(scene.bounds(), kLearningPaths);
}

void AdaptiveGuide::begin_with(std::span<const EmissionSeed> starts) {
    if (starts.empty()) return;
    emission_.add_seeds(starts);
    emission_.update(0);
    seeds_.end();
}

std::uint64_t AdaptiveGuide::begin_pass(std::uint64_t pass, float time, const EyeImage& image,
                                        std::span<const Vec3> positions, const GatherRadii& radii) {
    update_switches();
    if (!enabled()) return 0;
    mean_weight_ = scores_.begin_pass(image, positions, radii);
    if (!emission()) return 0;
    return seeds_.search(scene_, settings_, light_choice_, pass, time, image, paths_, emission_);
}

void AdaptiveGuide::update_switches() {
    // Before any path was worth something there is nothing to judge.
    const bool judged = visible_paths_ > 0;
    emission_part_.update(paths_, !emission_.switched_off());
    survival_part_.update(paths_, !judged || !survival_switched_off());
    bounces_part_.update(paths_, !judged || (bounces_ && bounces_->tables().tables_in_use() > 0));
}

std::uint32_t AdaptiveGuide::log_one_of() const {
    if (!enabled()) return 0;
    return paths_ < kEagerPaths ? kEarlyOneOf : kLateOneOf;
}

void AdaptiveGuide::study(const PathLog& log) {
    if (!enabled() || log.paths.empty()) return;
    contributions_.measure(log, scores_.of(log.photons));
    // They know nothing of each other; each learns from the paths in their order.
    tbb_for(4, [&](std::uint32_t part) {
        if (part == 0 && survival()) learn_survival(log);
        if (part == 1 && emission()) learn_emission(log);
        if (part == 2 && survival()) judge_survival(log);
        if (part == 3 && bounces()) learn_bounces(log);
    });
    for (const PathContribution& path : contributions_.paths()) {
        path_means_.add(path.score, path.cost);
        if (path.score > 0) ++visible_paths_;
    }
    studied_ += PathLogSize::of(log);
}

std::uint64_t AdaptiveGuide::update(std::uint32_t paths) {
    paths_ += paths;
    const PathLogSize studied = std::exchange(studied_, {});
    if (!enabled() || studied.paths == 0) return 0;
    const auto scored = double(studied.paths);
    // In paths that were scored: one in how many that is changes, and would change the scale.
    tbb_for(3, [&](std::uint32_t part) {
        if (part == 0 && survival()) cache_->update(scored);
        if (part == 1 && emission()) emission_.update(scored);
        if (part == 2 && bounces()) bounces_->update(scored);
    });
    if (survival()) {
        survival_switch_.update(scored, kLearningPaths);
        survival_->set_reference(path_means_.cost_over_score());
    }
    path_means_.update(scored);
    return studied.paths + studied.vertices + studied.photons;
}

void AdaptiveGuide::learn_emission(const PathLog& log) {
    for (std::size_t i = 0; i < log.paths.size(); ++i) {
        const PathRecord& path = log.paths[i];
        const PathContribution& contribution = contributions_.paths()[i];
        emission_.add({{path.light, path.start, path.pdf}, contribution.score, contribution.cost});
    }
}

template <class Visit>
void AdaptiveGuide::for_each_vertex(const PathLog& log, const Visit& visit) const {
    for (const PathRecord& path : log.paths) {
        for (std::uint32_t v = path.first_vertex + path.vertices; v-- > path.first_vertex;) {
            if (log.vertices[v].power > 0) visit(log.vertices[v], contributions_.vertices()[v]);
        }
    }
}

void AdaptiveGuide::learn_survival(const PathLog& log) {
    for_each_vertex(log, [&](const PathVertex& vertex, const PathContribution& contribution) {
        const double power = double(vertex.power);
        cache_->add({vertex.position, vertex.normal, contribution.score / (power * power),
                     contribution.cost});
    });
}

void AdaptiveGuide::learn_bounces(const PathLog& log) {
    for_each_vertex(log, [&](const PathVertex& vertex, const PathContribution& contribution) {
        bounces_->add(vertex, contribution.score, contribution.cost);
    });
}

void AdaptiveGuide::judge_survival(const PathLog& log) {
    for (const PathRecord& path : log.paths)
        survival_switch_.add(judged_path(log, path));
}

// From the path's start to its end.
SurvivalSwitch::Path AdaptiveGuide::judged_path(const PathLog& log, const PathRecord& path) const {
    const std::span scores = contributions_.scores(path);
    const std::span photons = std::span(log.photons).subspan(path.first_photon, path.photons);
    SurvivalSwitch::Path judged;
    std::uint32_t l = 0, rays = 0;
    const auto add_up_to = [&](std::uint32_t depth, std::uint32_t rays_so_far) {
        double score = 0;
        double cost = double(rays_so_far - rays);
        for (; l < path.photons && photons[l].depth <= depth; ++l) {
            score += scores[l];
            cost += kPhotonCost;
        }
        rays = rays_so_far;
        judged.add(score, cost);
    };
    judged.add(0, kPhotonCost);
    for (std::uint32_t v = 0; v < path.vertices; ++v) {
        const PathVertex& vertex = log.vertices[path.first_vertex + v];
        add_up_to(vertex.depth, vertex.rays);
        judged.survive(vertex.survival);
    }
    add_up_to(std::numeric_limits<std::uint32_t>::max(), path.rays);
    return judged;
}

void AdaptiveGuide::state(StateArchive& archive) {
    emission_.state(archive);
    if (cache_) cache_->state(archive);
    if (survival_) survival_->state(archive);
    survival_switch_.state(archive);
    if (bounces_) bounces_->state(archive);
    path_means_.state(archive);
    for (PartSwitch* part : {&emission_part_, &survival_part_, &bounces_part_})
        part->state(archive);
    seeds_.state(archive);
    archive.value(paths_);
    archive.value(visible_paths_);
    archive.amount(mean_weight_);
}

void AdaptiveGuide::learned(LearnedParts& parts) {
    parts.part("emission", emission_.fit(), [&](StateArchive& archive) {
        emission_.state(archive);
        if (archive.restoring()) emission_.begin_anew(kRememberedPaths);
    });
    if (cache_) {
        parts.part("survival", 0, [&](StateArchive& archive) {
            cache_->state(archive);
            survival_->state(archive);
            survival_switch_.state(archive);
            if (!archive.restoring()) return;
            cache_->fade(kRememberedPaths);
            survival_switch_.begin_anew();
        });
    }
    if (bounces_) {
        parts.part("directions", 0, [&](StateArchive& archive) {
            bounces_->state(archive);
            if (archive.restoring()) bounces_->fade(kRememberedPaths);
        });
    }
    parts.part("worth of photons", 0, [&](StateArchive& archive) {
        path_means_.state(archive);
        archive.value(visible_paths_);
        if (archive.restoring()) path_means_.fade(kRememberedPaths);
    });
}

std::size_t AdaptiveGuide::memory_bytes() const {
    return scores_.memory_bytes() + emission_.memory_bytes() +
           (cache_ ? cache_->memory_bytes() : 0) + (bounces_ ? bounces_->memory_bytes() : 0) +
           seeds_.memory_bytes() + contributions_.memory_bytes();
}

std::size_t AdaptiveGuide::memory_bound_bytes(const Scene& scene, const Settings& settings,
                                              std::size_t eye_paths) {
    // The scores themselves are counted with the log, and so are paths' contributions.
    return IterationScores::memory_bound_bytes(eye_paths, 0) +
           SeedSearch::memory_bound_bytes(eye_paths) +
           (settings.guide_survival ? ScoreCache::memory_bound_bytes(cache_settings()) : 0) +
           (settings.guide_bounces ? BounceGuide::memory_bound_bytes(kLearningPaths) : 0) +
           EmissionGuide::memory_bound_bytes(light_choice(scene), emission_settings());
}

}  // namespace aips
