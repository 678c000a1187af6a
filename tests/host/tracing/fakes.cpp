// Fake materials and scene builders.
#include "fakes.h"

#include <array>
#include <new>

#include "lxs/scene/constant_texture.h"

namespace lxs::test {
namespace {

class LambertianBsdf final : public Bsdf {
  public:
    LobeMask lobes() const override { return kDiffuse; }
    Rgb evaluate(const Vec3&, const Vec3&, Transport, LobeMask) const override {
        return Rgb(0.159f);
    }
    float pdf(const Vec3&, const Vec3&, LobeMask) const override { return 0; }
    bool sample(const Vec3&, const Vec2&, float, Transport, LobeMask, BsdfSample&) const override {
        return false;
    }
    Rgb albedo(const Vec3&, LobeMask) const override { return Rgb(0.5f); }
};

class Matte : public Material {
  public:
    const Bsdf* scatter(const ShadingPoint&, std::pmr::memory_resource& memory) const override {
        return new (memory.allocate(sizeof(LambertianBsdf), alignof(LambertianBsdf)))
            LambertianBsdf;
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.lobes = kDiffuse;
        facts.max_bsdf_bytes = sizeof(LambertianBsdf);
        return facts;
    }
};

class Straight : public Material {
  public:
    explicit Straight(const Rgb& share) : share_(share) {}
    const Bsdf* scatter(const ShadingPoint&, std::pmr::memory_resource&) const override {
        return nullptr;
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.lobes = kSpecular;
        facts.transmits = facts.straight = true;
        return facts;
    }
    Rgb straight_transmittance(const ShadingPoint&, const Vec3&) const override { return share_; }

  private:
    Rgb share_;
};

class SilentDiagnostics : public Diagnostics {
  public:
    void warning(const SourceLocation&, const std::string&) override {}
    void unknown_parameter(const SourceLocation&, const std::string&) override {}
};

}  // namespace

std::shared_ptr<const Material> matte() {
    return std::make_shared<Matte>();
}
std::shared_ptr<const Material> straight(const Rgb& share) {
    return std::make_shared<Straight>(share);
}

TriangleMesh triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    TriangleMesh mesh;
    mesh.positions = {a, b, c};
    mesh.indices = {0, 1, 2};
    return mesh;
}

Quadric sphere(float radius, const Matrix& to_world) {
    return {Sphere{radius, -radius, radius, 360}, to_world};
}
Quadric disk(float radius, const Matrix& to_world) {
    return {Disk{0, radius, 0, 360}, to_world};
}

Primitive primitive(Geometry geometry, std::shared_ptr<const Material> material) {
    Primitive result;
    result.geometry = std::move(geometry);
    result.material = std::move(material);
    return result;
}

AreaEmission emission(const Rgb& radiance) {
    AreaEmission result;
    result.radiance = std::make_shared<ConstantTexture<Rgb>>(radiance);
    return result;
}

Matrix rotation(const Imath::V3d& axis, double angle) {
    return Matrix().setAxisAngle(axis.normalized(), angle);
}

std::unique_ptr<TraceScene> trace(SceneContents contents) {
    if (contents.light_groups.empty()) contents.light_groups = {"default"};
    const AssetResolver resolve = [](const std::string& name, const SourceLocation&) {
        return name;
    };
    SilentDiagnostics diagnostics;
    return make_trace_scene(std::move(contents), resolve, diagnostics);
}

std::unique_ptr<TraceScene> trace(std::vector<Primitive> primitives) {
    SceneContents contents;
    contents.primitives = std::move(primitives);
    return trace(std::move(contents));
}

std::unique_ptr<TraceScene> trace_within(std::vector<Primitive> primitives,
                                         std::shared_ptr<const Medium> medium) {
    SceneContents contents;
    contents.primitives = std::move(primitives);
    contents.camera_medium = std::move(medium);
    return trace(std::move(contents));
}

SceneContents instanced(std::vector<Primitive> primitives, const std::vector<Matrix>& transforms) {
    SceneContents contents;
    contents.objects.push_back({"object", std::move(primitives)});
    for (const Matrix& to_world : transforms)
        contents.instances.push_back({0, to_world});
    return contents;
}

Ray ray(const Vec3& origin, const Vec3& direction) {
    Ray result;
    result.origin = origin;
    result.direction = direction.normalized();
    return result;
}

bool hit(const Scene& scene, const Ray& ray, SurfaceHit& result) {
    std::array<std::byte, 256> buffer;
    std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size(),
                                               std::pmr::null_memory_resource());
    return scene.intersect(ray, result, memory);
}

}  // namespace lxs::test
