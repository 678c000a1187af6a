// Closed forms of what LuxRender 1.9 computes, in double precision and apart from our own code, and
// the directions and comparisons with which they are held against our materials.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bsdf_statistics.h"
#include "shading_fixture.h"

namespace lxs::lux {

inline constexpr double kPi = 3.14159265358979323846;

/// A pair of directions above the surface z = 0 whose x is the tangent along u.
struct Pair {
    double theta_o, phi_o, theta_i, phi_i;  ///< degrees

    static Vec3 direction(double theta, double phi) {
        const double t = theta * kPi / 180, p = phi * kPi / 180;
        return Vec3(static_cast<float>(std::sin(t) * std::cos(p)),
                    static_cast<float>(std::sin(t) * std::sin(p)), static_cast<float>(std::cos(t)));
    }
    Vec3 wo() const { return direction(theta_o, phi_o); }
    Vec3 wi() const { return direction(theta_i, phi_i); }
};

/// Away from grazing angles, where we keep surfaces from sending back more light than arrives and
/// LuxRender does not.
inline const std::vector<Pair>& pairs() {
    static const std::vector<Pair> all{{10, 0, 20, 180},  {30, 40, 25, 200}, {35, 10, 30, 150},
                                       {20, 90, 35, 300}, {2, 0, 36, 70},    {36, 200, 34, 20}};
    return all;
}

/// Cosines to the normal and to the half vector, and the half vector, of two directions above the
/// surface.
struct Half {
    double cos_o, cos_i, x, y, z, u;

    Half(const Vec3& wo, const Vec3& wi) : cos_o(wo.z), cos_i(wi.z) {
        const double a = double{wo.x} + wi.x, b = double{wo.y} + wi.y, c = double{wo.z} + wi.z;
        const double length = std::sqrt(a * a + b * b + c * c);
        x = a / length, y = b / length, z = c / length;
        u = wo.x * x + wo.y * y + wo.z * z;
    }
};

inline Rgb grey(double value) {
    return Rgb(static_cast<float>(value));
}

/// Fresnel's share at a dielectric of relative index `n`.
inline double dielectric(double c, double n) {
    const double s2 = (1 - c * c) / (n * n);
    if (s2 >= 1) return 1;
    const double t = std::sqrt(1 - s2);
    const double p = (t - n * c) / (t + n * c), s = (c - n * t) / (c + n * t);
    return 0.5 * (p * p + s * s);
}

inline double schlick_fresnel(double u, double r0) {
    return r0 + (1 - r0) * std::pow(1 - u, 5);
}

/// Facets whose azimuths are those that LuxRender draws; `u`, `v`: roughness.
struct Facets {
    double u, v;

    double r() const { return u * v; }
    double density(const Half& h) const {
        const double d = 1 + (r() - 1) * h.z * h.z;
        return r() / (d * d) * azimuth(h.x, h.y) / kPi;
    }
    /// Derivative of the inverse of phi = pi / 2 sqrt(u^2 p^2 / (1 - u^2 (1 - p^2))), by which
    /// LuxRender draws a quadrant's azimuth from the axis of the larger roughness.
    double azimuth(double x, double y) const {
        if (u == v) return 1;
        const double p = std::pow(std::min(u, v) / std::max(u, v), 2);
        const double phi =
            u < v ? std::atan2(std::abs(x), std::abs(y)) : std::atan2(std::abs(y), std::abs(x));
        const double t = phi / (kPi / 2);
        return p * p / std::pow(p * p + t * t * (1 - p * p), 1.5);
    }
    double shadowing(double c) const { return c / (c * (1 - r()) + r()); }
    /// D G / (4 cos_o cos_i).
    double reflection(const Half& h) const {
        return density(h) * shadowing(h.cos_o) * shadowing(h.cos_i) / (4 * h.cos_o * h.cos_i);
    }
};

/// What a coating of absorption `ka` and depth `d` leaves on the way in and out.
inline double coat_absorption(const Half& h, double ka, double d) {
    return std::exp(-ka * d * (1 / h.cos_o + 1 / h.cos_i));
}

/// Oren & Nayar's A + B max(0, cos) sin tan.
inline double oren_nayar(const Vec3& wo, const Vec3& wi, double degrees) {
    const double s2 = std::pow(degrees * kPi / 180, 2);
    const double a = 1 - s2 / (2 * (s2 + 0.33)), b = 0.45 * s2 / (s2 + 0.09);
    const double along = double{wo.x} * wi.x + double{wo.y} * wi.y;  // sin sin cos(phi_o - phi_i)
    return a + b * std::max(0.0, along) / std::max(std::abs(wo.z), std::abs(wi.z));
}

/// Holds the material's values of a channel against `expected(wo, wi)` for all pairs.
template <class Expected>
void expect_formula(const Material& material, double tolerance, const Expected& expected,
                    int channel = 1, const Vec3& flip_o = Vec3(1.0f),
                    const Vec3& flip_i = Vec3(1.0f)) {
    BsdfMemory memory;
    const Bsdf* bsdf = memory.scatter(material, shading_point());
    ASSERT_NE(bsdf, nullptr);
    for (const Pair& pair : pairs()) {
        const Vec3 wo = pair.wo() * flip_o, wi = pair.wi() * flip_i;
        const Rgb f = bsdf->evaluate(wo, wi, Transport::Radiance, kAllLobes);
        const double wanted = expected(wo, wi);
        EXPECT_NEAR(f[channel], wanted, tolerance * wanted + 1e-7)
            << "theta " << pair.theta_o << ", " << pair.theta_i << " phi " << pair.phi_o << ", "
            << pair.phi_i;
    }
}

inline const Vec3 kBelow(1, 1, -1);  ///< flips a direction to the back

}  // namespace lxs::lux
