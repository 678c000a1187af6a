// Placement of two-dimensional textures on surfaces.
#include "uv_mapping.h"

#include <array>
#include <cmath>
#include <numbers>

#include "texture_space.h"

namespace lxs::shading {
namespace {

constexpr std::array<std::string_view, 5> kMappings{"uv", "spherical", "polar", "cylindrical",
                                                    "planar"};

}  // namespace

float UvMapping::turn(const Vec3& p) const {
    constexpr float kTurnsPerRadian = 0.5f * std::numbers::inv_pi_v<float>;
    const float share = std::atan2(p.y, p.x) * kTurnsPerRadian - turn_start_;
    return share - std::floor(share);
}

UvMapping::UvMapping(const ParameterReader& reader, const Matrix& to_world) {
    const auto number = [&](std::string_view name, double fallback) {
        return static_cast<float>(reader.number(name, fallback));
    };
    scale_ = {number("uscale", 1), number("vscale", 1)};
    delta_ = {number("udelta", 0), number("vdelta", 0)};
    const std::string mapping = reader.string("mapping", "uv");
    if (mapping == "planar") {
        kind_ = Kind::Planar;
        axis_s_ = reader.vector("v1", axis_s_);
        axis_t_ = reader.vector("v2", axis_t_);
        scale_ = Vec2(1.0f);  // the vectors' lengths are the scale
    } else if (mapping != "uv") {
        kind_ = mapping == "spherical" ? Kind::Spherical
                : mapping == "polar"   ? Kind::Polar
                                       : Kind::Cylindrical;
        const double start = reader.number("turnstart", 0);
        turn_start_ = static_cast<float>(start - std::floor(start));
        to_texture_ = inverse_or_fail(reader, "mapping", to_world);
    }
}

Vec2 UvMapping::place(const TexturePoint& point) const {
    if (kind_ == Kind::Uv) return point.uv;
    if (kind_ == Kind::Planar) return {point.p ^ axis_s_, point.p ^ axis_t_};
    const Vec3 p = point.p * to_texture_;
    if (kind_ == Kind::Cylindrical) return {turn(p), p.z};
    const float polar = std::atan2(std::hypot(p.x, p.y), p.z) * std::numbers::inv_pi_v<float>;
    return kind_ == Kind::Polar ? Vec2(polar, turn(p)) : Vec2(turn(p), polar);
}

std::vector<ParameterDeclaration> uv_mapping_parameters() {
    ParameterDeclaration mapping{"mapping", ParameterType::String, "uv",
                                 "where (s, t) come from: the surface's uv; spherical, polar and "
                                 "cylindrical: angles in the texture's space, s around z, of "
                                 "polar (not LuxRender's) t; planar: world positions along v1 and "
                                 "v2"};
    mapping.choices = kMappings;
    return {mapping,
            {"uscale", ParameterType::Float, "1", "repetitions along s (not planar)"},
            {"vscale", ParameterType::Float, "1", "repetitions along t (not planar)"},
            {"udelta", ParameterType::Float, "0", "shift along s, after scaling"},
            {"vdelta", ParameterType::Float, "0", "shift along t, after scaling"},
            {"turnstart", ParameterType::Float, "0",
             "share of a turn from x at which angles around z begin"},
            {"v1", ParameterType::Vector, "1 0 0",
             "planar mapping: s grows by 1 along it, per its "
             "squared length"},
            {"v2", ParameterType::Vector, "0 1 0", "planar mapping: likewise for t"}};
}

}  // namespace lxs::shading
