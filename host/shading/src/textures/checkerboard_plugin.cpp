// Texture "checkerboard": two textures in alternating squares of (u, v) or cubes of space.
#include <cmath>
#include <cstdint>

#include "ignored_parameter.h"
#include "space_mapping.h"
#include "texture_parameters.h"
#include "texture_plugins.h"
#include "uv_mapping.h"

namespace lxs::shading {
namespace {

/// Parity of the cell with corner `cell`, a whole number. From 2^24 on all numbers are even.
bool odd(float cell) {
    return std::abs(cell) < 0x1p24f && (static_cast<std::int32_t>(cell) & 1) != 0;
}

class Checkerboard2 final : public FloatTexture {
  public:
    Checkerboard2(std::shared_ptr<const FloatTexture> first,
                  std::shared_ptr<const FloatTexture> second, const UvMapping& mapping)
        : first_(std::move(first)), second_(std::move(second)), mapping_(mapping) {}
    float evaluate(const TexturePoint& point) const override {
        const Vec2 st = mapping_(point);
        const bool second = odd(std::floor(st.x)) != odd(std::floor(st.y));
        return (second ? second_ : first_)->evaluate(point);
    }
    bool reads_image() const override { return first_->reads_image() || second_->reads_image(); }

  private:
    std::shared_ptr<const FloatTexture> first_, second_;
    UvMapping mapping_;
};

class Checkerboard3 final : public FloatTexture {
  public:
    Checkerboard3(std::shared_ptr<const FloatTexture> first,
                  std::shared_ptr<const FloatTexture> second, const SpaceMapping& mapping)
        : first_(std::move(first)), second_(std::move(second)), mapping_(mapping) {}
    float evaluate(const TexturePoint& point) const override {
        const Vec3 p = mapping_(point);
        const bool second = (odd(std::floor(p.x)) != odd(std::floor(p.y))) != odd(std::floor(p.z));
        return (second ? second_ : first_)->evaluate(point);
    }
    bool reads_image() const override { return first_->reads_image() || second_->reads_image(); }

  private:
    std::shared_ptr<const FloatTexture> first_, second_;
    SpaceMapping mapping_;
};

std::shared_ptr<const FloatTexture> create(const ParameterReader& reader,
                                           const AssetContext& assets, const Matrix& to_world) {
    auto first = read_float_texture(reader, assets, "tex1", 1);
    auto second = read_float_texture(reader, assets, "tex2", 0);
    if (reader.integer("dimension", 2) == 2)
        return std::make_shared<Checkerboard2>(first, second, UvMapping(reader, to_world));
    return std::make_shared<Checkerboard3>(first, second, SpaceMapping(reader, to_world));
}

}  // namespace

FloatTextureFactory checkerboard_plugin() {
    ParameterDeclaration dimension{"dimension", ParameterType::Integer, "2",
                                   "2: squares in (u, v); 3: cubes in space"};
    dimension.minimum = 2;
    dimension.maximum = 3;
    std::vector<ParameterDeclaration> parameters{
        dimension,
        {"tex1", ParameterType::FloatTexture, "1", "value of the first squares"},
        {"tex2", ParameterType::FloatTexture, "0", "value of the others"},
        ignored("aamode", ParameterType::String, "closedform", "antialiasing of LuxRender")};
    return {
        declarations({std::move(parameters), uv_mapping_parameters(), space_mapping_parameters()}),
        &create};
}

}  // namespace lxs::shading
