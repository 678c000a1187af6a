// Nearest-hit and occlusion queries: the one place that knows Embree and its version.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "lxs/scene/geometry.h"
#include "lxs/sdk/types.h"
#include "quadric_shape.h"

namespace lxs {

/// What the ray-tracing kernel knows of a hit; the rest is reconstructed from it.
struct RawHit {
    float distance = 0;
    double u = 0, v = 0;          ///< barycentric weights of corners 1 and 2 (triangles only)
    std::uint32_t geometry = 0;   ///< id given to `add_*` of the scene that holds the geometry
    std::uint32_t primitive = 0;  ///< triangle of the mesh
    std::uint32_t instance = 0;   ///< id given to `add_instance`, or kNoInstance
};

inline constexpr std::uint32_t kNoInstance = ~0u;

/// Classes of surfaces, as bits: which of them a query sees.
enum class SurfaceClass : std::uint32_t {
    Opaque = 1,    ///< no light passes undeviated
    Straight = 2,  ///< null, architectural glass and mixes with them
    Any = 3
};

/// The library's state; outlives the scenes made with it (they share it).
class EmbreeDevice {
  public:
    EmbreeDevice();
    /// True if queries restricted to a SurfaceClass see only that class; else they see all.
    bool distinguishes_classes() const { return distinguishes_classes_; }

  private:
    friend class EmbreeScene;
    struct Handle;
    std::shared_ptr<Handle> handle_;
    bool distinguishes_classes_ = false;
};

/// Geometry with its hierarchy. Meshes, quadrics and object scenes are referred to, not copied:
/// they must outlive it and stay where they are.
class EmbreeScene {
  public:
    explicit EmbreeScene(const EmbreeDevice& device);
    EmbreeScene(EmbreeScene&&) noexcept;
    EmbreeScene& operator=(EmbreeScene&&) noexcept;
    ~EmbreeScene();

    /// `id` is unique in this scene, instances included. The vector of positions must have capacity
    /// for one more vertex: the kernel reads 16 bytes at each.
    void add_mesh(std::uint32_t id, const TriangleMesh& mesh, SurfaceClass surface_class);
    void add_quadric(std::uint32_t id, const QuadricShape& quadric, SurfaceClass surface_class);
    void add_instance(std::uint32_t id, const EmbreeScene& object, const Matrix& to_world);
    /// `steps`: transforms at equal steps of the scene's times, at most 129.
    void add_instance(std::uint32_t id, const EmbreeScene& object, std::span<const Matrix> steps);
    /// The times between which instances move; rays before and after see the ends.
    void set_times(double begin, double end);

    /// Builds the hierarchy; throws std::runtime_error if the library reports an error.
    void commit();

    /// Nearest hit with distance in [t_min, ray.t_max]; t_min > 0 keeps a ray that starts exactly
    /// on a surface from meeting it again.
    bool intersect(const Ray& ray, float t_min, SurfaceClass seen, RawHit& hit) const;
    /// True if anything of the class lies on the ray up to ray.t_max.
    bool occluded(const Ray& ray, SurfaceClass seen) const;

  private:
    struct Handle;
    std::unique_ptr<const Handle> handle_;
    double time_begin_ = 0, time_scale_ = 0;  ///< to the kernel's time from 0 to 1
};

/// Smallest distance of a hit: excludes distance zero, sets no length scale.
inline constexpr float kSmallestDistance = std::numeric_limits<float>::min();

}  // namespace lxs
