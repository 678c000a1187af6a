// Photons stored, sorted and gathered, by one thread, beside the bandwidth bound: bytes that must
// be touched over the speed of a copy.
#include <benchmark/benchmark.h>
#include <tbb/task_arena.h>

#include <cstring>

#include "estimate/gather.h"
#include "memory_floor.h"
#include "photon_workload.h"
#include "photons/photon_iteration.h"

namespace aips::bench {
namespace {

void copy_memory(benchmark::State& state) {
    const std::vector<char> from(std::size_t{1} << 26, 1);
    std::vector<char> to(from.size());
    for ([[maybe_unused]] auto _ : state) {
        std::memcpy(to.data(), from.data(), from.size());
        benchmark::ClobberMemory();
    }
    report_bytes(state, 2 * from.size());
}

/// Photons of blocks of 256 paths joined into the store.
void photon_store(benchmark::State& state) {
    constexpr std::uint32_t kBlock = 256;
    const PhotonWorkload& work = photon_workload();
    PhotonStore store;
    store.append(work.photons);  // takes its memory once, as in later passes
    std::vector<std::span<const Photon>> blocks;
    for (std::uint32_t first = 0; first < work.paths; first += kBlock)
        blocks.push_back(photons_of_paths(first, kBlock));
    for ([[maybe_unused]] auto _ : state) {
        store.clear();
        for (const std::span<const Photon> block : blocks)
            store.append(block);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * std::int64_t(work.photons.size()));
    report_bytes(state, 2 * work.photons.size() * sizeof(Photon));
}

/// Sorting must read each position and write it with an index.
void photon_grid_build(benchmark::State& state) {
    const std::vector<Photon>& photons = photon_workload().photons;
    PhotonGrid grid;
    for ([[maybe_unused]] auto _ : state) {
        grid.build(photons, 0.01f);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * std::int64_t(photons.size()));
    report_bytes(state, photons.size() * (2 * sizeof(Vec3) + sizeof(std::uint32_t)));
}

/// Matte visible points where photons land.
EyeImage visible_points() {
    EyeImage image;
    const std::vector<Photon>& photons = photon_workload().photons;
    for (std::size_t i = 0; i < photons.size(); i += 16) {
        VisiblePoint point;
        point.position = photons[i].position;
        point.geometric_normal = point.shading_normal = photons[i].normal;
        point.wo = photons[i].direction;
        point.kd = point.throughput = {0.5f, 0.5f, 0.5f};
        point.receiving = kDiffuse;
        point.sample = std::uint32_t(image.visible_points.size());
        image.visible_points.push_back(point);
    }
    return image;
}

/// The argument is the gather radius in thousandths (the box is 2 wide). Bytes: the visible points,
/// their flux, and the photons accepted.
void range_gather(benchmark::State& state) {
    const float radius = float(state.range(0)) * 1e-3f;
    const EyeImage image = visible_points();
    PhotonGrid grid;
    grid.build(photon_workload().photons, radius);
    InvalidSampleFilter filter;
    PhotonFlux flux;
    flux.reset(image.visible_points.size(), image.groups);
    tbb::task_arena one_thread(1);
    for ([[maybe_unused]] auto _ : state) {
        flux.counts = {};
        one_thread.execute([&] { gather_photons(image, grid, radius, filter, flux); });
        benchmark::ClobberMemory();
    }
    const auto points = image.visible_points.size();
    const auto accepted = std::size_t(flux.counts.photons);
    state.SetItemsProcessed(state.iterations() * std::int64_t(accepted));
    state.counters["photons_per_point"] = double(accepted) / double(points);
    report_bytes(state,
                 points * (sizeof(VisiblePoint) + 2 * sizeof(Rgb)) + accepted * sizeof(Photon));
}

BENCHMARK(copy_memory)->Unit(benchmark::kMillisecond);
BENCHMARK(photon_store)->Unit(benchmark::kMicrosecond);
BENCHMARK(photon_grid_build)->Unit(benchmark::kMicrosecond);
BENCHMARK(range_gather)->Arg(5)->Arg(15)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace aips::bench
