// Builds the table of surfaces from primitives.
#include "surface.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace lxs {
namespace {

Surface describe(const Primitive& primitive, const MediaTable& media) {
    Surface surface;
    surface.object_to_shape = primitive.to_world.inverse();
    surface.material = primitive.material.get();
    surface.material_index = primitive.material_index;
    surface.primitive = &primitive;
    surface.interior = media.number_of(primitive.interior.get());
    surface.exterior = media.number_of(primitive.exterior.get());
    surface.reversed = primitive.reverse_orientation;
    const MaterialFacts facts = primitive.material ? primitive.material->facts() : MaterialFacts{};
    surface.straight = facts.straight;
    surface.transmits = facts.transmits || facts.straight;
    surface.index_of_media = facts.index_of_media;
    surface.own_index = facts.own_index;
    surface.may_be_specular = (facts.lobes & kSpecular) != 0;
    surface.bends = facts.bends;
    surface.reads_dpdv = facts.bends || facts.reads_dpdv;
    surface.reads_uv = surface.reads_dpdv || facts.reads_uv || primitive.emission;
    return surface;
}

/// Of the triangles' corners; other vertices don't count.
Bounds bounds_of(const TriangleMesh& mesh) {
    constexpr std::size_t kCornersAtOnce = 1 << 16;
    std::vector<Bounds> parts((mesh.indices.size() + kCornersAtOnce - 1) / kCornersAtOnce);
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t part) {
        const std::size_t end = std::min((part + 1) * kCornersAtOnce, mesh.indices.size());
        for (std::size_t i = part * kCornersAtOnce; i < end; ++i)
            parts[part].extendBy(mesh.positions[mesh.indices[i]]);
    });
    Bounds bounds;
    for (const Bounds& part : parts)
        bounds.extendBy(part);
    return bounds;
}

void refer_to_mesh(Surface& surface, const TriangleMesh& mesh, bool tabulates_planes) {
    surface.positions = mesh.positions.data();
    surface.indices = mesh.indices.data();
    if (!mesh.normals.empty()) surface.normals = mesh.normals.data();
    if (!mesh.uvs.empty()) surface.uvs = mesh.uvs.data();
    if (!mesh.colors.empty()) surface.colors = mesh.colors.data();
    if (!mesh.alphas.empty()) surface.alphas = mesh.alphas.data();
    if (tabulates_planes) surface.planes = triangle_planes(mesh, surface.reversed);
}

}  // namespace

SurfaceGroup make_surface_group(std::vector<Primitive>& primitives, const std::string& object,
                                ObjectNames& names, const MediaTable& media,
                                bool tabulates_planes) {
    SurfaceGroup group;
    group.surfaces.reserve(primitives.size());
    for (Primitive& primitive : primitives) {
        Surface surface = describe(primitive, media);
        surface.object_index = names.index_of(object.empty() ? primitive.name : object);
        if (auto* mesh = std::get_if<TriangleMesh>(&primitive.geometry)) {
            mesh->positions.reserve(mesh->positions.size() + 1);
            refer_to_mesh(surface, *mesh, tabulates_planes);
            group.bounds.extendBy(bounds_of(*mesh));
        } else {
            surface.quadric = std::make_unique<QuadricShape>(std::get<Quadric>(primitive.geometry));
            group.bounds.extendBy(surface.quadric->bounds());
        }
        if (primitive.emission) surface.emissive_index = group.emissive_count++;
        group.surfaces.push_back(std::move(surface));
    }
    return group;
}

void add_surfaces(EmbreeScene& scene, const SurfaceGroup& group,
                  const std::vector<Primitive>& primitives) {
    for (std::uint32_t id = 0; id < primitives.size(); ++id) {
        const Surface& surface = group.surfaces[id];
        const auto surface_class = surface.straight ? SurfaceClass::Straight : SurfaceClass::Opaque;
        if (surface.quadric) {
            scene.add_quadric(id, *surface.quadric, surface_class);
        } else if (const auto& mesh = std::get<TriangleMesh>(primitives[id].geometry);
                   !mesh.indices.empty()) {
            scene.add_mesh(id, mesh, surface_class);
        }
    }
}

Bounds transformed(const Bounds& box, const Matrix& to_world) {
    Bounds result;
    if (box.isEmpty()) return result;
    for (int corner = 0; corner < 8; ++corner) {
        const Imath::V3d p((corner & 1) ? box.max.x : box.min.x,
                           (corner & 2) ? box.max.y : box.min.y,
                           (corner & 4) ? box.max.z : box.min.z);
        Imath::V3d image;
        to_world.multVecMatrix(p, image);
        result.extendBy(Vec3(image));
    }
    return result;
}

}  // namespace lxs
