// How the intensity of a small piece of a surface depends on direction.
#include "front_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lxs {
namespace {

/// Cosine (0.6 degrees above the surface) below which the radiance no longer grows, so that it is
/// at most 100 times L * map: the intensity falls to 0 there.
constexpr float kGrazing = 0.01f;

/// Rows that reach in front. Those behind them would shine in at the horizon between pixels, so the
/// last of these stands for them.
std::size_t front_rows(const LatLongMap& map) {
    return (map.height() + 1) / 2;
}

/// Draws directions in front. A row of pixels that the horizon cuts is drawn in full.
SphereProfile drawn_in_front(const LatLongMap& map) {
    return {Rotation(Matrix(), {}), map, map.importance([](const Vec2& st) {
                return st.y <= 0.5f ? std::sin(std::numbers::pi * double(st.y)) : 0.0;
            })};
}

/// Mean over the azimuths at height `y`, in rows from the middle of the first, of the map whose
/// rows have these means, as its lookup blends them; it goes on as its last row.
Imath::V3d mean_at(const std::vector<Rgb>& rows, double y) {
    const double below = std::floor(y);
    const auto row = [&](double i) {
        return Imath::V3d(
            rows[static_cast<std::size_t>(std::clamp(i, 0.0, double(rows.size() - 1)))]);
    };
    return row(below) * (1 - (y - below)) + row(below + 1) * (y - below);
}

/// Integral of radiance times cosine, which is that of the intensity but for grazing directions.
Rgb front_flux(const LatLongMap& map) {
    constexpr std::size_t kSteps = 8192;  // 50 of them below the grazing cosine
    constexpr double kQuarter = std::numbers::pi / 2;
    const auto height = static_cast<double>(map.height());
    std::vector<Rgb> rows = map.row_means();
    rows.resize(front_rows(map));
    Imath::V3d sum(0.0);
    for (std::size_t i = 0; i < kSteps; ++i) {
        const double share = (static_cast<double>(i) + 0.5) / kSteps, theta = kQuarter * share;
        const double grazing = std::min(1.0, std::cos(theta) / double(kGrazing));
        sum += mean_at(rows, share / 2 * height - 0.5) * (std::sin(theta) * grazing);
    }
    return Rgb(sum * (2 * std::numbers::pi * kQuarter / kSteps));
}

}  // namespace

FrontProfile::FrontProfile(const LatLongMap& map)
    : sphere_(drawn_in_front(map.repeated_from(front_rows(map)))), flux_(front_flux(map)) {
    const float total = luminance(flux_);
    scale_ = total > 0 ? std::numbers::pi_v<float> / total : 0.0f;
    flux_ *= scale_;
}

Rgb FrontProfile::radiance(const Vec3& w) const {
    return w.z > 0 ? sphere_.at(w) * (scale_ / std::max(w.z, kGrazing)) : Rgb(0.0f);
}

float FrontProfile::sample(const Vec2& u, Vec3& w) const {
    const float density = sphere_.sample(u, w);
    return density > 0 && w.z > 0 ? density : 0;
}

bool FrontProfile::coordinates(const Vec3& w, Vec2& u) const {
    return w.z > 0 && sphere_.coordinates(w, u);
}

}  // namespace lxs
