// How light crosses a rough dielectric coat to a diffuse base and back, tabulated: by the model of
// Guo, Hasan and Zhao 2018, "Position-Free Monte Carlo Simulation for Arbitrary Layered BSDFs", as
// pbrt-v4 has it (section 14.3), whose random walk has a closed form where the base is diffuse.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace lxs::shading {

/// A coat of `index` over a layer that lets exp(-thickness / cosine) of what crosses it through.
class CoatTable {
  public:
    struct Entry {
        float reflected = 0;    ///< share of light from outside that the coat throws back
        float transmitted = 0;  ///< share that comes to the base
    };
    /// Means over diffuse light.
    struct Means {
        float transmitted = 0;  ///< of light from outside: what comes to the base
        float thrown_back = 0;  ///< of light from the base: what comes back to it
    };

    /// For alpha in [least, most] of facets by Trowbridge and Reitz; made by a fixed quadrature,
    /// which takes half a millisecond for one roughness.
    CoatTable(float index, float thickness, float least, float most);

    Entry at(float alpha, float cosine) const;
    Means means(float alpha) const;

  private:
    static constexpr int kCosines = 32;

    /// Of one roughness: shares by the cosine.
    struct Row {
        std::array<Entry, kCosines> entries;
        Means means;

        Row(float index, float thickness, float alpha);
        Entry at(float cosine) const;
    };
    /// Where alpha lies: a row, and how far on the way to the next one.
    struct Place {
        std::size_t row;
        float on;
    };
    Place place(float alpha) const;

    float least_, step_;
    std::vector<Row> rows_;
};

}  // namespace lxs::shading
