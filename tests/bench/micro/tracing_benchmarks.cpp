// Photon rays through the engine's scene, and its floor: Embree alone on the same rays and shapes.
#include <benchmark/benchmark.h>
#include <tbb/task_arena.h>

#include "aips/core/base/arena.h"
#include "lxs/embree/queries.h"
#include "photon_workload.h"

namespace aips::bench {
namespace {

/// The scene's triangles, and its spheres as Embree's own; no materials.
class BareScene {
  public:
    explicit BareScene(std::span<const lxs::Geometry> geometry)
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        for (const lxs::Geometry& shape : geometry)
            std::visit([&](const auto& s) { add(s); }, shape);
        tbb::task_arena(1).execute([&] { rtcCommitScene(scene_); });
    }
    BareScene(const BareScene&) = delete;
    BareScene& operator=(const BareScene&) = delete;
    ~BareScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    RTCScene handle() const { return scene_; }

  private:
    void attach(RTCGeometry geometry) {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
    }
    void add(const lxs::TriangleMesh& mesh) {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.positions.size()));
        for (const lxs::Vec3& p : mesh.positions) {
            for (int axis = 0; axis < 3; ++axis)
                *positions++ = p[axis];
        }
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.indices.size() / 3));
        std::copy(mesh.indices.begin(), mesh.indices.end(), indices);
        attach(geometry);
    }
    /// Whole spheres, moved but not scaled: the only quadrics of the scene recorded.
    void add(const lxs::Quadric& quadric) {
        const auto& sphere = std::get<lxs::Sphere>(quadric.shape);
        lxs::Vec3 center;
        quadric.to_world.multVecMatrix(lxs::Vec3(0.0f), center);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        auto* point = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16, 1));
        point[0] = center.x, point[1] = center.y, point[2] = center.z, point[3] = sphere.radius;
        attach(geometry);
    }

    RTCDevice device_;
    RTCScene scene_;
};

void trace_bare_kernel(benchmark::State& state) {
    const PhotonWorkload& work = photon_workload();
    const BareScene scene(work.geometry);
    std::size_t i = 0;
    for ([[maybe_unused]] auto _ : state) {
        const Ray& r = work.rays[i++ % work.rays.size()];
        RTCRayHit query{};
        query.ray.org_x = r.origin.x, query.ray.org_y = r.origin.y, query.ray.org_z = r.origin.z;
        query.ray.dir_x = r.direction.x, query.ray.dir_y = r.direction.y;
        query.ray.dir_z = r.direction.z;
        query.ray.tfar = std::numeric_limits<float>::infinity();
        query.ray.mask = ~0u;
        query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        lxs::embree::intersect(scene.handle(), query);
        benchmark::DoNotOptimize(query);
    }
    state.SetItemsProcessed(state.iterations());
}

void trace_engine_scene(benchmark::State& state) {
    const PhotonWorkload& work = photon_workload();
    Arena arena;
    std::size_t i = 0;
    for ([[maybe_unused]] auto _ : state) {
        arena.reset();
        SurfacePoint point;
        benchmark::DoNotOptimize(
            work.scene->intersect(work.rays[i++ % work.rays.size()], point, arena));
        benchmark::DoNotOptimize(point);
    }
    state.SetItemsProcessed(state.iterations());
}

BENCHMARK(trace_bare_kernel);
BENCHMARK(trace_engine_scene);

}  // namespace
}  // namespace aips::bench
