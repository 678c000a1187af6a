// Bump and normal maps: the tilted normal, and the decorator that hands it on.
#include "bumped_material.h"

#include <cmath>

#include "bsdfs/place_bsdf.h"
#include "bsdfs/tilted_bsdf.h"
#include "lxs/scene/refused_values.h"
#include "lxs/sdk/frame.h"
#include "textures/texture_parameters.h"

namespace lxs::shading {
namespace {

constexpr double kDefaultStep = 0.001;  // scene units, as LuxRender

/// Texture coordinates gained per length along the unit tangent `t`.
Vec2 coordinate_slope(const ShadingPoint& point, const Vec3& t) {
    const float uu = point.dpdu.dot(point.dpdu), vv = point.dpdv.dot(point.dpdv);
    const float uv = point.dpdu.dot(point.dpdv);
    const float determinant = uu * vv - uv * uv;
    if (!(determinant > 1e-12f * uu * vv)) return Vec2(0.0f);
    const float tu = t.dot(point.dpdu), tv = t.dot(point.dpdv);
    const Vec2 slope((tu * vv - tv * uv) / determinant, (tv * uu - tu * uv) / determinant);
    return std::isfinite(slope.x) && std::isfinite(slope.y) ? slope : Vec2(0.0f);
}

float height_slope(const FloatTexture& height, float step, const ShadingPoint& point,
                   const Vec3& t) {
    const float half = 0.5f * step;
    const Vec2 uv = coordinate_slope(point, t) * half;
    TexturePoint ahead = point.texture, behind = point.texture;
    ahead.p += t * half;
    ahead.uv += uv;
    behind.p -= t * half;
    behind.uv -= uv;
    return (height.evaluate(ahead) - height.evaluate(behind)) / step;
}

/// `n` moved into the hemisphere of `ng` if it left it.
Vec3 above_surface(const Vec3& n, const Vec3& ng) {
    constexpr float kLeastCosine = 1e-3f;
    const float cosine = n.dot(ng);
    return cosine >= kLeastCosine ? n : (n + ng * (kLeastCosine - cosine)).normalized();
}

class BumpedMaterial final : public Material {
  public:
    BumpedMaterial(std::shared_ptr<const Material> material,
                   std::shared_ptr<const FloatTexture> height, std::string height_name, float step)
        : material_(std::move(material)),
          height_(std::move(height)),
          height_name_(std::move(height_name)),
          step_(step) {}

    void bend(ShadingPoint& point) const override {
        point.ns = bumped_normal(*height_, step_, point, height_name_);
        point.bent = true;
    }
    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override {
        const ShadingPoint own = bent(point);
        const Bsdf* bsdf = material_->scatter(own, memory);
        if (!bsdf) return nullptr;
        return place_bsdf<TiltedBsdf>(memory, *bsdf, own.ns, point.ng, point.ns);
    }
    MaterialFacts facts() const override {
        MaterialFacts facts = material_->facts();
        facts.bends = true;
        facts.reads_image |= height_->reads_image();
        facts.max_bsdf_bytes += kBsdfBytes<TiltedBsdf>;
        return facts;
    }
    Rgb straight_transmittance(const ShadingPoint& point, const Vec3& direction) const override {
        return material_->straight_transmittance(bent(point), direction);
    }

  private:
    /// The point for the material below, whose parts may have bump maps of their own.
    ShadingPoint bent(ShadingPoint point) const {
        if (!point.bent) bend(point);
        point.bent = false;
        return point;
    }

    std::shared_ptr<const Material> material_;
    std::shared_ptr<const FloatTexture> height_;
    std::string height_name_;
    float step_;
};

}  // namespace

Vec3 bumped_normal(const FloatTexture& height, float step, const ShadingPoint& point,
                   std::string_view name) {
    const Frame frame(point.ns, point.dpdu);
    // The second tangent runs along v, whichever way round the texture lies on the surface.
    const Vec3 along_v = frame.t.dot(point.dpdv) < 0 ? -frame.t : frame.t;
    const Vec2 mapped = height.mapped_slope(point.texture);
    const float du = height_slope(height, step, point, frame.s) + mapped.x;
    const float dv = height_slope(height, step, point, along_v) + mapped.y;
    const Vec3 normal = point.ns - frame.s * du - along_v * dv;
    const float length = normal.length();
    if (!std::isfinite(length)) {
        if (point.texture.refused) point.texture.refused->count(name);
        return point.ns;
    }
    return above_surface(normal / length, point.ng);
}

std::vector<ParameterDeclaration> bump_map_parameters() {
    return {{"bumpmap", ParameterType::FloatTexture, "",
             "height above the surface, scene units, or a normal map; tilts the shading normal"},
            {"bumpmapsampledistance", ParameterType::Float, "0.001",
             "length over which the bump map's slope is taken, scene units", 1e-9}};
}

MaterialFactory with_bump_map(MaterialFactory factory) {
    factory.create = [create = std::move(factory.create)](
                         const ParameterReader& reader, const AssetContext& assets,
                         const Matrix& to_world) -> std::shared_ptr<const Material> {
        auto material = create(reader, assets, to_world);
        if (!reader.given("bumpmap")) return material;
        auto height = read_float_texture(reader, assets, "bumpmap", 0);
        if (height->constant()) return material;  // no slope anywhere
        const auto step = static_cast<float>(reader.number("bumpmapsampledistance", kDefaultStep));
        return std::make_shared<BumpedMaterial>(std::move(material), std::move(height),
                                                reader.texture_name("bumpmap").value_or(""), step);
    };
    return factory;
}

}  // namespace lxs::shading
