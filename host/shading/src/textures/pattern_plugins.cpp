// Flat patterns: textures "bilerp", "uv", "uvmask", "dots" and "harlequin".
#include <cmath>

#include "formula_texture.h"
#include "fresnel_arithmetic.h"
#include "perlin_noise.h"
#include "texture_parameters.h"
#include "texture_plugins.h"
#include "uv_mapping.h"

namespace lxs::shading {
namespace {

/// The part of a coordinate behind its point, 0 to 1: patterns repeat.
Vec2 within_cell(const Vec2& st) {
    return {st.x - std::floor(st.x), st.y - std::floor(st.y)};
}

template <class T>
typename TextureKind<T>::Factory bilerp_plugin() {
    using Kind = TextureKind<T>;
    return {declarations({{{"v00", Kind::kValue, Kind::kBlack, "value at s = 0, t = 0"},
                           {"v01", Kind::kValue, Kind::kWhite, "value at s = 0, t = 1"},
                           {"v10", Kind::kValue, Kind::kBlack, "value at s = 1, t = 0"},
                           {"v11", Kind::kValue, Kind::kWhite, "value at s = 1, t = 1"}},
                          uv_mapping_parameters()}),
            [](const ParameterReader& reader, const AssetContext&, const Matrix& to_world) {
                return formula_texture<T>(
                    [mapping = UvMapping(reader, to_world), v00 = Kind::value(reader, "v00", 0),
                     v01 = Kind::value(reader, "v01", 1), v10 = Kind::value(reader, "v10", 0),
                     v11 = Kind::value(reader, "v11", 1)](const TexturePoint& point) {
                        const Vec2 st = within_cell(mapping(point));
                        return (v00 * (1 - st.y) + v01 * st.y) * (1 - st.x) +
                               (v10 * (1 - st.y) + v11 * st.y) * st.x;
                    });
            }};
}

ColorTextureFactory uv_plugin() {
    return {uv_mapping_parameters(),
            [](const ParameterReader& reader, const AssetContext&, const Matrix& to_world) {
                return formula_texture<Rgb>(
                    [mapping = UvMapping(reader, to_world)](const TexturePoint& point) {
                        const Vec2 st = within_cell(mapping(point));
                        return Rgb(st.x, st.y, 0);
                    });
            }};
}

using FloatInput = std::shared_ptr<const FloatTexture>;

/// A texture of two: what a parameter gives where it shows, and its default.
struct MaskPart {
    std::string_view name, default_text, doc;
    double default_value;
};

/// One texture where `is_inside`(mapping, point) holds, another elsewhere.
FloatTextureFactory mask_plugin(const MaskPart& in, const MaskPart& out,
                                bool (*is_inside)(const Vec2& st)) {
    return {declarations({{{in.name, ParameterType::FloatTexture, in.default_text, in.doc},
                           {out.name, ParameterType::FloatTexture, out.default_text, out.doc}},
                          uv_mapping_parameters()}),
            [=](const ParameterReader& reader, const AssetContext& assets, const Matrix& to_world) {
                const FloatInput inside =
                    read_float_texture(reader, assets, in.name, in.default_value);
                const FloatInput outside =
                    read_float_texture(reader, assets, out.name, out.default_value);
                return formula_texture<float>(
                    [=, mapping = UvMapping(reader, to_world)](const TexturePoint& point) {
                        return (is_inside(mapping(point)) ? inside : outside)->evaluate(point);
                    },
                    inside->reads_image() || outside->reads_image());
            }};
}

bool in_unit_square(const Vec2& st) {
    return st.x >= 0 && st.x <= 1 && st.y >= 0 && st.y <= 1;
}

/// Noise at a point of the plane, in the middle of a layer of the lattice.
float plane_noise(float x, float y) {
    return perlin_noise(Vec3(x, y, 0.5f));
}

/// About half of the unit cells around whole (s, t) hold a dot, somewhere within the cell (Pharr
/// and Humphreys 2004, section 11.5.3).
bool in_dot(const Vec2& st) {
    constexpr float kRadius = 0.35f, kMostShift = 0.5f - kRadius;
    const Vec2 cell(std::floor(st.x + 0.5f), std::floor(st.y + 0.5f));
    if (!(plane_noise(cell.x + 0.5f, cell.y + 0.5f) > 0)) return false;
    const Vec2 shift(plane_noise(cell.x + 1.5f, cell.y + 2.8f),
                     plane_noise(cell.x + 4.5f, cell.y + 9.8f));
    return (st - cell - shift * kMostShift).length2() < kRadius * kRadius;
}

/// The digits of `n` in `base`, mirrored at the point (van der Corput).
constexpr float radical_inverse(unsigned n, unsigned base) {
    float value = 0, digit = 1;
    for (; n > 0; n /= base) {
        digit /= static_cast<float>(base);
        value += digit * static_cast<float>(n % base);
    }
    return value;
}

/// One of LuxRender's 16 colours for every face. LuxRender takes bits 4 to 7 of a triangle's
/// address in memory, so that which face has which differs between its builds; on 64-bit Linux the
/// triangles of a mesh lie 144 bytes apart, and each is nine colours on from the one before.
Rgb harlequin(const TexturePoint& point) {
    constexpr unsigned kColours = 16, kNext = 9;
    const unsigned n = 6 * (point.face % kColours * kNext % kColours) + 1;
    return {radical_inverse(n, 2), radical_inverse(n, 3), radical_inverse(n, 5)};
}

}  // namespace

void register_pattern_textures(Registry& registry) {
    registry.float_textures["bilerp"] = bilerp_plugin<float>();
    registry.color_textures["bilerp"] = bilerp_plugin<Rgb>();
    registry.fresnel_textures["bilerp"] = bilerp_plugin<FresnelValue>();
    registry.color_textures["uv"] = uv_plugin();
    registry.float_textures["uvmask"] =
        mask_plugin({"innertex", "1", "value inside", 1}, {"outertex", "0", "value outside", 0},
                    &in_unit_square);
    // LuxRender shows them the other way round than they are named.
    registry.float_textures["dots"] =
        mask_plugin({"outside", "0", "value in the dots", 0},
                    {"inside", "1", "value between the dots", 1}, &in_dot);
    registry.color_textures["harlequin"] = {
        {}, [](const ParameterReader&, const AssetContext&, const Matrix&) {
            return formula_texture<Rgb>(&harlequin);
        }};
}

}  // namespace lxs::shading
