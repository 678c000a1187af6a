// What the mock host's surfaces are made of, and rays against them in double precision.
#pragma once

#include <variant>
#include <vector>

#include "aips/adapter/scene.h"

namespace mock {

/// Parallelogram corner + s * edge_u + t * edge_v; its front is cross(edge_u, edge_v).
struct Quad {
    aips::Vec3 corner, edge_u, edge_v;
};

/// Sphere with its front outside; `inside_out` turns it.
struct Ball {
    aips::Vec3 center;
    float radius = 1;
    bool inside_out = false;
};

using Shape = std::variant<Quad, Ball>;

aips::Vec3 front_normal(const Shape& shape, aips::Vec3 position);
void extend(aips::Bounds& bounds, const Shape& shape);

/// Shapes made ready for rays, in the order they were added.
class RayTargets {
  public:
    struct Hit {
        double t = 0;
        std::size_t shape = 0;
    };

    void clear() { targets_.clear(); }
    void add(const Shape& shape);
    /// The nearest shape within (t_min, t_max); the first added of several.
    bool nearest(const aips::Ray& ray, double t_min, double t_max, Hit& hit) const;

  private:
    struct Vec3d {
        double x, y, z;
    };
    /// A ball, or a quad's plane and two more, whose dot products with a place are its s and t.
    struct Target {
        bool ball = false;
        Vec3d origin{};  ///< corner or center
        Vec3d normal{}, to_s{}, to_t{};
        double radius = 0;
    };
    static Vec3d wide(aips::Vec3 v) { return {v.x, v.y, v.z}; }
    friend Vec3d operator-(Vec3d a, Vec3d b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    static double dot(Vec3d a, Vec3d b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    static Vec3d cross_over(Vec3d a, Vec3d b, double divisor);
    static double quad_distance(const Target& quad, const Vec3d& o, const Vec3d& d, double t_min,
                                double t_max);
    static double ball_distance(const Target& ball, const Vec3d& o, const Vec3d& d, double t_min,
                                double t_max);

    std::vector<Target> targets_;
};

}  // namespace mock
