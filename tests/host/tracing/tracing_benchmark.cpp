// Rays per second of Scene::intersect against the bare kernel, and the time to build a scene.
#include <benchmark/benchmark.h>
#include <tbb/task_arena.h>

#include <array>
#include <cmath>
#include <random>

#include "fakes.h"
#include "lxs/embree/queries.h"

namespace lxs::test {
namespace {

/// A wavy grid of 2 * size * size triangles over the unit square, with or without coordinates.
TriangleMesh terrain(std::uint32_t size, bool smooth) {
    TriangleMesh mesh;
    for (std::uint32_t y = 0; y <= size; ++y) {
        for (std::uint32_t x = 0; x <= size; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(size);
            const float v = static_cast<float>(y) / static_cast<float>(size);
            mesh.positions.emplace_back(u, v, 0.05f * std::sin(20 * u) * std::cos(15 * v));
            if (!smooth) continue;
            mesh.normals.emplace_back(0, 0, 1);
            mesh.uvs.emplace_back(u, v);
        }
    }
    for (std::uint32_t y = 0; y < size; ++y) {
        for (std::uint32_t x = 0; x < size; ++x) {
            const std::uint32_t a = y * (size + 1) + x, b = a + size + 1;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
    }
    return mesh;
}

std::vector<Ray> rays_down() {
    std::mt19937 random(1);
    const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    constexpr int kRays = 1 << 14;
    std::vector<Ray> rays;
    rays.reserve(kRays);
    for (int i = 0; i < kRays; ++i) {
        rays.push_back(
            ray(Vec3(uniform(), uniform(), 1), Vec3(uniform() - 0.5f, uniform() - 0.5f, -2)));
    }
    return rays;
}

void bare_kernel(benchmark::State& state) {
    TriangleMesh mesh = terrain(static_cast<std::uint32_t>(state.range(0)), false);
    mesh.positions.reserve(mesh.positions.size() + 1);
    const RTCDevice device = rtcNewDevice(nullptr);
    const RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               mesh.positions.data(), 0, 12, mesh.positions.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.indices.data(), 0, 12, mesh.indices.size() / 3);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    tbb::task_arena(1).execute([&] { rtcCommitScene(scene); });
    const std::vector<Ray> rays = rays_down();
    std::size_t i = 0;
    for ([[maybe_unused]] auto _ : state) {
        const Ray& r = rays[i++ % rays.size()];
        RTCRayHit query{};
        query.ray.org_x = r.origin.x, query.ray.org_y = r.origin.y, query.ray.org_z = r.origin.z;
        query.ray.dir_x = r.direction.x, query.ray.dir_y = r.direction.y;
        query.ray.dir_z = r.direction.z;
        query.ray.tfar = r.t_max;
        query.ray.mask = ~0u;
        query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        embree::intersect(scene, query);
        benchmark::DoNotOptimize(query);
    }
    state.SetItemsProcessed(state.iterations());
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
}

void measure(benchmark::State& state, const Scene& scene) {
    const std::vector<Ray> rays = rays_down();
    std::array<std::byte, 1024> buffer;
    std::size_t i = 0;
    for ([[maybe_unused]] auto _ : state) {
        std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size(),
                                                   std::pmr::null_memory_resource());
        SurfaceHit result;
        benchmark::DoNotOptimize(scene.intersect(rays[i++ % rays.size()], result, memory));
        benchmark::DoNotOptimize(result);
    }
    state.SetItemsProcessed(state.iterations());
}

void flat_triangles(benchmark::State& state) {
    const auto size = static_cast<std::uint32_t>(state.range(0));
    measure(state, *trace({primitive(terrain(size, false))}));
}
void smooth_textured_triangles(benchmark::State& state) {
    const auto size = static_cast<std::uint32_t>(state.range(0));
    measure(state, *trace({primitive(terrain(size, true))}));
}
void instanced_triangles(benchmark::State& state) {
    const auto size = static_cast<std::uint32_t>(state.range(0));
    measure(state, *trace(instanced({primitive(terrain(size, false))}, {Matrix()})));
}
void spheres(benchmark::State& state) {
    measure(state, *trace({primitive(sphere(5, translation(0.5, 0.5, -5)))}));
}
void shadow_rays(benchmark::State& state) {
    const auto scene =
        trace({primitive(terrain(static_cast<std::uint32_t>(state.range(0)), false))});
    const std::vector<Ray> rays = rays_down();
    std::size_t i = 0;
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(scene->transmittance(rays[i++ % rays.size()]));
    state.SetItemsProcessed(state.iterations());
}
void build_million_triangles(benchmark::State& state) {
    const TriangleMesh mesh = terrain(708, false);
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(trace({primitive(mesh)}));
}

BENCHMARK(bare_kernel)->Arg(4)->Arg(64)->Arg(512);
BENCHMARK(flat_triangles)->Arg(4)->Arg(64)->Arg(512);
BENCHMARK(smooth_textured_triangles)->Arg(4)->Arg(64)->Arg(512);
BENCHMARK(instanced_triangles)->Arg(64);
BENCHMARK(spheres);
BENCHMARK(shadow_rays)->Arg(4)->Arg(64);
BENCHMARK(build_million_triangles)->Unit(benchmark::kMillisecond)->Iterations(3);

}  // namespace
}  // namespace lxs::test

BENCHMARK_MAIN();
