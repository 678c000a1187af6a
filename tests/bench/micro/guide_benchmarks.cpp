// The guide's parts: node look-up, tables, products, learning. Beside them what cannot be saved:
// reading the input, and drawing the direction from a Lambert lobe instead.
#include <benchmark/benchmark.h>

#include "aips/core/base/arena.h"
#include "aips/core/sampling/random.h"
#include "aips/core/tables/directional_table.h"
#include "aips/core/trees/score_cache.h"
#include "guides/paper/paper_guide.h"
#include "memory_floor.h"
#include "photon_workload.h"

namespace aips::bench {
namespace {

constexpr std::uint32_t kPathsPerUpdate = 1000;

/// Visible points: enough photons to spread weights over the scene.
std::vector<Vec3> some_positions() {
    std::vector<Vec3> positions;
    const std::vector<Photon>& photons = photon_workload().photons;
    for (std::size_t i = 0; i < photons.size(); i += 16)
        positions.push_back(photons[i].position);
    return positions;
}

/// A guide that has learned from the whole workload.
PaperGuide trained_guide() {
    const PhotonWorkload& work = photon_workload();
    PaperGuide guide(work.scene->bounds(), {});
    const std::vector<Vec3> eye = some_positions();
    guide.begin_pass(eye, eye.size());
    for (std::uint32_t first = 0; first < work.paths; first += kPathsPerUpdate)
        guide.update(photons_of_paths(first, kPathsPerUpdate), {});
    return guide;
}

std::vector<Vec2> random_points() {
    std::vector<Vec2> points(4096);
    RandomStream random(1, 0, 0, RandomDomain::Photon);
    for (Vec2& point : points)
        point = random.next2();
    return points;
}

DirectionalTable filled_table(int resolution) {
    std::vector<float> weights(std::size_t(resolution) * std::size_t(resolution));
    RandomStream random(2, 0, 0, RandomDomain::Photon);
    for (float& weight : weights)
        weight = random.next();
    DirectionalTable table(resolution);
    table.build(weights);
    return table;
}

void read_positions(benchmark::State& state) {
    const std::vector<Vec3> positions = some_positions();
    std::size_t i = 0;
    for ([[maybe_unused]] auto _ : state) {
        Vec3 position = positions[i++ % positions.size()];
        benchmark::DoNotOptimize(position);
    }
    state.SetItemsProcessed(state.iterations());
}

void node_lookup(benchmark::State& state) {
    const PaperGuide guide = trained_guide();
    const std::vector<Vec3> positions = some_positions();
    std::size_t i = 0;
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(guide.tree().locate(positions[i++ % positions.size()]));
    state.SetItemsProcessed(state.iterations());
    state.counters["nodes"] = double(guide.tree().node_count());
}

/// Normal on the side where the photon arrived.
Vec3 arrival_normal(const Photon& photon) {
    return dot(photon.normal, photon.direction) < 0 ? -photon.normal : photon.normal;
}

/// What roulette by score adds to every bounce; photons stand for vertices, their power for a
/// score.
void score_lookup(benchmark::State& state) {
    const PhotonWorkload& work = photon_workload();
    constexpr int kRounds = 12;
    ScoreCache cache(work.scene->bounds());
    for (int round = 0; round < kRounds; ++round) {
        for (const Photon& photon : work.photons)
            cache.add({photon.position, arrival_normal(photon), double(photon.power.g), 2});
        cache.update(work.paths);
    }
    std::size_t i = 0;
    for ([[maybe_unused]] auto _ : state) {
        const Photon& photon = work.photons[i++ % work.photons.size()];
        benchmark::DoNotOptimize(cache.at(photon.position, arrival_normal(photon)));
    }
    state.SetItemsProcessed(state.iterations());
    state.counters["leaves"] = double(cache.leaf_count());
}

void sample_lambert(benchmark::State& state) {
    const std::vector<Vec2> points = random_points();
    std::size_t i = 0;
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(square_to_cosine_hemisphere(points[i++ % points.size()]));
    state.SetItemsProcessed(state.iterations());
}

void table_sample(benchmark::State& state) {
    const DirectionalTable table = filled_table(int(state.range(0)));
    const std::vector<Vec2> points = random_points();
    std::size_t i = 0;
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(sample_direction(table, points[i++ % points.size()]));
    state.SetItemsProcessed(state.iterations());
}

void table_pdf(benchmark::State& state) {
    const DirectionalTable table = filled_table(int(state.range(0)));
    const std::vector<Photon>& photons = photon_workload().photons;
    std::size_t i = 0;
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(direction_pdf(table, photons[i++ % photons.size()].direction));
    state.SetItemsProcessed(state.iterations());
}

void table_build(benchmark::State& state) {
    DirectionalTable table(static_cast<int>(state.range(0)));
    const std::vector<Vec2> points = random_points();
    std::vector<float> weights(std::size_t(state.range(0) * state.range(0)));
    for (std::size_t i = 0; i < weights.size(); ++i)
        weights[i] = points[i % points.size()].x;
    for ([[maybe_unused]] auto _ : state) {
        table.build(weights);
        benchmark::DoNotOptimize(table);
    }
    report_bytes(state, 2 * weights.size() * sizeof(float));
}

/// Learning from 1000 photon paths; passes begin anew when the workload is used up. The floor is
/// reading the photons once.
void guide_update_1000_paths(benchmark::State& state) {
    const PhotonWorkload& work = photon_workload();
    const std::vector<Vec3> eye = some_positions();
    PaperGuide guide = trained_guide();
    std::uint32_t first = work.paths;
    for ([[maybe_unused]] auto _ : state) {
        if (first >= work.paths) {
            state.PauseTiming();
            guide.begin_pass(eye, eye.size());
            first = 0;
            state.ResumeTiming();
        }
        guide.update(photons_of_paths(first, kPathsPerUpdate), {});
        first += kPathsPerUpdate;
    }
    state.SetItemsProcessed(state.iterations() * kPathsPerUpdate);
    report_bytes(state, work.photons.size() * sizeof(Photon) * kPathsPerUpdate / work.paths);
}

BENCHMARK(read_positions);
BENCHMARK(node_lookup);
BENCHMARK(score_lookup);
BENCHMARK(sample_lambert);
BENCHMARK(table_sample)->Arg(4)->Arg(8)->Arg(16);
BENCHMARK(table_pdf)->Arg(4)->Arg(8)->Arg(16);
BENCHMARK(table_build)->Arg(4)->Arg(8)->Arg(16);
BENCHMARK(guide_update_1000_paths)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace aips::bench
