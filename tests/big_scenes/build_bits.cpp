// Protects that Embree builds the same hierarchy on any number of threads, upon which the host's
// bits rest (host/tracing/src/embree_scene.cpp): for scenes with and without coincident surfaces,
// built by 1, 2, 3 and 8 threads, all hits of random rays come in the same order and the closest
// are the same.
//
//     build-bits [TRIANGLES [RAYS]]
//
// Exit code 1 if they differ.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "lxs/embree/queries.h"
#include "run_on_threads.h"

namespace {

struct Mesh {
    std::vector<float> positions;
    std::vector<std::uint32_t> corners;

    void add_vertex(float x, float y, float z) { positions.insert(positions.end(), {x, y, z}); }
    std::uint32_t vertices() const { return static_cast<std::uint32_t>(positions.size() / 3); }
};

/// A wavy grid over [-1, 1]^2, `copies` times.
Mesh terrain(std::size_t triangles, int copies) {
    Mesh mesh;
    const auto side = static_cast<std::uint32_t>(
        std::max(1.0, std::sqrt(static_cast<double>(triangles) / (2 * copies))));
    for (int copy = 0; copy < copies; ++copy) {
        const std::uint32_t base = mesh.vertices();
        for (std::uint32_t j = 0; j <= side; ++j) {
            for (std::uint32_t i = 0; i <= side; ++i) {
                const float x = 2.0f * static_cast<float>(i) / static_cast<float>(side) - 1;
                const float y = 2.0f * static_cast<float>(j) / static_cast<float>(side) - 1;
                mesh.add_vertex(x, y, 0.1f * std::sin(7 * x) * std::cos(5 * y));
            }
        }
        for (std::uint32_t j = 0; j < side; ++j) {
            for (std::uint32_t i = 0; i < side; ++i) {
                const std::uint32_t a = base + j * (side + 1) + i, b = a + side + 1;
                mesh.corners.insert(mesh.corners.end(), {a, a + 1, b + 1, a, b + 1, b});
            }
        }
    }
    return mesh;
}

/// One triangle many times: no split of the set is better than another.
Mesh one_place(std::size_t triangles) {
    Mesh mesh;
    mesh.positions = {-1, -1, 0, 3, -1, 0, -1, 3, 0};
    for (std::size_t i = 0; i < triangles; ++i)
        mesh.corners.insert(mesh.corners.end(), {0, 1, 2});
    return mesh;
}

/// Triangles of sizes from 0.0001 to 1, every second one twice.
Mesh soup(std::size_t triangles) {
    Mesh mesh;
    std::mt19937 random(5);
    const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-23f - 1; };
    for (std::size_t i = 0; i < triangles; i += 2) {
        const std::uint32_t first = mesh.vertices();
        const float size = std::pow(10.0f, 2 * uniform() - 2);
        const float x = uniform(), y = uniform(), z = uniform();
        for (int k = 0; k < 3; ++k)
            mesh.add_vertex(x + size * uniform(), y + size * uniform(), z + size * uniform());
        mesh.corners.insert(mesh.corners.end(), {first, first + 1, first + 2});
        if (i % 4 == 0) mesh.corners.insert(mesh.corners.end(), {first, first + 1, first + 2});
    }
    return mesh;
}

void attach(RTCScene scene, RTCGeometry geometry) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

void add_mesh(RTCDevice device, RTCScene scene, Mesh& mesh) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const std::size_t vertices = mesh.vertices();
    mesh.positions.reserve(mesh.positions.size() + 4);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               mesh.positions.data(), 0, 12, vertices);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.corners.data(), 0, 12, mesh.corners.size() / 3);
    attach(scene, geometry);
}

void add_instance(RTCDevice device, RTCScene scene, RTCScene object, float raised) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, object);
    const std::array<float, 12> frame = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, raised};
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, frame.data());
    attach(scene, geometry);
}

RTCScene new_scene(RTCDevice device) {
    const RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | lxs::embree::kFilteredByQueries);
    return scene;
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
    return (hash ^ value) * 0x9E3779B97F4A7C15 + (hash >> 29);
}

std::uint64_t with_hit(std::uint64_t hash, const RTCHit& hit, float distance) {
    hash = mixed(hash, std::uint64_t{hit.geomID} << 32 | hit.primID);
    return mixed(hash, std::uint64_t{hit.instID[0]} << 32 | std::bit_cast<std::uint32_t>(distance));
}

struct Recorder {
    lxs::embree::QueryContext context;  // first: Embree hands out a pointer to it
    std::uint64_t hash = 0;
};

void record(const RTCFilterFunctionNArguments* args) {
    auto& recorder = *reinterpret_cast<Recorder*>(args->context);
    RTCHit hit = rtcGetHitFromHitN(args->hit, args->N, 0);
    recorder.hash = with_hit(recorder.hash, hit, rtcGetRayFromRayN(args->ray, args->N, 0).tfar);
    args->valid[0] = 0;
}

RTCRayHit random_ray(std::uint64_t number) {
    std::uint64_t state = number;
    const auto uniform = [&] {
        state = mixed(state + 0x632BE59BD9B4E019, number);
        return static_cast<float>(state >> 40) * 0x1p-23f - 1;
    };
    RTCRayHit query{};
    query.ray.org_x = uniform();
    query.ray.org_y = uniform();
    query.ray.org_z = 2;
    const bool oblique = number % 4 != 0;
    query.ray.dir_x = oblique ? uniform() : 0;
    query.ray.dir_y = oblique ? uniform() : 0;
    query.ray.dir_z = -2;
    query.ray.tfar = std::numeric_limits<float>::infinity();
    query.ray.mask = ~0u;
    query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return query;
}

/// Of the hits of these rays in the order in which they are met, and of the closest.
std::uint64_t hash_of_hits(RTCScene scene, std::uint64_t rays) {
    std::atomic<std::uint64_t> sum{0};
    tbb::parallel_for(tbb::blocked_range<std::uint64_t>(0, rays, 1024), [&](const auto& range) {
        std::uint64_t own = 0;
        for (std::uint64_t i = range.begin(); i != range.end(); ++i) {
            Recorder recorder;
            RTCRayHit all = random_ray(i), closest = all;
            lxs::embree::intersect_filtered(scene, all, record, recorder.context);
            lxs::embree::intersect(scene, closest);
            own += mixed(with_hit(recorder.hash, closest.hit, closest.ray.tfar), i);
        }
        sum += own;
    });
    return sum;
}

struct Case {
    const char* name;
    std::uint64_t rays;
    /// Adds its geometry.
    std::function<void(RTCDevice, RTCScene)> fill;
};

struct Built {
    std::uint64_t hash;
    double seconds;
};

Built build(const Case& one, unsigned threads) {
    const RTCDevice device = rtcNewDevice(nullptr);
    const RTCScene scene = new_scene(device);
    one.fill(device, scene);
    const auto begin = std::chrono::steady_clock::now();
    concurrency::run_on(threads, [&] { rtcCommitScene(scene); });
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const Built result{hash_of_hits(scene, one.rays), seconds};
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
    return result;
}

bool same_for_any_threads(const Case& one) {
    bool same = true;
    std::uint64_t expected = 0;
    for (const unsigned threads : {1u, 2u, 3u, 8u}) {
        const Built built = build(one, threads);
        if (threads == 1) expected = built.hash;
        same &= built.hash == expected;
        std::printf("%s, %llu rays, built by %u: %016llx in %.2f s\n", one.name,
                    static_cast<unsigned long long>(one.rays), threads,
                    static_cast<unsigned long long>(built.hash), built.seconds);
    }
    if (!same) std::printf("%s: hierarchies differ\n", one.name);
    return same;
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t triangles = argc > 1 ? std::stoull(argv[1]) : 200'000;
    const std::uint64_t rays = argc > 2 ? std::stoull(argv[2]) : 20'000;
    Mesh plain = terrain(triangles, 1), folded = terrain(triangles, 8), other = folded,
         one = one_place(std::min<std::size_t>(triangles, 50'000)), mixture = soup(triangles);
    const std::vector<Case> cases = {
        {"terrain", rays, [&](RTCDevice d, RTCScene s) { add_mesh(d, s, plain); }},
        {"coincident terrains", rays,
         [&](RTCDevice d, RTCScene s) {
             add_mesh(d, s, folded);
             add_mesh(d, s, other);
         }},
        {"one triangle many times", std::min<std::uint64_t>(rays, 64),
         [&](RTCDevice d, RTCScene s) { add_mesh(d, s, one); }},
        {"soup", std::min<std::uint64_t>(rays / 8, 20000),
         [&](RTCDevice d, RTCScene s) { add_mesh(d, s, mixture); }},
        {"coincident instances", std::min<std::uint64_t>(rays, 64), [&](RTCDevice d, RTCScene s) {
             const RTCScene object = new_scene(d);
             add_mesh(d, object, plain);
             rtcCommitScene(object);
             for (int i = 0; i < 5000; ++i)
                 add_instance(d, s, object, static_cast<float>(i % 3) * 0.01f);
             rtcReleaseScene(object);
         }}};
    bool same = true;
    for (const Case& c : cases)
        same &= same_for_any_threads(c);
    return same ? 0 : 1;
}
