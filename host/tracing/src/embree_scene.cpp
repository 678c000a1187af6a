// Embree behind EmbreeScene.
//
// Determinism. Hierarchies are built on all threads, and are the same for any number of them, in
// this version of Embree: its SAH builder for static scenes splits sets of triangles by sums and
// boxes of bins, which know no order, and sorts a set by geometry and primitive before it becomes a
// leaf or is split in the middle (`deterministic_order` in
// kernels/builders/heuristic_binning_array_aligned.h). Closest hits need that: which of several
// surfaces at one distance a ray meets goes by the order of leaves and in them, and Embree compares
// distances before it divides by the determinant, so that those a rounding apart are no better. No
// filter can break such ties by id, since a hit that the comparison drops never reaches it.
// tests/big_scenes holds hierarchies of 1 to 8 threads against each other, by all hits in the order
// in which they are met: another version of Embree that builds otherwise fails there.
//
// Floating-point mode. Embree suggests flush-to-zero for speed with denormal numbers. The mode is
// left alone here: it belongs to a thread, and bits must not depend on which thread runs a path.
#include "embree_scene.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "lxs/embree/queries.h"

namespace lxs {

/// The first error of a device since it was last asked, with what Embree says of it.
class EmbreeErrors {
  public:
    /// Embree calls it on whatever thread met the error.
    static void note(void* errors, RTCError code, const char* text) {
        auto& self = *static_cast<EmbreeErrors*>(errors);
        const std::lock_guard lock(self.mutex_);
        if (self.code_ != RTC_ERROR_NONE) return;
        self.code_ = code;
        self.text_ = text != nullptr ? text : "";
    }
    /// Throws what was noted, if anything.
    void check() {
        const std::lock_guard lock(mutex_);
        const RTCError code = std::exchange(code_, RTC_ERROR_NONE);
        if (code != RTC_ERROR_NONE) fail(code, text_);
    }
    [[noreturn]] static void fail(RTCError code, const std::string& text) {
        if (code == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
        throw std::runtime_error("the ray-tracing library Embree fails: error " +
                                 std::to_string(static_cast<int>(code)) +
                                 (text.empty() ? text : ", " + text));
    }

  private:
    std::mutex mutex_;
    RTCError code_ = RTC_ERROR_NONE;
    std::string text_;
};

struct EmbreeDevice::Handle {
    Handle() : device(rtcNewDevice(nullptr)) {
        if (!device) EmbreeErrors::fail(rtcGetDeviceError(nullptr), "it can't start");
        rtcSetDeviceErrorFunction(device, &EmbreeErrors::note, &errors);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() { rtcReleaseDevice(device); }
    RTCDevice device;
    EmbreeErrors errors;
};

struct EmbreeScene::Handle {
    explicit Handle(std::shared_ptr<EmbreeDevice::Handle> owner)
        : device(std::move(owner)), scene(rtcNewScene(device->device)) {
        device->errors.check();
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() { rtcReleaseScene(scene); }
    std::shared_ptr<EmbreeDevice::Handle> device;
    RTCScene scene;
};

namespace {

// The thread sanitizer can't see how the library's threads wait for each other.
#ifdef __SANITIZE_THREAD__
constexpr bool kBuildsOnOneThread = true;
#else
constexpr bool kBuildsOnOneThread = false;
#endif

void attach(RTCScene scene, RTCGeometry geometry, std::uint32_t id, SurfaceClass surface_class) {
    rtcSetGeometryMask(geometry, static_cast<unsigned>(surface_class));
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
}

void quadric_bounds(const RTCBoundsFunctionArguments* args) {
    const Bounds box = static_cast<const QuadricShape*>(args->geometryUserPtr)->bounds();
    args->bounds_o->lower_x = box.min.x;
    args->bounds_o->lower_y = box.min.y;
    args->bounds_o->lower_z = box.min.z;
    args->bounds_o->upper_x = box.max.x;
    args->bounds_o->upper_y = box.max.y;
    args->bounds_o->upper_z = box.max.z;
}

bool meets_quadric(const void* quadric, const RTCRay& ray, float& distance) {
    return static_cast<const QuadricShape*>(quadric)->intersect(
        Vec3(ray.org_x, ray.org_y, ray.org_z), Vec3(ray.dir_x, ray.dir_y, ray.dir_z), ray.tnear,
        ray.tfar, distance);
}

void intersect_quadric(const RTCIntersectFunctionNArguments* args) {
    if (args->N != 1 || !args->valid[0]) return;
    // A group of one ray has the layout of the single ray.
    auto& ray_hit = *reinterpret_cast<RTCRayHit*>(args->rayhit);
    float distance = 0;
    if (!meets_quadric(args->geometryUserPtr, ray_hit.ray, distance)) return;
    ray_hit.ray.tfar = distance;
    ray_hit.hit.u = ray_hit.hit.v = 0;
    ray_hit.hit.geomID = args->geomID;
    ray_hit.hit.primID = args->primID;
    ray_hit.hit.instID[0] = args->context->instID[0];
}

void occlude_quadric(const RTCOccludedFunctionNArguments* args) {
    if (args->N != 1 || !args->valid[0]) return;
    auto& ray = *reinterpret_cast<RTCRay*>(args->ray);
    float distance = 0;
    if (meets_quadric(args->geometryUserPtr, ray, distance))
        ray.tfar = -std::numeric_limits<float>::infinity();
}

RTCRay kernel_ray(const Ray& ray, float t_min, SurfaceClass seen, double time) {
    RTCRay r;
    r.org_x = ray.origin.x;
    r.org_y = ray.origin.y;
    r.org_z = ray.origin.z;
    r.tnear = t_min;
    r.dir_x = ray.direction.x;
    r.dir_y = ray.direction.y;
    r.dir_z = ray.direction.z;
    r.time = static_cast<float>(std::clamp(time, 0.0, 1.0));
    r.tfar = ray.t_max;
    r.mask = static_cast<unsigned>(seen);
    r.id = 0;
    r.flags = 0;
    return r;
}

}  // namespace

EmbreeDevice::EmbreeDevice() : handle_(std::make_shared<Handle>()) {
    distinguishes_classes_ =
        rtcGetDeviceProperty(handle_->device, RTC_DEVICE_PROPERTY_RAY_MASK_SUPPORTED) != 0;
}

EmbreeScene::EmbreeScene(const EmbreeDevice& device)
    : handle_(std::make_unique<Handle>(device.handle_)) {}
EmbreeScene::EmbreeScene(EmbreeScene&&) noexcept = default;
EmbreeScene& EmbreeScene::operator=(EmbreeScene&&) noexcept = default;
EmbreeScene::~EmbreeScene() = default;

void EmbreeScene::add_mesh(std::uint32_t id, const TriangleMesh& mesh, SurfaceClass surface_class) {
    const RTCGeometry geometry =
        rtcNewGeometry(handle_->device->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    handle_->device->errors.check();
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               mesh.positions.data(), 0, sizeof(Vec3), mesh.positions.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.indices.data(), 0, 3 * sizeof(std::uint32_t),
                               mesh.indices.size() / 3);
    attach(handle_->scene, geometry, id, surface_class);
}

void EmbreeScene::add_quadric(std::uint32_t id, const QuadricShape& quadric,
                              SurfaceClass surface_class) {
    const RTCGeometry geometry = rtcNewGeometry(handle_->device->device, RTC_GEOMETRY_TYPE_USER);
    handle_->device->errors.check();
    rtcSetGeometryUserPrimitiveCount(geometry, 1);
    // Only read through the pointer: the callbacks cast to const.
    rtcSetGeometryUserData(geometry, const_cast<QuadricShape*>(&quadric));
    rtcSetGeometryBoundsFunction(geometry, quadric_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_quadric);
    rtcSetGeometryOccludedFunction(geometry, occlude_quadric);
    attach(handle_->scene, geometry, id, surface_class);
}

void EmbreeScene::add_instance(std::uint32_t id, const EmbreeScene& object,
                               const Matrix& to_world) {
    add_instance(id, object, std::span(&to_world, 1));
}

void EmbreeScene::add_instance(std::uint32_t id, const EmbreeScene& object,
                               std::span<const Matrix> steps) {
    const RTCGeometry geometry =
        rtcNewGeometry(handle_->device->device, RTC_GEOMETRY_TYPE_INSTANCE);
    handle_->device->errors.check();
    rtcSetGeometryInstancedScene(geometry, object.handle_->scene);
    rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(steps.size()));
    for (unsigned step = 0; step < steps.size(); ++step) {
        float columns[12];  // images of the axes, then the translation
        for (int row = 0; row < 4; ++row) {
            for (int i = 0; i < 3; ++i)
                columns[3 * row + i] = static_cast<float>(steps[step][row][i]);
        }
        rtcSetGeometryTransform(geometry, step, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
    }
    attach(handle_->scene, geometry, id, SurfaceClass::Any);
}

void EmbreeScene::set_times(double begin, double end) {
    time_begin_ = begin;
    time_scale_ = 1 / (end - begin);
}

void EmbreeScene::commit() {
    if (kBuildsOnOneThread) {
        tbb::task_arena(1).execute([&] { rtcCommitScene(handle_->scene); });
    } else {
        rtcCommitScene(handle_->scene);
    }
    handle_->device->errors.check();
}

bool EmbreeScene::intersect(const Ray& ray, float t_min, SurfaceClass seen, RawHit& hit) const {
    RTCRayHit query;
    query.ray = kernel_ray(ray, t_min, seen, (ray.time - time_begin_) * time_scale_);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree::intersect(handle_->scene, query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    static_assert(kNoInstance == RTC_INVALID_GEOMETRY_ID);
    hit = {query.ray.tfar,   query.hit.u,      query.hit.v,
           query.hit.geomID, query.hit.primID, query.hit.instID[0]};
    return true;
}

bool EmbreeScene::occluded(const Ray& ray, SurfaceClass seen) const {
    RTCRay query = kernel_ray(ray, kSmallestDistance, seen, (ray.time - time_begin_) * time_scale_);
    embree::occluded(handle_->scene, query);
    return query.tfar < 0;
}

}  // namespace lxs
