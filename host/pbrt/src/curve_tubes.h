// Curves as meshes of tubes, many in one: a head has a hundred thousand hairs.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "new_statement.h"

namespace lxs::pbrt {

/// Control points of one curve, whose width goes evenly from its begin to its end.
struct Curve {
    std::vector<std::array<double, 3>> points;
    int degree = 3;       ///< 2 or 3
    bool spline = false;  ///< a uniform B-spline; else Bezier curves that share their ends
    double width0 = 1, width1 = 1;
    /// 0: the number of points fits no curve.
    std::size_t segments() const;
};

class CurveTubes {
  public:
    void add(const Curve& curve);
    bool empty() const { return triangles_.empty(); }
    /// Numbers kept; above a few millions they are better handed on.
    std::size_t size() const { return points_.size(); }
    /// As parameters of a mesh; none are kept.
    void move_to(NewStatement& mesh);

  private:
    /// `side`: a unit vector across the unit vector `along`, where the ring begins.
    void add_ring(const Imath::V3d& centre, const Imath::V3d& along, const Imath::V3d& side,
                  double radius, std::size_t sides, double v);

    Numbers points_, normals_, uv_, triangles_;
};

}  // namespace lxs::pbrt
