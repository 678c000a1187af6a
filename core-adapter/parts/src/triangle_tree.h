// A tree of boxes around triangles.
#pragma once

#include <vector>

#include "aips/core/base/bounds.h"
#include "aips/parts/triangle_scene.h"

namespace aips {

class TriangleTree {
  public:
    /// Of triangles that outlive the tree and keep their order.
    explicit TriangleTree(std::span<const Triangle> triangles);

    struct Hit {
        double distance = 0;
        std::uint32_t triangle = 0;
    };
    /// The nearest triangle at a distance in (0, farthest); of equals the one of lowest number.
    bool nearest(Vec3 origin, Vec3 direction, double farthest, Hit& hit) const;

  private:
    struct Node {
        Bounds bounds;
        std::uint32_t first = 0;  ///< triangle in order_ of a leaf, else the second child
        std::uint32_t count = 0;  ///< of triangles; 0: not a leaf, the first child comes next
    };
    void build(std::uint32_t first, std::uint32_t count);

    std::span<const Triangle> triangles_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace aips
