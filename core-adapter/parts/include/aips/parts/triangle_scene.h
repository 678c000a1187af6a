// A box of triangles for small scenes: matte, mirror and glass, lamps and points, no media, no
// motion. Thousands of triangles are fine; for millions take a real ray tracer.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "aips/adapter/scene.h"

namespace aips {

/// What triangles are made of.
struct TriangleMaterial {
    enum class Kind : std::uint8_t { Lambert, Mirror, Glass };
    Kind kind = Kind::Lambert;
    Rgb reflectance{0.5f, 0.5f, 0.5f};  ///< not of glass, which reflects by Fresnel
    float index = 1.5f;  ///< Glass: refractive index behind the front over that before it
    Rgb emitted{};       ///< radiance of the front; each such triangle is a light
    std::uint32_t light_group = 0;
    std::string name{};  ///< for reports
};

/// Corners in scene units; the front is where they run counterclockwise.
struct Triangle {
    Vec3 a, b, c;
};

class TriangleTree;

/// Triangles are added first, then finish() is called once; from then on it is a scene.
class TriangleScene final : public Scene {
  public:
    TriangleScene();
    ~TriangleScene() override;

    /// Its number, for the triangles made of it.
    std::uint32_t add_material(const TriangleMaterial& material);
    void add_triangle(const Triangle& triangle, std::uint32_t material);
    /// With unit shading normals at its corners, in the front's hemisphere: looks curved.
    void add_triangle(const Triangle& triangle, const Triangle& normals, std::uint32_t material);
    /// The parallelogram corner + s u + t v; its front is cross(u, v).
    void add_quad(Vec3 corner, Vec3 u, Vec3 v, std::uint32_t material);
    /// The six walls of a room, which look inwards.
    void add_room(Vec3 lower, Vec3 upper, std::uint32_t material);
    /// A ball of 2 * segments^2 triangles that looks round.
    void add_ball(Vec3 center, float radius, std::uint32_t segments, std::uint32_t material);
    /// Shines alike in all directions with `intensity` watts per steradian.
    void add_point_light(Vec3 position, Rgb intensity, std::uint32_t light_group = 0);
    void finish();

    bool intersect(const Ray& ray, SurfacePoint& point,
                   std::pmr::memory_resource& memory) const override;
    Ray spawn(const SurfacePoint& point, Vec3 direction, float time) const override;
    Rgb visibility(const SurfacePoint& point, const DirectSample& light, float time) const override;
    bool blocked(Vec3 from, Vec3 to, float time) const override;
    std::span<const Light* const> lights() const override { return light_pointers_; }
    std::span<const std::string> material_names() const override { return names_; }
    std::uint32_t light_groups() const override { return light_groups_; }
    Bounds bounds() const override { return bounds_; }
    SceneFacts facts() const override;

  private:
    Vec3 shading_normal(std::uint32_t triangle, Vec3 position, Vec3 geometric_normal) const;
    float rounding() const;

    std::vector<TriangleMaterial> materials_;
    std::vector<std::string> names_;
    std::vector<Triangle> triangles_, normals_;  // normals: all zero where there are none
    std::vector<std::uint32_t> material_of_;
    std::vector<LightIndex> light_of_;
    std::vector<std::unique_ptr<Light>> lights_;
    std::vector<const Light*> light_pointers_;
    std::unique_ptr<TriangleTree> tree_;
    std::uint32_t light_groups_ = 1;
    Bounds bounds_;
};

}  // namespace aips
