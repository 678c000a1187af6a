// Names of the shape plugins.
#include "shape_factories.h"

namespace lxs {

void register_shapes(Registry& registry) {
    for (const char* name : {"mesh", "trianglemesh", "barytrianglemesh", "waldtrianglemesh"})
        registry.shapes[name] = make_mesh_factory();
    registry.shapes["plymesh"] = make_ply_factory();
    registry.shapes["stlmesh"] = make_stl_factory();
    registry.shapes["heightfield"] = make_heightfield_factory();
    registry.shapes["loopsubdiv"] = make_loopsubdiv_factory();
    registry.shapes["sphere"] = make_sphere_factory();
    registry.shapes["disk"] = make_disk_factory();
    registry.shapes["cylinder"] = make_cylinder_factory();
    registry.shapes["cone"] = make_cone_factory();
    registry.shapes["hyperboloid"] = make_hyperboloid_factory();
    registry.shapes["paraboloid"] = make_paraboloid_factory();
    registry.shapes["torus"] = make_torus_factory();
}

}  // namespace lxs
