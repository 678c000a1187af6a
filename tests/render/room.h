// A closed room of two units a side, in the scene language, for tests that fill it.
#pragma once

namespace render {

/// A wide lamp below the ceiling.
inline constexpr const char* kRoomLamp = R"(AttributeBegin
AreaLightSource "area" "color L" [10 10 10]
Material "matte" "color Kd" [0 0 0]
Shape "trianglemesh" "integer triindices" [0 2 1 0 3 2] "point P" [-0.4 -0.4 0.9  0.4 -0.4 0.9  0.4 0.4 0.9  -0.4 0.4 0.9]
AttributeEnd
)";

/// Floor, ceiling and four walls.
inline constexpr const char* kRoomWalls = R"(Material "matte" "color Kd" [0.6 0.5 0.4]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 -1 -1  1 -1 -1  1 1 -1  -1 1 -1]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 -1 1  -1 1 1  1 1 1  1 -1 1]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 1 -1  1 1 -1  1 1 1  -1 1 1]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 -1 -1  -1 -1 1  1 -1 1  1 -1 -1]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 -1 -1  -1 1 -1  -1 1 1  -1 -1 1]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [1 -1 -1  1 -1 1  1 1 1  1 1 -1]
)";

}  // namespace render
