// Rounds of the chains, learning of the mutation size, normalisation.
#include "photons/photon_chains.h"

#include <tbb/enumerable_thread_specific.h>

#include "aips/core/base/cache_line.h"
#include "base/parallel_for.h"
#include "base/vector_growth.h"

namespace aips {
namespace {

struct alignas(kCacheLine) Round {
    std::vector<Photon> stored;
    PhotonCounts photons;
    ChainCounts chain;
};

}  // namespace

void record_state(std::span<const Photon> state, std::uint32_t repeats,
                  std::vector<Photon>& photons) {
    for (Photon photon : state) {
        photon.power = photon.power * float(repeats);
        photons.push_back(photon);
    }
}

void PhotonChains::mark_reach(std::span<const Vec3> visible_points, float radius) {
    reach_.build(visible_points, radius, tbb_for);
}

void PhotonChains::begin_pass(std::uint32_t paths) {
    paths_ = paths;
    pass_ = {};
    chains_.resize(chain_count(paths));
    for (std::uint32_t c = 0; c < chains(); ++c)
        chains_[c].begin_pass((chain_share(c, chains(), paths) + 1) / 2);
}

std::uint32_t PhotonChains::round_paths() const {
    const std::uint64_t traced = (pass_.uniform + pass_.mutated) / chains();
    const std::uint32_t most = std::min(kRoundPaths / kChainCount, kPlainIterationPaths / chains());
    return chains() * std::uint32_t(std::clamp<std::uint64_t>(traced / 4, 2, most));
}

PhotonCounts PhotonChains::trace(const PhotonInput& input, std::uint32_t count,
                                 InvalidSampleFilter& filter, PhotonStore& store) {
    std::vector<Round> rounds(chains());
    tbb::enumerable_thread_specific<Arena> arenas;
    PhotonInput exact = input;
    exact.reach = &reach_;
    const float exponent = mutation_size_.exponent();
    tbb::parallel_for(0u, chains(), [&](std::uint32_t c) {
        Arena& arena = arenas.local();
        Round& round = rounds[c];
        chains_[c].run(
            {input.settings.seed, input.pass, c, chains()}, chain_share(c, chains(), count),
            exponent,
            [&](PrimaryPath& path, std::vector<Photon>& state, std::uint64_t number) {
                state.clear();
                trace_photon_path(exact, path, std::uint32_t(number), filter, arena, state,
                                  round.photons);
                return !state.empty();
            },
            [&](const std::vector<Photon>& state, std::uint32_t repeats) {
                record_state(state, repeats, round.stored);
            },
            round.chain);
    });
    PhotonCounts photons;
    ChainCounts counts;
    std::vector<std::size_t> first{0};
    for (const Round& round : rounds) {
        first.push_back(first.back() + round.stored.size());
        photons += round.photons;
        counts += round.chain;
    }
    const std::span<Photon> joined = store.grow(first.back());
    tbb::parallel_for(0u, chains(), [&](std::uint32_t c) {
        std::ranges::copy(rounds[c].stored, joined.subspan(first[c]).begin());
    });
    pass_ += counts;
    not_learned_ += counts;
    if (mutation_size_.steps() < kMutationLearningSteps) learn_mutation_size();
    spread_states();
    return photons;
}

void PhotonChains::learn_mutation_size() {
    const std::uint64_t steps = not_learned_.mutated / chains();
    if (steps == 0) return;
    mutation_size_.learn(double(not_learned_.accepted) / double(not_learned_.mutated), steps);
    not_learned_ = {};
}

/// Chains without a path go on from those that have one, in turn.
void PhotonChains::spread_states() {
    std::vector<std::size_t> with_state;
    for (std::size_t c = 0; c < chains_.size(); ++c) {
        if (chains_[c].has_state()) with_state.push_back(c);
    }
    if (with_state.empty()) return;
    std::size_t next = 0;
    for (Chain& chain : chains_) {
        if (!chain.has_state()) chain.adopt(chains_[with_state[next++ % with_state.size()]]);
    }
}

double PhotonChains::end_pass() {
    totals_ += pass_;
    learn_mutation_size();
    if (pass_.recorded == 0) return 0;
    const double visible_share = double(pass_.visible) / double(pass_.measured);
    return visible_share * double(paths_) / double(pass_.recorded);
}

void PhotonChains::state(StateArchive& archive) {
    mutation_size_.state(archive);
    not_learned_.state(archive);
    totals_.state(archive);
}

std::size_t PhotonChains::memory_bytes() const {
    std::size_t bytes = reach_.memory_bytes();
    for (const Chain& chain : chains_) {
        bytes += sizeof(Chain) + chain.coordinate_bytes() +
                 (chain.current().capacity() + chain.proposed().capacity()) * sizeof(Photon);
    }
    return bytes;
}

std::size_t PhotonChains::memory_bound_bytes(const Settings& settings, std::uint32_t eye_paths) {
    const std::size_t state = max_coordinates(most_surfaces(settings)) * sizeof(Coordinate) +
                              most_photons_per_path(settings) * sizeof(Photon);
    // A current and a proposed state; what lasts from the last round is recorded in this one too.
    const std::size_t carried = 2 * sizeof(Photon) * most_photons_per_path(settings);
    return PointGrid::memory_bound_bytes(eye_paths) +
           kMostChains * (sizeof(Chain) + kVectorGrowth * (2 * state + carried));
}

}  // namespace aips
