// Triangles, their lights and what they scatter.
#include "aips/parts/triangle_scene.h"

#include <algorithm>
#include <new>

#include "aips/core/sampling/sampling.h"
#include "aips/parts/plain_lights.h"
#include "aips/parts/smooth_bsdfs.h"
#include "triangle_tree.h"

namespace aips {
namespace {

Vec3 doubled_area(const Triangle& t) {
    return cross(t.b - t.a, t.c - t.a);
}

class TriangleLight final : public DiffuseAreaLight {
  public:
    TriangleLight(const Triangle& t, Rgb radiance, std::uint32_t group, float lift)
        : DiffuseAreaLight(radiance, 0.5f * length(doubled_area(t)), group, lift),
          triangle_(t),
          normal_(normalize(doubled_area(t))) {}
    std::string name() const override { return "triangle"; }

  private:
    SurfaceSample point(Vec2 u) const override {
        const float root = std::sqrt(u.x);
        const float b = root * (1 - u.y), c = root * u.y;
        return {triangle_.a * (1 - b - c) + triangle_.b * b + triangle_.c * c, normal_};
    }
    Vec2 coordinates(Vec3 position) const override {
        const Vec3 p = position - triangle_.a, n = doubled_area(triangle_);
        const float area = length_squared(n);
        const float b = dot(cross(p, triangle_.c - triangle_.a), n) / area;
        const float c = dot(cross(triangle_.b - triangle_.a, p), n) / area;
        const float root = std::max(0.0f, b + c);
        return {clamp_to_unit(root * root), root > 0 ? clamp_to_unit(c / root) : 0.0f};
    }
    Triangle triangle_;
    Vec3 normal_;
};

Vec3 along(const Ray& ray, double distance) {
    const auto coordinate = [&](int axis) {
        return float(double(ray.origin[axis]) + double(ray.direction[axis]) * distance);
    };
    return {coordinate(0), coordinate(1), coordinate(2)};
}

constexpr std::size_t kBsdfBytes =
    std::max({sizeof(LambertBsdf), sizeof(MirrorBsdf), sizeof(GlassBsdf)});

const Bsdf* make_bsdf(const TriangleMaterial& m, Vec3 ng, Vec3 ns,
                      std::pmr::memory_resource& memory) {
    void* const place = memory.allocate(kBsdfBytes, alignof(std::max_align_t));
    switch (m.kind) {
        case TriangleMaterial::Kind::Lambert:
            return new (place) LambertBsdf(ng, ns, m.reflectance);
        case TriangleMaterial::Kind::Mirror:
            return new (place) MirrorBsdf(ng, ns, m.reflectance);
        case TriangleMaterial::Kind::Glass:
            return new (place) GlassBsdf(ng, ns, m.index);
    }
    return nullptr;
}

}  // namespace

TriangleScene::TriangleScene() = default;
TriangleScene::~TriangleScene() = default;

std::uint32_t TriangleScene::add_material(const TriangleMaterial& material) {
    materials_.push_back(material);
    names_.push_back(material.name);
    light_groups_ = std::max(light_groups_, material.light_group + 1);
    return std::uint32_t(materials_.size() - 1);
}

void TriangleScene::add_triangle(const Triangle& triangle, std::uint32_t material) {
    add_triangle(triangle, Triangle{}, material);
}

/// Those without area are left out.
void TriangleScene::add_triangle(const Triangle& triangle, const Triangle& normals,
                                 std::uint32_t material) {
    if (!(length_squared(doubled_area(triangle)) > 0)) return;
    triangles_.push_back(triangle);
    normals_.push_back(normals);
    material_of_.push_back(material);
}

void TriangleScene::add_quad(Vec3 corner, Vec3 u, Vec3 v, std::uint32_t material) {
    add_triangle({corner, corner + u, corner + u + v}, material);
    add_triangle({corner, corner + u + v, corner + v}, material);
}

void TriangleScene::add_room(Vec3 lo, Vec3 hi, std::uint32_t material) {
    const Vec3 e = hi - lo, x{e.x, 0, 0}, y{0, e.y, 0}, z{0, 0, e.z};
    add_quad(lo, x, y, material);
    add_quad(lo, y, z, material);
    add_quad(lo, z, x, material);
    add_quad(hi, -y, -x, material);
    add_quad(hi, -z, -y, material);
    add_quad(hi, -x, -z, material);
}

void TriangleScene::add_ball(Vec3 center, float radius, std::uint32_t segments,
                             std::uint32_t material) {
    const auto direction = [&](std::uint32_t row, std::uint32_t column) {
        const float theta = kPi * float(row) / float(segments);
        const float phi = 2 * kPi * float(column % segments) / float(segments);
        return Vec3{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                    std::cos(theta)};
    };
    const auto add = [&](Vec3 a, Vec3 b, Vec3 c) {
        add_triangle({center + a * radius, center + b * radius, center + c * radius}, {a, b, c},
                     material);
    };
    for (std::uint32_t row = 0; row < segments; ++row) {
        for (std::uint32_t column = 0; column < segments; ++column) {
            const Vec3 a = direction(row, column), b = direction(row + 1, column);
            const Vec3 c = direction(row + 1, column + 1), d = direction(row, column + 1);
            if (row + 1 < segments) add(a, b, c);
            if (row > 0) add(a, c, d);
        }
    }
}

void TriangleScene::add_point_light(Vec3 position, Rgb intensity, std::uint32_t light_group) {
    lights_.push_back(std::make_unique<PointLight>(position, intensity, light_group));
    light_groups_ = std::max(light_groups_, light_group + 1);
}

void TriangleScene::finish() {
    for (const Triangle& triangle : triangles_) {
        for (const Vec3 p : {triangle.a, triangle.b, triangle.c})
            bounds_.extend(p);
    }
    light_of_.assign(triangles_.size(), kNoLight);
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const TriangleMaterial& material = materials_.at(material_of_[i]);
        if (is_black(material.emitted)) continue;
        light_of_[i] = LightIndex(lights_.size());
        lights_.push_back(std::make_unique<TriangleLight>(triangles_[i], material.emitted,
                                                          material.light_group, rounding()));
    }
    for (const auto& light : lights_)
        light_pointers_.push_back(light.get());
    tree_ = std::make_unique<TriangleTree>(triangles_);
}

/// What rounding moves a position of this scene by, at most, in single precision.
float TriangleScene::rounding() const {
    const Vec3 reach = max(abs(bounds_.lower), abs(bounds_.upper));
    return 8 * 0x1p-23f * std::max({reach.x, reach.y, reach.z});
}

bool TriangleScene::intersect(const Ray& ray, SurfacePoint& point,
                              std::pmr::memory_resource& memory) const {
    TriangleTree::Hit hit;
    if (!tree_->nearest(ray.origin, ray.direction, Bounds::kInf, hit)) return false;
    point.distance = float(hit.distance);
    // In double precision: a ray from afar must not end below the surface by rounding of its
    // length.
    point.position = along(ray, hit.distance);
    point.geometric_normal = normalize(doubled_area(triangles_[hit.triangle]));
    point.shading_normal = shading_normal(hit.triangle, point.position, point.geometric_normal);
    point.material = material_of_[hit.triangle];
    const TriangleMaterial& material = materials_[point.material];
    const bool front = dot(ray.direction, point.geometric_normal) < 0;
    point.light = front ? light_of_[hit.triangle] : kNoLight;
    point.emitted = front ? material.emitted : Rgb{};
    point.bsdf = make_bsdf(material, point.geometric_normal, point.shading_normal, memory);
    return true;
}

Vec3 TriangleScene::shading_normal(std::uint32_t number, Vec3 position, Vec3 ng) const {
    const Triangle &t = triangles_[number], &normals = normals_[number];
    if (normals.a == Vec3{}) return ng;
    const Vec3 n = doubled_area(t), p = position - t.a;
    const float area = length_squared(n);
    const float b = dot(cross(p, t.c - t.a), n) / area, c = dot(cross(t.b - t.a, p), n) / area;
    const Vec3 ns = normals.a * (1 - b - c) + normals.b * b + normals.c * c;
    return dot(ns, ng) > 0 ? normalize(ns) : ng;
}

/// Rays start beside the surface by what rounding may have moved their origin.
Ray TriangleScene::spawn(const SurfacePoint& point, Vec3 direction, float time) const {
    const Vec3 n = point.geometric_normal;
    const Vec3 step = n * (dot(direction, n) > 0 ? rounding() : -rounding());
    return {point.position + step, direction, time};
}

Rgb TriangleScene::visibility(const SurfacePoint& point, const DirectSample& light,
                              float time) const {
    const Ray ray = spawn(point, light.wi, time);
    // The way from where the ray really starts, ending before the light's own surface.
    const Vec3 to = point.position + light.wi * light.distance - ray.origin;
    const float distance = length(to);
    const double end = double(distance) * (1 - 1e-4) - rounding();
    TriangleTree::Hit hit;
    return tree_->nearest(ray.origin, to / distance, end, hit) ? Rgb{} : kWhite;
}

bool TriangleScene::blocked(Vec3 from, Vec3 to, float /*time*/) const {
    const Vec3 way = to - from;
    const float distance = length(way);
    TriangleTree::Hit hit;
    return distance > 0 && tree_->nearest(from, way / distance, double(distance), hit);
}

SceneFacts TriangleScene::facts() const {
    SceneFacts facts;
    facts.lobes = 0;
    for (const TriangleMaterial& material : materials_)
        facts.lobes |= material.kind == TriangleMaterial::Kind::Lambert ? kDiffuse : kSpecular;
    facts.max_bsdf_bytes = kBsdfBytes + alignof(std::max_align_t);
    return facts;
}

}  // namespace aips
