// A scene as the reader leaves it: everything resolved and owned, nothing traced yet.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lxs/scene/geometry.h"
#include "lxs/scene/material.h"
#include "lxs/scene/motion.h"
#include "lxs/scene/scene_medium.h"
#include "lxs/sdk/light.h"
#include "lxs/sdk/parameters.h"

namespace lxs {

class FrontProfile;  // host/lights

/// Emission of a shape (AreaLightSource "area").
struct AreaEmission {
    std::shared_ptr<const ColorTexture> radiance;  ///< L, without gain
    std::string radiance_texture = {};             ///< its name, if it has one
    float gain = 1;
    float power = 0;     ///< electrical watts; with efficacy > 0 it sets the emitted flux
    float efficacy = 0;  ///< lumens per watt
    std::shared_ptr<const FrontProfile> profile;  ///< intensity by direction; null: diffuse
    std::uint32_t group = 0;
    bool hidden = false;  ///< the camera does not see it
    SourceLocation where;
};

/// A shape with all that applies to it.
struct Primitive {
    Geometry geometry;
    std::shared_ptr<const Material> material;
    std::uint32_t material_index = 0;  ///< into SceneContents::material_names
    std::string name = {};             ///< for masks; that of its object stands above it
    std::shared_ptr<const Medium> interior, exterior;
    std::optional<AreaEmission> emission;
    Matrix
        to_world;  ///< in force at the shape: to object space, or to the world outside of objects
    bool reverse_orientation = false;  ///< ReverseOrientation in force xor mirroring transform
    SourceLocation where;
};

/// A named object (ObjectBegin/End); its primitives are in object space.
struct ObjectDefinition {
    std::string name;
    std::vector<Primitive> primitives;
};

/// One placed copy of an object.
struct Instance {
    std::size_t object = 0;  ///< index into SceneContents::objects
    Matrix to_world;         ///< without motion
    Motion motion = {};      ///< empty: stands still
    /// Into SceneContents::outer_objects: the object that was placed, where that is one around
    /// `object`; it names masks. kNoOuterObject: `object` itself.
    std::uint32_t outer = kNoOuterObject;
    static constexpr std::uint32_t kNoOuterObject = std::numeric_limits<std::uint32_t>::max();
};

/// A light without geometry: its parameters and where it stands.
struct LightDescription {
    ParameterSet parameters;
    Matrix to_world;
    std::uint32_t group = 0;
    std::shared_ptr<const Medium> medium;  ///< Exterior in force: photons start in it
    bool hidden = false;                   ///< the camera does not see it, whatever the scene says
};

/// Plugin choice of one option statement (Camera, Film, Sampler, ...).
struct OptionStatement {
    ParameterSet parameters;
    Matrix transform;    ///< the current transform where the statement stood
    Motion motion = {};  ///< of that transform; empty: stands still
};

struct SceneContents {
    /// By statement name: "Camera", "Film", "PixelFilter", "Sampler", "SurfaceIntegrator",
    /// "Renderer", "VolumeIntegrator", "Accelerator". Absent when the scene has no such statement.
    std::map<std::string, OptionStatement> options;
    std::vector<Primitive> primitives;  ///< world space
    std::vector<ObjectDefinition> objects;
    std::vector<std::string> outer_objects;  ///< names
    std::vector<Instance> instances;
    std::vector<LightDescription> lights;
    std::vector<SceneMedium> media;         ///< all that were named
    std::vector<std::string> light_groups;  ///< at least "default"
    std::vector<std::string> material_names;
    /// Of these, the matte that shapes without a Material have, if there are such shapes.
    std::optional<std::uint32_t> implied_material;
    std::shared_ptr<const Medium> camera_medium;  ///< Exterior in force at WorldEnd
    std::string directory;  ///< of the main scene file: asset names resolve against it
    SourceLocation end;     ///< of WorldEnd, for messages about what is missing
};

}  // namespace lxs
