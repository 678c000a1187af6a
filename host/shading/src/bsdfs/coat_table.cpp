// How light crosses a rough dielectric coat: quadrature over the facets that a direction sees.
#include "coat_table.h"

#include <algorithm>
#include <cmath>

#include "directions.h"
#include "fresnel.h"
#include "trowbridge_reitz.h"

namespace lxs::shading {
namespace {

constexpr int kRoughnesses = 12;  ///< rows, where the roughness varies
constexpr int kSide = 24;         ///< of the grid of facets
constexpr float kLeastCosine = 1e-3f;

/// What facets do with light from `cosine`, `eta` being the index on the other side over that on
/// this one: `reflect` and `refract` take the share and the cosine of the direction that it takes.
template <class Reflect, class Refract>
void visit(const TrowbridgeReitz& facets, float cosine, float eta, const Reflect& reflect_to,
           const Refract& refract_to) {
    const Vec3 wo(std::sqrt(std::max(0.0f, 1 - cosine * cosine)), 0, cosine);
    for (int i = 0; i < kSide * kSide; ++i) {
        const int row = i / kSide, column = i % kSide;
        const Vec2 u((static_cast<float>(row) + 0.5f) / kSide,
                     (static_cast<float>(column) + 0.5f) / kSide);
        const Vec3 h = facets.sample_visible(wo, u);
        const float to_facet = wo.dot(h);
        if (!(to_facet > 0)) continue;
        const float fresnel = fresnel_dielectric(to_facet, eta);
        const auto seen = [&](const Vec3& wi) { return facets.seen_too(wo, wi) / (kSide * kSide); };
        if (const Vec3 wi = reflect(wo, h); wi.z > 0) reflect_to(fresnel * seen(wi), wi.z);
        const float sin2 = (1 - to_facet * to_facet) / (eta * eta);
        if (sin2 >= 1) continue;
        const Vec3 wi = h * (to_facet / eta - std::sqrt(1 - sin2)) - wo / eta;
        if (wi.z < 0) refract_to((1 - fresnel) * seen(wi), -wi.z);
    }
}

CoatTable::Entry between(const CoatTable::Entry& a, const CoatTable::Entry& b, float t) {
    return {std::lerp(a.reflected, b.reflected, t), std::lerp(a.transmitted, b.transmitted, t)};
}

}  // namespace

CoatTable::Row::Row(float index, float thickness, float alpha) {
    const TrowbridgeReitz facets(alpha, alpha);
    const auto through = [&](float cosine) { return std::exp(-thickness / cosine); };
    float weights = 0;
    for (int i = 0; i < kCosines; ++i) {
        const float cosine =
            std::max(kLeastCosine, static_cast<float>(i) / static_cast<float>(kCosines - 1));
        Entry& entry = entries[i];
        visit(
            facets, cosine, index, [&](float share, float) { entry.reflected += share; },
            [&](float share, float inside) { entry.transmitted += share * through(inside); });
        // The trapezoid rule of cosines.
        const float weight = i == 0 || i == kCosines - 1 ? 0.5f * cosine : cosine;
        weights += weight;
        means.transmitted += weight * entry.transmitted;
    }
    means.transmitted /= weights;
    // Below the critical cosine a smooth coat throws all back; above it 1 - R begins like a root.
    constexpr int kNodes = 32;
    const float critical = std::sqrt(std::max(0.0f, 1 - 1 / (index * index)));
    const auto add = [&](float cosine, float width) {
        visit(
            facets, cosine, 1 / index,
            [&](float share, float inside) {
                means.thrown_back += 2 * cosine * width * share * through(cosine) * through(inside);
            },
            [](float, float) {});
    };
    for (int i = 0; i < kNodes; ++i) {
        const float t = (static_cast<float>(i) + 0.5f) / kNodes;
        add(critical * t, critical / kNodes);
        add(critical + (1 - critical) * t * t, 2 * t * (1 - critical) / kNodes);
    }
}

CoatTable::Entry CoatTable::Row::at(float cosine) const {
    const float place = std::clamp(cosine, 0.0f, 1.0f) * (kCosines - 1);
    const int i = std::min(static_cast<int>(place), kCosines - 2);
    return between(entries[i], entries[i + 1], place - static_cast<float>(i));
}

CoatTable::CoatTable(float index, float thickness, float least, float most) : least_(least) {
    const int rows = most > least ? kRoughnesses : 1;
    step_ = rows > 1 ? (most - least) / static_cast<float>(rows - 1) : 0;
    for (int i = 0; i < rows; ++i)
        rows_.emplace_back(index, thickness, least + step_ * static_cast<float>(i));
}

CoatTable::Place CoatTable::place(float alpha) const {
    if (rows_.size() == 1) return {0, 0};
    const float last = static_cast<float>(rows_.size() - 1);
    const float place = std::clamp((alpha - least_) / step_, 0.0f, last);
    const auto row = std::min(static_cast<std::size_t>(place), rows_.size() - 2);
    return {row, place - static_cast<float>(row)};
}

CoatTable::Entry CoatTable::at(float alpha, float cosine) const {
    const Place p = place(alpha);
    const Entry entry = rows_[p.row].at(cosine);
    return p.on > 0 ? between(entry, rows_[p.row + 1].at(cosine), p.on) : entry;
}

CoatTable::Means CoatTable::means(float alpha) const {
    const Place p = place(alpha);
    const Means& means = rows_[p.row].means;
    if (!(p.on > 0)) return means;
    const Means& next = rows_[p.row + 1].means;
    return {std::lerp(means.transmitted, next.transmitted, p.on),
            std::lerp(means.thrown_back, next.thrown_back, p.on)};
}

}  // namespace lxs::shading
