// A density over the unit square from few weighed points in its cells.
//
// A Polya tree (Lavine 1992): the square is quartered down to the cells, and how a quarter shares
// its mass out among its own quarters is blended with equal shares. The few points in a fine
// quarter tell little, while all points together tell how the coarse ones compare.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace aips {

/// Masses of the side x side quarters of a square whose (side / 2)^2 quarters have the masses
/// `wholes`; sums[cell] were met in its n x n cells, equal shares weigh as much as a sum `prior`.
template <std::size_t n>
std::array<double, n * n> polya_quarters(const std::array<double, n * n>& wholes,
                                         std::span<const double, n * n> sums, std::size_t side,
                                         double prior) {
    std::array<double, n * n> met{}, masses{};
    for (std::size_t cell = 0; cell < n * n; ++cell) {
        const std::size_t x = cell % n * side / n, y = cell / n * side / n;
        met[y * side + x] += sums[cell];
    }
    const std::size_t half = side / 2;
    for (std::size_t whole = 0; whole < half * half; ++whole) {
        const std::size_t corner = whole / half * 2 * side + whole % half * 2;
        const std::array<std::size_t, 4> parts{corner, corner + 1, corner + side,
                                               corner + side + 1};
        double sum = prior;
        for (const std::size_t part : parts)
            sum += met[part];
        for (const std::size_t part : parts)
            masses[part] = wholes[whole] * (met[part] + 0.25 * prior) / sum;
    }
    return masses;
}

/// Density (mean 1) of n x n cells, n a power of two, in which `sums` were met; at each level equal
/// shares weigh as much as a sum `prior` > 0.
template <std::size_t n>
void polya_density(std::span<const double, n * n> sums, double prior,
                   std::span<float, n * n> density) {
    static_assert(n > 0 && (n & (n - 1)) == 0);
    std::array<double, n * n> masses{1};
    for (std::size_t side = 2; side <= n; side *= 2)
        masses = polya_quarters<n>(masses, sums, side, prior);
    std::transform(masses.begin(), masses.end(), density.begin(),
                   [](double mass) { return float(mass * double(n * n)); });
}

}  // namespace aips
