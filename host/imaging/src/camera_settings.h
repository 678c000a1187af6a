// What the Camera statement asks for.
#pragma once

#include <array>
#include <cstdint>

#include "film_settings.h"
#include "lxs/scene/contents.h"

namespace lxs {

enum class Projection : std::uint8_t { Perspective, Orthographic, Environment };

/// Where the directions of an environment camera lie in its image.
enum class SphereMapping : std::uint8_t { Equirectangular, EqualArea };

/// Camera space: x right, y up, z forward (left-handed, as LookAt of the scene language makes it).
struct CameraSettings {
    Projection projection = Projection::Perspective;
    SphereMapping mapping = SphereMapping::Equirectangular;
    Matrix to_world;                             ///< camera to world
    Motion motion;                               ///< of to_world; empty: stands still
    double fov = 90;                             ///< degrees, of the screen from -1 to 1
    std::array<double, 4> screen{-1, 1, -1, 1};  ///< x0 x1 y0 y1, y up
    double hither = 0;                           ///< rays start at this depth, scene units
    double yon = 1e30;                           ///< and end at this one
    double lens_radius = 0;                      ///< scene units
    double focal_distance = 1e30;                ///< depth of the sharp plane
    bool autofocus = false;  ///< the sharp plane is where the screen's middle meets the scene
    int blades = 0;          ///< of the aperture; below 3: it is round
    float shutter_open = 0, shutter_close = 1;
};

/// Reads and checks the Camera statement; throws InputError, warns of what has no effect.
CameraSettings read_camera_settings(const SceneContents& contents, const FilmFrame& frame,
                                    Diagnostics& diagnostics);

/// Declared parameters of the camera `plugin`.
std::vector<ParameterDeclaration> camera_parameters(const std::string& plugin);

}  // namespace lxs
