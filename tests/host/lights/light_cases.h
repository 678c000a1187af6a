// Lights under test, made as the scene reader makes them, and their visible surfaces.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "lxs/lights/lights.h"
#include "test_geometry.h"

namespace lxs::test {

/// Keeps warnings; an unknown parameter counts as one.
class RecordedDiagnostics : public Diagnostics {
  public:
    void warning(const SourceLocation& where, const std::string& message) override;
    void unknown_parameter(const SourceLocation& where, const std::string& message) override;
    std::vector<std::string> warnings;
};

ParameterValue numbers(const std::string& type, const std::string& name,
                       const std::vector<double>& values);
ParameterValue text(const std::string& name, const std::string& value);

/// The sphere around the scene in all tests.
SceneSphere scene_sphere();
/// make_lights with asset names as paths.
Lights make(const std::string& plugin, const std::vector<ParameterValue>& values,
            RecordedDiagnostics& diagnostics, const Matrix& to_world = Matrix());
/// The only light of such a statement.
std::unique_ptr<Light> make_one(const std::string& plugin,
                                const std::vector<ParameterValue>& values,
                                const Matrix& to_world = Matrix());

/// Colour that is the same everywhere.
std::shared_ptr<const ColorTexture> constant_color(const Rgb& color);
/// An emissive primitive; power and efficacy 0.
Primitive emissive(Geometry geometry, const Rgb& radiance);
/// `primitive` as its AreaLightSource makes it with these parameters of a profile.
Primitive profiled(Primitive primitive, const std::vector<ParameterValue>& values,
                   RecordedDiagnostics& diagnostics);
Primitive profiled(Primitive primitive, const std::vector<ParameterValue>& values);
Quadric placed(decltype(Quadric::shape) shape, const Matrix& to_world);

/// Where a ray from `p` along `wi` meets a light, and the front normal there.
struct LightHit {
    Vec3 p{0.0f}, n{0.0f};
};

/// A light that has an extent, and what rays to it meet. Lights at infinity meet everywhere.
struct ExtendedLight {
    std::string name;
    std::unique_ptr<Light> light;
    Vec3 from{0.0f};  ///< a point that it lights
    std::function<std::optional<LightHit>(const Vec3& p, const Vec3& wi)> meet;
    Vec3 axis{0.0f, 0.0f, 1.0f};  ///< towards the light's middle from `from`
    float cos_min = -1;           ///< all of the light is within this cosine of the axis
};

/// Every kind of light with a density, in its interesting positions.
std::vector<ExtendedLight> extended_lights();

/// A 64 x 32 image file with a bright spot; its path.
std::string probe_image();
/// A photometric file of a luminaire without any symmetry that still shines at 90 degrees; its
/// path.
std::string wall_washer();

/// Uniform floats in [0, 1).
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    float operator()() { return static_cast<float>(engine_() >> 40) * 0x1p-24f; }

  private:
    std::mt19937_64 engine_;
};

}  // namespace lxs::test
