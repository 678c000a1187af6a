// Share of light that a whole MicrofacetLobe sends back, tabulated.
#include "microfacet_albedo.h"

#include <algorithm>
#include <cmath>

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

MicrofacetAlbedo::Entry integrate(const MicrofacetLobe& lobe, float cosine) {
    constexpr int kZeniths = 32, kAzimuths = 24;
    constexpr float kGolden = 0.61803399f;
    const Vec3 wo(std::sqrt(std::max(0.0f, 1 - cosine * cosine)), 0, cosine);
    MicrofacetAlbedo::Entry sum;
    for (int i = 0; i < kZeniths * kAzimuths; ++i) {
        const int row = i / kAzimuths, column = i % kAzimuths;
        const auto zenith = static_cast<float>(row), azimuth = static_cast<float>(column);
        const float choice = kGolden * static_cast<float>(i);
        Vec3 wi;
        HalfVector half;
        if (!lobe.sample(wo, {(zenith + 0.5f) / kZeniths, (azimuth + 0.5f) / kAzimuths},
                         choice - std::floor(choice), wi, half))
            continue;
        const float weight = lobe.value(half) * half.wi.z / lobe.pdf(half);
        const float m = 1 - half.cosine;
        sum.constant += weight;
        sum.grazing += weight * m * m * m * m * m;
    }
    constexpr float kScale = 1.0f / (kZeniths * kAzimuths);
    return {std::min(1.0f, sum.constant * kScale), std::min(1.0f, sum.grazing * kScale)};
}

}  // namespace

const MicrofacetAlbedo& MicrofacetAlbedo::table() {
    static const MicrofacetAlbedo table;
    return table;
}

MicrofacetAlbedo::MicrofacetAlbedo() {
    constexpr float kMinTableCosine = 1e-3f;
    const Vec3 up(0, 0, 1);
    for (int r = 0; r < kSize; ++r) {
        const float alpha = node_value(r, kSize);
        const MicrofacetLobe lobe(SchlickDistribution(alpha, alpha), Frame(up), up);
        for (int c = 0; c < kSize; ++c)
            entries_[r][c] = integrate(lobe, std::max(kMinTableCosine, node_value(c, kSize)));
        float sum = 0;
        for (int c = 0; c + 1 < kSize; ++c) {
            const float a = node_value(c, kSize), b = node_value(c + 1, kSize);
            sum += (b * b - a * a) * 0.5f * (entries_[r][c].constant + entries_[r][c + 1].constant);
        }
        averages_[r] = sum;
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

}  // namespace lxs::shading
