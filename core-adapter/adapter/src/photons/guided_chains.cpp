// Independent paths that measure, the chains that go on from them, and what is learned from both.
#include "photons/guided_chains.h"

#include <tbb/enumerable_thread_specific.h>

#include <cmath>

#include "base/parallel_for.h"
#include "base/vector_growth.h"
#include "photons/photon_chains.h"
#include "ranks/shared_work.h"

namespace aips {
namespace {

constexpr std::uint32_t kJobs = kChainCount;

/// Uniform in [0, 1). Choices of a pass have numbers: 0 where segments begin in the pool, and from
/// 1 on what stays in it.
double choice(const PhotonInput& input, std::uint64_t number) {
    const auto [seed, pass] = std::pair(input.settings.seed, input.pass);
    return double(RandomStream(seed, pass, number, RandomDomain::ChainStart).next());
}

}  // namespace

/// Traces paths of a job.
struct GuidedChains::Tracer {
    const PhotonInput& input;
    const ChainStarts& starts;
    Refusals& refusals;
    Arena& arena;
    PhotonCounts& counts;

    /// Whether the path is visible.
    bool trace(PrimaryPath& path, std::uint64_t number, Visible& left) {
        const std::uint64_t rays = counts.rays;
        left.landings.clear();
        trace_photon_path(input, path, std::uint32_t(number), refusals, arena, left.landings,
                          counts);
        left.cost = double(counts.rays - rays);
        return !left.landings.empty();
    }

    /// Independent path number `number`, the same whenever it is traced in a pass.
    bool independent(std::uint64_t number, std::vector<Coordinate>& coordinates, Visible& left,
                     EmissionStart& start) {
        RandomStream random(input.settings.seed, input.pass, number, RandomDomain::UniformPath);
        start = starts.draw(random, coordinates);
        PrimaryPath path(random, {}, 1, coordinates);
        return trace(path, number, left);
    }
};

/// What a job drew.
struct alignas(kCacheLine) GuidedChains::Drawn {
    struct Path {
        EmissionStart start;
        double cost = 0;
        bool visible = false;
    };
    std::vector<WeightedPath> visible;
    std::vector<Path> to_learn;
    PhotonCounts photons;
};

/// Where a chain went.
struct alignas(kCacheLine) GuidedChains::Walked {
    struct State {
        EmissionStart start;
        double cost = 0;
        std::uint32_t repeats = 0;
    };
    std::vector<Landing> landings;
    std::vector<State> states;
    PhotonCounts photons;
    ChainCounts chain;
};

GuidedChains::GuidedChains(const Scene& scene, const Settings& settings,
                           const DiscreteDistribution& light_choice)
    : starts_(scene, settings, light_choice), chains_(kJobs), pool_(kMostPooledPaths) {}

float GuidedChains::reach(const SearchRadii& radii) const {
    return PhotonChains::reach(radii);
}

void GuidedChains::mark_reach(std::span<const Vec3> visible_points, float radius) {
    reach_.build(visible_points, radius, tbb_for);
}

// By the last pass and not by what this one finds: lengths that depend on the starts would favour
// some of them.
std::uint64_t GuidedChains::begin_pass(const PassPhotons& photons, const GuidedPass& pass) {
    paths_ = photons.paths;
    measured_ = (paths_ + 1) / 2;
    const std::uint64_t steps = paths_ - measured_;
    const double starts = std::max(1.0, start_share_ * measured_);
    const std::uint64_t longest = std::max<std::uint64_t>(kShortestSegment, steps / kJobs);
    segment_steps_ =
        std::clamp<std::uint64_t>(std::uint64_t(double(steps) / starts), kShortestSegment, longest);
    segments_ = std::max<std::uint64_t>(1, steps / segment_steps_);
    pass_ = {};
    weights_ = {};
    pool_.clear();
    for (Chain& chain : chains_)
        chain.begin_pass();
    return starts_.begin_pass(pass.number, pass.time, pass.image);
}

std::uint32_t GuidedChains::iteration_paths() const {
    if (left_to_measure() > 0) return std::min(kRoundPaths, left_to_measure());
    // Short while the size of mutations is learned from one to the next.
    const std::uint64_t steps = std::max<std::uint64_t>(2, mutation_size_.steps() / 4);
    return std::uint32_t(std::min<std::uint64_t>(kJobs * steps, kRoundPaths));
}

PhotonCounts GuidedChains::trace(const PhotonInput& input, const IterationPaths& paths,
                                 Refusals& refusals, const PathTraces& traces) {
    PhotonInput exact = input;
    exact.reach = &reach_;
    const std::uint32_t measured = std::min(paths.count, left_to_measure());
    const std::uint32_t others = paths.count - measured;
    PhotonCounts counts;
    if (measured > 0) counts += draw(exact, measured, refusals);
    if (others == 0) return counts;
    // Where none was visible the pass says so, and the others look for some that later ones know.
    counts += pool_.empty() ? draw(exact, others, refusals)
                            : walk(exact, others, refusals, traces.landings);
    return counts;
}

PhotonCounts GuidedChains::draw(const PhotonInput& input, std::uint32_t count, Refusals& refusals) {
    std::vector<Drawn> jobs(kJobs);
    tbb::enumerable_thread_specific<Arena> arenas;
    const auto work = [&](std::uint32_t job) {
        Tracer tracer{input, starts_, refusals, arenas.local(), jobs[job].photons};
        draw(tracer, job, chain_share(job, kJobs, count), jobs[job]);
    };
    share_out(input.ranks, kJobs, &refusals, work, [&](std::uint32_t job, StateArchive& archive) {
        state_of(archive, jobs[job].visible, jobs[job].to_learn, jobs[job].photons);
    });
    const bool measuring = left_to_measure() > 0;
    PhotonCounts photons;
    for (std::uint64_t job = 0; job < kJobs; ++job) {
        take(jobs[job], measuring, choice(input, 1 + pass_.uniform + job));
        photons += jobs[job].photons;
    }
    if (starts_.on()) photons.guided_emissions += count;
    pass_.uniform += count;
    if (measuring) pass_.measured += count;
    return photons;
}

void GuidedChains::draw(Tracer& tracer, std::uint32_t job, std::uint32_t count,
                        Drawn& drawn) const {
    const std::uint32_t one_of = starts_.learn_one_of();
    std::vector<Coordinate> coordinates;
    Visible left;
    EmissionStart start;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint64_t number = pass_.uniform + std::uint64_t{i} * kJobs + job;
        const bool visible = tracer.independent(number, coordinates, left, start);
        if (visible) drawn.visible.push_back({number, starts_.weight(start)});
        if (number % one_of == 0) drawn.to_learn.push_back({start, left.cost, visible});
    }
}

void GuidedChains::take(const Drawn& drawn, bool measuring, double u) {
    for (const Drawn::Path& path : drawn.to_learn)
        starts_.add(path.start, path.visible, path.cost);
    if (!measuring) return;
    for (const WeightedPath& path : drawn.visible)
        weights_.add(path.weight);
    pass_.visible += drawn.visible.size();
    pool_.add(drawn.visible, u);
}

// Spread evenly over the pool, beginning at a random place: each by itself is drawn in proportion
// to weights, and together they leave out no heavy path.
std::uint64_t GuidedChains::start_of(const PhotonInput& input, std::uint64_t segment) const {
    const double at = choice(input, 0) + double(segment % segments_) / double(segments_);
    return pool_.at(at - std::floor(at));
}

PhotonCounts GuidedChains::walk(const PhotonInput& input, std::uint32_t count, Refusals& refusals,
                                LandingStore& store) {
    std::vector<Walked> walks(kJobs);
    tbb::enumerable_thread_specific<Arena> arenas;
    const auto work = [&](std::uint32_t c) {
        Tracer tracer{input, starts_, refusals, arenas.local(), walks[c].photons};
        walk(tracer, c, chain_share(c, kJobs, count), walks[c]);
    };
    share_out(input.ranks, kJobs, &refusals, work, [&](std::uint32_t c, StateArchive& archive) {
        state_of(archive, walks[c].landings, walks[c].states, walks[c].photons, walks[c].chain);
    });
    const double share = visible_share() / double(paths_ - measured_);
    PhotonCounts photons;
    ChainCounts counts;
    for (const Walked& walked : walks) {
        store.append(walked.landings);
        for (const Walked::State& state : walked.states)
            starts_.add_visible(state.start, share * state.repeats, state.cost);
        photons += walked.photons;
        counts += walked.chain;
    }
    pass_ += counts;
    not_learned_ += counts;
    if (mutation_size_.steps() < kMutationLearningSteps) learn_mutation_size();
    return photons;
}

void GuidedChains::walk(Tracer& tracer, std::uint32_t chain, std::uint32_t count, Walked& walked) {
    const PhotonInput& input = tracer.input;
    chains_[chain].run(
        {input.settings.seed, input.pass, chain, kJobs}, count, mutation_size_.exponent(),
        segment_steps_,
        [&](std::vector<Coordinate>& coordinates, Visible& state, std::uint64_t segment) {
            EmissionStart start;
            tracer.independent(start_of(input, segment * kJobs + chain), coordinates, state, start);
        },
        [&](PrimaryPath& path, Visible& state, std::uint64_t number) {
            return tracer.trace(path, pass_.uniform + number, state);
        },
        [&](std::span<const Coordinate> coordinates, const Visible& state, std::uint32_t repeats) {
            walked.states.push_back({starts_.at(coordinates), state.cost, repeats});
            record_state(state.landings, repeats, walked.landings);
        },
        walked.chain);
}

void GuidedChains::learn_mutation_size() {
    const std::uint64_t steps = not_learned_.mutated / kJobs;
    if (steps == 0) return;
    mutation_size_.learn(double(not_learned_.accepted) / double(not_learned_.mutated), steps);
    not_learned_ = {};
}

double GuidedChains::end_pass() {
    totals_ += pass_;
    all_weights_ += weights_;
    learn_mutation_size();
    starts_.end_pass();
    start_share_ = weights_.effective() / double(measured_);
    if (pass_.recorded == 0) return 0;
    return visible_share() * double(paths_) / double(pass_.recorded);
}

void GuidedChains::state(StateArchive& archive) {
    starts_.state(archive);
    mutation_size_.state(archive);
    not_learned_.state(archive);
    totals_.state(archive);
    all_weights_.state(archive);
    archive.amount(start_share_);
}

void GuidedChains::learned(LearnedParts& parts) {
    parts.part("starts of chains", starts_.fit(), [&](StateArchive& archive) {
        starts_.state(archive);
        mutation_size_.state(archive);
        archive.amount(start_share_);
        if (!archive.restoring()) return;
        starts_.begin_anew();
        mutation_size_.fade(kMutationLearningSteps / 2);
    });
}

void GuidedChains::add_to(EngineStatistics& statistics) const {
    statistics.measured_paths = totals_.measured;
    statistics.visible_paths = std::uint64_t(std::llround(all_weights_.effective()));
    statistics.mutation_size = mutation_size_.size();
}

std::size_t GuidedChains::memory_bytes() const {
    std::size_t bytes = reach_.memory_bytes() + starts_.memory_bytes() + pool_.memory_bytes();
    for (const Chain& chain : chains_) {
        bytes += sizeof(Chain) + chain.coordinate_bytes() +
                 (chain.current().landings.capacity() + chain.proposed().landings.capacity()) *
                     sizeof(Landing);
    }
    return bytes;
}

std::size_t GuidedChains::memory_bound_bytes(const Scene& scene, const Settings& settings,
                                             std::size_t eye_paths) {
    // Of an iteration, either of both.
    const std::size_t path = sizeof(WeightedPath) + sizeof(Drawn::Path) + sizeof(Walked::State);
    return PhotonChains::memory_bound_bytes(settings, std::uint32_t(eye_paths)) +
           ChainStarts::memory_bound_bytes(scene, eye_paths) +
           StartPool::memory_bound_bytes(kMostPooledPaths, kRoundPaths) +
           kVectorGrowth * kRoundPaths * path;
}

std::unique_ptr<PhotonSource> make_guided_chains(const Scene& scene, const Settings& settings,
                                                 const DiscreteDistribution& light_choice) {
    return std::make_unique<GuidedChains>(scene, settings, light_choice);
}

}  // namespace aips
