// Table of surfaces: what a hit needs to know of a primitive, compact and ready.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "embree_scene.h"
#include "lxs/scene/contents.h"
#include "media_table.h"
#include "quadric_shape.h"
#include "triangle_plane.h"

namespace lxs {

/// One primitive as hits see it; refers to data that SceneContents owns.
struct Surface {
    static constexpr std::uint32_t kNotEmissive = ~0u;

    const Vec3* positions = nullptr;  ///< null for a quadric
    const std::uint32_t* indices = nullptr;
    const Vec3* normals = nullptr;      ///< null: flat
    const Vec2* uvs = nullptr;          ///< null: none
    const Rgb* colors = nullptr;        ///< null: none
    const float* alphas = nullptr;      ///< null: none
    std::vector<TrianglePlane> planes;  ///< of a mesh; empty: worked out at each hit
    std::unique_ptr<const QuadricShape> quadric;
    Matrix object_to_shape;  ///< identity if the shape's transform has no inverse
    const Material* material = nullptr;
    const Primitive* primitive = nullptr;
    MediumNumber interior = kNoMedium;  ///< as declared
    MediumNumber exterior = kNoMedium;
    std::uint32_t material_index = 0;
    std::uint32_t object_index = 0;               ///< of its name (ObjectNames)
    std::uint32_t emissive_index = kNotEmissive;  ///< among the emissive surfaces of its group
    bool reversed = false;                        ///< the front is the other side
    bool straight = false;                        ///< may pass light undeviated
    bool transmits = false;                       ///< may pass light at all
    bool index_of_media = false;                  ///< MaterialFacts::index_of_media
    bool own_index = false;                       ///< MaterialFacts::own_index
    bool bends = false;                           ///< the material has a bump map
    bool reads_dpdv = false;                      ///< the material needs the tangent along v
    bool may_be_specular = false;                 ///< the material may have a specular lobe
    bool reads_uv = true;  ///< material or emission need texture coordinates or a tangent

    bool declares_medium() const { return interior != kNoMedium || exterior != kNoMedium; }
};

/// Names of objects, each once.
class ObjectNames {
  public:
    std::uint32_t index_of(const std::string& name) {
        const auto next = static_cast<std::uint32_t>(names_.size());
        const auto [entry, is_new] = indices_.try_emplace(name, next);
        if (is_new) names_.push_back(name);
        return entry->second;
    }
    const std::vector<std::string>& names() const { return names_; }

  private:
    std::unordered_map<std::string, std::uint32_t> indices_;
    std::vector<std::string> names_;
};

/// The surfaces of the world or of one object: geometry ids are indices into it.
struct SurfaceGroup {
    std::vector<Surface> surfaces;
    Bounds bounds;  ///< of all surfaces, in the group's own space; empty if there are none
    std::uint32_t emissive_count = 0;
};

/// In a scene of more triangles their planes are worked out at each hit, instead of being kept. The
/// table takes 16 bytes a triangle and so at most 256 MiB; without it a path takes 2 to 3 % longer
/// (docs/measured/big-scenes.md).
inline constexpr std::size_t kMostTabulatedPlanes = 1 << 24;

/// Tables of `primitives`, which must stay where they are. Makes room for one vertex behind each
/// mesh (see EmbreeScene::add_mesh).
/// They are named as the object that they are of, or each by itself if `object` is empty.
/// `tabulates_planes`: whether planes of triangles are kept.
SurfaceGroup make_surface_group(std::vector<Primitive>& primitives, const std::string& object,
                                ObjectNames& names, const MediaTable& media, bool tabulates_planes);

/// Adds the group's geometry to `scene`, ids from 0. Empty meshes are left out.
void add_surfaces(EmbreeScene& scene, const SurfaceGroup& group,
                  const std::vector<Primitive>& primitives);

/// Box around the image of `box` under `to_world`.
Bounds transformed(const Bounds& box, const Matrix& to_world);

}  // namespace lxs
