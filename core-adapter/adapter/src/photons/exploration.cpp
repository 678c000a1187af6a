// Independent paths, chains that walk on from those that are visible, and what is learned from
// both.
#include "photons/exploration.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "aips/core/base/cache_line.h"
#include "aips/core/base/constants.h"
#include "aips/core/chains/mutation.h"
#include "aips/core/chains/primary_path.h"
#include "base/parallel_for.h"
#include "base/vector_growth.h"
#include "eye/light_choice.h"
#include "guides/adaptive/emission_guide.h"
#include "guides/adaptive/seed_search.h"
#include "photons/photon_chains.h"
#include "ranks/shared_work.h"

namespace aips {
namespace {

/// Jobs of a round, each a chain where chains walk: a fixed number, so that nothing depends on that
/// of threads.
constexpr std::uint32_t kJobs = kChainCount;
constexpr std::uint32_t kExploringPathsPerJob = kRoundPaths / kJobs;
static_assert(kRoundPaths % kJobs == 0 && kExploringPathsPerJob % kShortestSegment == 0);

/// Numbers of rounds count down from here: no pass that brings light has them, nor has the first
/// look.
constexpr std::uint64_t kFirstRound = std::numeric_limits<std::uint64_t>::max() - 1;

EmissionGuideSettings guide_settings() {
    EmissionGuideSettings settings;
    settings.plain_share = kPlainShare;
    // Paths that are found are few, and tell nothing of whether it pays to follow them.
    settings.trial_paths = std::numeric_limits<double>::infinity();
    return settings;
}

/// The first 32 bits of u in [0, 1). No leaf has a side below 2^-31: the point stays in its own.
Coordinate coordinate_of(double u) {
    return static_cast<Coordinate>(u * 0x1p32);
}

/// Uniform among those that choose the light, whose probabilities are multiples of 2^-24.
Coordinate coordinate_of(const DiscreteDistribution& choice, LightIndex light, std::uint32_t bits) {
    const auto first = static_cast<std::uint64_t>(double(choice.before(light)) * 0x1p32);
    const auto count = static_cast<std::uint64_t>(double(choice.pdf(light)) * 0x1p32);
    return static_cast<Coordinate>(first + (count * bits >> 32));
}

/// An independent path.
struct Drawn {
    EmissionStart start;
    double cost = 0;  // in rays
    bool visible = false;
};

/// A visible path at which a chain was for so many steps.
struct Visited {
    EmissionStart start;
    double cost = 0;
    std::uint32_t steps = 0;
};

/// What a chain's steps left.
struct alignas(kCacheLine) Walked {
    std::vector<Visited> visited;
    std::uint64_t mutated = 0, accepted = 0;
};

struct Chain {
    std::vector<Coordinate> at, proposed;
    double cost = 0;          // of the path that it is at
    std::uint32_t steps = 0;  // there so far
};

class Explorer {
  public:
    Explorer(const Scene& scene, const Settings& settings, const DiscreteDistribution& light_choice,
             float time, const EyeImage& image, float radius)
        : scene_(scene),
          settings_(settings),
          light_choice_(light_choice),
          image_(image),
          filter_(scene),
          guide_(scene.lights().size(), light_choice, guide_settings()),
          chains_(kJobs),
          input_{scene, settings_, light_choice} {
        input_.pass = kFirstRound;
        const std::vector<Vec3> positions =
            positions_of_most_photons(image.visible_points, settings_);
        const float reach = PhotonChains::reach(GatherRadii(radius));
        occupancy_.build(positions, reach, tbb_for);
        // The false hits of hashed occupancy would outnumber the visible paths of a wide scene.
        reach_.build(positions, reach, tbb_for);
        input_.occupancy = &occupancy_;
        input_.reach = &reach_;
        input_.time = time;
        input_.ranks = image.owners.ranks;
    }

    Exploration run() {
        std::uint32_t rounds = 0, with_finds = 0;
        double found = 0;
        for (; rounds < kMostExploringRounds && with_finds < kRoundsWithFinds &&
               found < kLearnedScores;
             --input_.pass) {
            seeds_.search(scene_, settings_, light_choice_, input_.pass, input_.time, image_,
                          result_.paths, guide_);
            draw();
            ++rounds;
            if (!pool_.empty()) {
                walk();
                ++rounds;
                with_finds += 2;
                found += effective_;
            }
            guide_.update(kRoundPaths);
        }
        std::ranges::stable_sort(result_.starts, {}, &EmissionSeed::light);
        return std::move(result_);
    }

  private:
    /// A visible path of the round, and the weight of all up to it.
    struct Found {
        std::uint64_t number = 0;
        double until = 0;
    };

    /// Memory of a thread, used again from path to path.
    struct Scratch {
        Arena arena;
        std::vector<Photon> photons;
        PhotonCounts counts;
    };

    /// Whether the path is visible; `cost`: its rays.
    bool trace(PrimaryPath& path, std::uint64_t number, double& cost) {
        Scratch& scratch = scratch_.local();
        const std::uint64_t rays = scratch.counts.rays;
        scratch.photons.clear();
        trace_photon_path(input_, path, std::uint32_t(number), filter_, scratch.arena,
                          scratch.photons, scratch.counts);
        cost = double(scratch.counts.rays - rays);
        return !scratch.photons.empty();
    }

    /// Path number `number` of the round, the same whenever it is drawn.
    Drawn draw(std::uint64_t number, std::vector<Coordinate>& coordinates) {
        RandomStream random(settings_.seed, input_.pass, number, RandomDomain::UniformPath);
        std::array<std::uint32_t, kStartCoordinates> bits;
        for (std::uint32_t& b : bits)
            b = random.next_uint();
        Drawn drawn{.start = guide_.sample(random.next(), primary_point(bits))};
        coordinates.clear();
        for (const double u : drawn.start.point)
            coordinates.push_back(coordinate_of(u));
        coordinates.push_back(coordinate_of(light_choice_, drawn.start.light, random.next_uint()));
        PrimaryPath path(random, {}, 1, coordinates);
        drawn.visible = trace(path, number, drawn.cost);
        return drawn;
    }

    /// Density of plain starts over that of the draw: what a path that starts so stands for.
    double weight(const EmissionStart& start) const {
        return double(light_choice_.pdf(start.light)) / start.pdf;
    }

    EmissionStart start_of(std::span<const Coordinate> coordinates) const {
        EmissionStart start;
        start.point =
            primary_point({coordinates[0], coordinates[1], coordinates[2], coordinates[3]});
        // Where there is one light no coordinate chooses it.
        if (scene_.lights().size() > 1) {
            const float u = to_unit_float(coordinates[kStartCoordinates]);
            start.light = static_cast<LightIndex>(light_choice_.sample(u).index);
        }
        return start;
    }

    /// A round of independent paths.
    void draw() {
        std::vector<std::vector<Drawn>> jobs(kJobs);
        const auto work = [&](std::uint32_t job) {
            std::vector<Coordinate> coordinates;
            for (std::uint32_t i = 0; i < kExploringPathsPerJob; ++i)
                jobs[job].push_back(
                    draw(std::uint64_t{job} * kExploringPathsPerJob + i, coordinates));
        };
        share_out(input_.ranks, kJobs, nullptr, work,
                  [&](std::uint32_t job, StateArchive& archive) { state_of(archive, jobs[job]); });
        result_.paths += kRoundPaths;
        pool_.clear();
        double sum = 0, squares = 0;
        std::uint64_t number = 0;
        for (const std::vector<Drawn>& job : jobs) {
            for (const Drawn& drawn : job) {
                const double w = drawn.visible ? weight(drawn.start) : 0;
                guide_.add({drawn.start, w * w, drawn.cost});
                sum += w;
                squares += w * w;
                if (drawn.visible) pool_.push_back({number, sum});
                ++number;
            }
        }
        effective_ = squares > 0 ? sum * sum / squares : 0;
    }

    /// Position in [0, 1) of all weight of the visible paths: number `segment` of `segments` that
    /// lie evenly, from a random place on.
    std::uint64_t start_number(std::uint32_t segment, std::uint32_t segments) const {
        RandomStream random(settings_.seed, input_.pass, 0, RandomDomain::ChainStart);
        const double at = double(random.next()) + double(segment) / segments;
        const double until = (at - std::floor(at)) * pool_.back().until;
        const auto it = std::ranges::upper_bound(pool_, until, {}, &Found::until);
        return it == pool_.end() ? pool_.back().number : it->number;
    }

    /// A round of chains, from paths that draw() found on.
    void walk() {
        const auto starts = std::uint32_t(std::min<std::size_t>(pool_.size(), kRoundPaths));
        const std::uint32_t segment =
            std::clamp<std::uint32_t>(kRoundPaths / starts / kShortestSegment * kShortestSegment,
                                      kShortestSegment, kExploringPathsPerJob);
        std::vector<Visited> visited;
        // The size of mutations is learned from one part of the round to the next.
        for (std::uint32_t step = 0; step < kExploringPathsPerJob; step += kShortestSegment) {
            std::vector<Walked> walks(kJobs);
            const auto work = [&](std::uint32_t c) { walk(c, step, segment, walks[c]); };
            share_out(input_.ranks, kJobs, nullptr, work,
                      [&](std::uint32_t c, StateArchive& archive) {
                          state_of(archive, walks[c].visited, walks[c].mutated, walks[c].accepted);
                      });
            std::uint64_t mutated = 0, accepted = 0;
            for (const Walked& walked : walks) {
                visited.insert(visited.end(), walked.visited.begin(), walked.visited.end());
                mutated += walked.mutated;
                accepted += walked.accepted;
            }
            if (mutated > 0)
                mutation_size_.learn(double(accepted) / double(mutated), mutated / kJobs);
        }
        result_.paths += kRoundPaths;
        learn(visited);
    }

    /// Steps of chain `c` from number `step` on.
    void walk(std::uint32_t c, std::uint32_t step, std::uint32_t segment, Walked& walked) {
        Chain& chain = chains_[c];
        for (std::uint32_t i = 0; i < kShortestSegment; ++i, ++step) {
            const std::uint64_t number = std::uint64_t{step} * kJobs + c;
            if (step % segment == 0) {
                const std::uint32_t segments = kExploringPathsPerJob / segment * kJobs;
                chain.steps = 0;
                chain.cost =
                    draw(start_number(step / segment * kJobs + c, segments), chain.at).cost;
            } else {
                const RandomStream random(settings_.seed, input_.pass, number,
                                          RandomDomain::MutatedPath);
                chain.proposed.clear();
                PrimaryPath path(random, chain.at, mutation_size_.exponent(), chain.proposed);
                ++walked.mutated;
                double cost = 0;
                if (trace(path, number, cost)) {
                    ++walked.accepted;
                    leave(chain, walked);
                    std::swap(chain.at, chain.proposed);
                    chain.cost = cost;
                }
            }
            ++chain.steps;
        }
        leave(chain, walked);
    }

    void leave(Chain& chain, Walked& walked) const {
        const std::uint32_t steps = std::exchange(chain.steps, 0);
        if (steps > 0) walked.visited.push_back({start_of(chain.at), chain.cost, steps});
    }

    /// Each step stands for its share of the visible paths.
    void learn(std::span<const Visited> visited) {
        const double share = pool_.back().until / kRoundPaths / kRoundPaths;
        const std::size_t first = result_.starts.size();
        for (const Visited& v : visited)
            result_.starts.push_back({v.start.light, v.start.point, float(share * v.steps)});
        std::vector<EmissionSeed> sorted(result_.starts.begin() + std::ptrdiff_t(first),
                                         result_.starts.end());
        std::ranges::stable_sort(sorted, {}, &EmissionSeed::light);
        // First, so that what they tell is known in the narrow leaves that they make.
        guide_.focus(sorted);
        for (const Visited& v : visited)
            guide_.add_part(v.start, share * v.steps * kRoundPaths, v.cost);
    }

    const Scene& scene_;
    Settings settings_;
    const DiscreteDistribution& light_choice_;
    const EyeImage& image_;
    InvalidSampleFilter filter_;  // of paths that bring nothing: told to nobody
    EmissionGuide guide_;
    SeedSearch seeds_;
    OccupancyGrid occupancy_;
    PointGrid reach_;
    MutationSize mutation_size_;
    std::vector<Chain> chains_;
    std::vector<Found> pool_;  // of the round
    double effective_ = 0;     // as many visible paths of equal weight tell as much
    Exploration result_;
    PhotonInput input_;
    tbb::enumerable_thread_specific<Scratch> scratch_;
};

}  // namespace

Exploration explore_starts(const Scene& scene, const Settings& settings,
                           const DiscreteDistribution& light_choice, float time,
                           const EyeImage& image, float radius) {
    if (light_choice.empty() || image.visible_points.empty()) return {};
    return Explorer(scene, settings, light_choice, time, image, radius).run();
}

std::size_t exploration_memory_bound(const Scene& scene, const Settings& settings,
                                     std::size_t eye_paths) {
    const std::size_t coordinates = max_coordinates(most_surfaces(settings)) * sizeof(Coordinate);
    // Of a round, and of all: what chains visited, or found.
    const std::size_t path = sizeof(Drawn) + 2 * sizeof(Visited) + sizeof(EmissionSeed);
    return EmissionGuide::memory_bound_bytes(light_choice(scene), guide_settings()) +
           SeedSearch::memory_bound_bytes(eye_paths) +
           OccupancyGrid::memory_bound_bytes(eye_paths) + PointGrid::memory_bound_bytes(eye_paths) +
           kJobs * (sizeof(Chain) + kVectorGrowth * 2 * coordinates) +
           kVectorGrowth * kRoundPaths *
               (path + std::size_t{kRoundsWithFinds} * sizeof(EmissionSeed));
}

}  // namespace aips
