// Share of light that a whole MicrofacetLobe sends back, tabulated.
#include "microfacet_albedo.h"

#include <algorithm>
#include <cmath>

#include "fresnel.h"
#include "microfacet_lobe.h"

namespace lxs::shading {
namespace {

// Nodes lie denser towards grazing angles and smooth facets, where the albedo changes fastest.
float node_coordinate(float value, int size) {
    return std::sqrt(std::clamp(value, 0.0f, 1.0f)) * static_cast<float>(size - 1);
}
float node_value(int i, int size) {
    const float x = static_cast<float>(i) / static_cast<float>(size - 1);
    return x * x;
}

/// Position between two nodes.
struct Cell {
    int index;
    float rest;

    Cell(float coordinate, int size)
        : index(std::min(static_cast<int>(coordinate), size - 2)),
          rest(coordinate - static_cast<float>(index)) {}
    float blend(float a, float b) const { return a + rest * (b - a); }
};

/// Calls `add`(weight, cosine to the facet) for facets that are seen under `cosine`; weights sum to
/// the albedo of facets that reflect everything.
template <class Add>
void visit_facets(const MicrofacetLobe& lobe, float cosine, Add add) {
    constexpr int kZeniths = 32, kAzimuths = 24;
    constexpr float kGolden = 0.61803399f, kScale = 1.0f / (kZeniths * kAzimuths);
    const Vec3 wo(std::sqrt(std::max(0.0f, 1 - cosine * cosine)), 0, cosine);
    for (int i = 0; i < kZeniths * kAzimuths; ++i) {
        const int row = i / kAzimuths, column = i % kAzimuths;
        const auto zenith = static_cast<float>(row), azimuth = static_cast<float>(column);
        const float choice = kGolden * static_cast<float>(i);
        Vec3 wi;
        HalfVector half;
        if (!lobe.sample(wo, {(zenith + 0.5f) / kZeniths, (azimuth + 0.5f) / kAzimuths},
                         choice - std::floor(choice), wi, half))
            continue;
        add(kScale * lobe.value(half) * half.wi.z / lobe.pdf(half), half.cosine);
    }
}

MicrofacetAlbedo::Entry integrate(const MicrofacetLobe& lobe, float cosine) {
    MicrofacetAlbedo::Entry sum;
    visit_facets(lobe, cosine, [&](float weight, float to_facet) {
        const float m = 1 - to_facet;
        sum.constant += weight;
        sum.grazing += weight * m * m * m * m * m;
    });
    return {std::min(1.0f, sum.constant), std::min(1.0f, sum.grazing)};
}

constexpr float kMinTableCosine = 1e-3f;

/// Cosine-weighted mean of values at the nodes of cosines.
float mean_over_cosines(int size, auto value) {
    float sum = 0;
    for (int c = 0; c + 1 < size; ++c) {
        const float a = node_value(c, size), b = node_value(c + 1, size);
        sum += (b * b - a * a) * 0.5f * (value(c) + value(c + 1));
    }
    return sum;
}

}  // namespace

const MicrofacetAlbedo& MicrofacetAlbedo::table() {
    static const MicrofacetAlbedo table;
    return table;
}

MicrofacetAlbedo::MicrofacetAlbedo() {
    const Vec3 up(0, 0, 1);
    for (int r = 0; r < kSize; ++r) {
        const float alpha = node_value(r, kSize);
        const MicrofacetLobe lobe(SchlickDistribution(alpha, alpha), Frame(up), up);
        for (int c = 0; c < kSize; ++c)
            entries_[r][c] = integrate(lobe, std::max(kMinTableCosine, node_value(c, kSize)));
        averages_[r] = mean_over_cosines(kSize, [&](int c) { return entries_[r][c].constant; });
        grazing_averages_[r] =
            mean_over_cosines(kSize, [&](int c) { return entries_[r][c].grazing; });
    }
}

MicrofacetAlbedo::Entry MicrofacetAlbedo::at(float c, float roughness) const {
    const Cell row(node_coordinate(std::sqrt(roughness), kSize), kSize);
    const Cell column(node_coordinate(c, kSize), kSize);
    const auto& lower = entries_[row.index];
    const auto& upper = entries_[row.index + 1];
    const int i = column.index;
    return {row.blend(column.blend(lower[i].constant, lower[i + 1].constant),
                      column.blend(upper[i].constant, upper[i + 1].constant)),
            row.blend(column.blend(lower[i].grazing, lower[i + 1].grazing),
                      column.blend(upper[i].grazing, upper[i + 1].grazing))};
}

float MicrofacetAlbedo::average(float roughness) const {
    const Cell row(node_coordinate(std::sqrt(roughness), kSize), kSize);
    return row.blend(averages_[row.index], averages_[row.index + 1]);
}

float MicrofacetAlbedo::average_grazing(float roughness) const {
    const Cell row(node_coordinate(std::sqrt(roughness), kSize), kSize);
    return row.blend(grazing_averages_[row.index], grazing_averages_[row.index + 1]);
}

const DielectricRise& DielectricRise::table() {
    static const DielectricRise table;
    return table;
}

float DielectricRise::rise(float cosine, float r0) {
    const float root = std::sqrt(r0);
    return (fresnel_dielectric(cosine, (1 + root) / (1 - root)) - r0) / (1 - r0);
}

DielectricRise::DielectricRise() {
    static constexpr float kLeast = 1e-6f;  // reflectance: an index of 1 has no Fresnel term
    const auto reflectance = [](int step) {
        return std::max(node_value(step, kSteps + 1), kLeast);
    };
    const Vec3 up(0, 0, 1);
    for (int r = 0; r < kSize; ++r) {
        const float alpha = node_value(r, kSize);
        const MicrofacetLobe lobe(SchlickDistribution(alpha, alpha), Frame(up), up);
        for (int c = 0; c < kSize; ++c) {
            Steps& entry = entries_[r][c];
            entry.fill(0);
            visit_facets(lobe, std::max(kMinTableCosine, node_value(c, kSize)),
                         [&](float weight, float to_facet) {
                             for (int i = 0; i < kSteps; ++i)
                                 entry[i] += weight * rise(to_facet, reflectance(i));
                         });
        }
        for (int i = 0; i < kSteps; ++i)
            averages_[r][i] = mean_over_cosines(kSize, [&](int c) { return entries_[r][c][i]; });
    }
    constexpr int kCosines = 512;
    for (int i = 0; i < kSteps; ++i) {
        means_[i] = 0;
        for (int c = 0; c < kCosines; ++c) {
            const float cosine = (static_cast<float>(c) + 0.5f) / kCosines;
            means_[i] += 2 * cosine * rise(cosine, reflectance(i)) / kCosines;
        }
    }
}

float DielectricRise::at(float c, float roughness, float r0) const {
    const Cell row(node_coordinate(std::sqrt(roughness), kSize), kSize);
    const Cell column(node_coordinate(c, kSize), kSize);
    const Cell step(std::min(node_coordinate(r0, kSteps + 1), kSteps - 1.0f), kSteps);
    const auto seen = [&](int r) {
        const auto along = [&](int i) {
            const auto& line = entries_[r];
            return column.blend(line[column.index][i], line[column.index + 1][i]);
        };
        return step.blend(along(step.index), along(step.index + 1));
    };
    return row.blend(seen(row.index), seen(row.index + 1));
}

float DielectricRise::average(float roughness, float r0) const {
    const Cell row(node_coordinate(std::sqrt(roughness), kSize), kSize);
    const Cell step(std::min(node_coordinate(r0, kSteps + 1), kSteps - 1.0f), kSteps);
    const auto seen = [&](int r) {
        return step.blend(averages_[r][step.index], averages_[r][step.index + 1]);
    };
    return row.blend(seen(row.index), seen(row.index + 1));
}

float DielectricRise::mean(float r0) const {
    const Cell step(std::min(node_coordinate(r0, kSteps + 1), kSteps - 1.0f), kSteps);
    return step.blend(means_[step.index], means_[step.index + 1]);
}

}  // namespace lxs::shading
