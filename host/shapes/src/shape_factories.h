// The shape plugins, one function each.
#pragma once

#include "lxs/scene/registry.h"

namespace lxs {

ShapeFactory make_mesh_factory();  ///< mesh, trianglemesh, barytrianglemesh, waldtrianglemesh
ShapeFactory make_ply_factory();   ///< plymesh
ShapeFactory make_stl_factory();   ///< stlmesh
ShapeFactory make_heightfield_factory();
ShapeFactory make_loopsubdiv_factory();
ShapeFactory make_sphere_factory();  ///< sphere
ShapeFactory make_disk_factory();    ///< disk
ShapeFactory make_cylinder_factory();
ShapeFactory make_cone_factory();
ShapeFactory make_hyperboloid_factory();
ShapeFactory make_paraboloid_factory();
ShapeFactory make_torus_factory();

}  // namespace lxs
