// The error criteria; the paper's equation by equation.
#include "aips/core/trees/error_criterion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace aips {
namespace {

/// Keeps sums over many nodes finite.
constexpr double kMaxError = 1e280;
constexpr double kTriweightScale = 4 * std::numbers::inv_pi;

double clamp_error(double e) {
    return std::isnan(e) ? 0.0 : std::clamp(e, 0.0, kMaxError);
}

/// Half the second longest side of the photons' box: the disk inscribed in a patch of surface
/// (whose box is flat). The circumscribed one would take the patch's edge for a fall in density.
double kernel_radius(const Bounds& box) {
    const Vec3 e = box.extent();
    std::array<float, 3> sides{e.x, e.y, e.z};
    std::sort(sides.begin(), sides.end());
    return 0.5 * double(sides[1]);
}

double squared_distance(Vec3 a, Vec3 b) {
    const double x = double(a.x) - double(b.x);
    const double y = double(a.y) - double(b.y);
    const double z = double(a.z) - double(b.z);
    return x * x + y * y + z * z;
}

}  // namespace

double triweight(double s) {
    const double q = 1 - s * s;
    return q > 0 ? kTriweightScale * q * q * q : 0.0;
}

double triweight_laplacian(double s) {
    const double q = 1 - s * s;
    return q > 0 ? 12 * kTriweightScale * q * (3 * s * s - 1) : 0.0;
}

// Eq. 3. Hachisuka et al. 2010 estimate the bias of the density L = sum K(s_j) Phi_j / r^2 as
//     r^2 k2 / 2 * laplacian(L),  laplacian(L) = sum lap K(s_j) Phi_j / r^4.
// Departure: that is power per area, and eq. 4 adds it to powers. Multiplied by the area per photon
// under the kernel, pi r^2 / N, it has their unit, and the radius cancels:
//     B = k / (2 N) * sum lap K(s_j) Phi_j,  k = pi k2,
// eq. 3 with N_t read as the photons under the kernel. Departure: f_r is left out, being the same
// for all photons of a Lambertian node, where errors are compared between nodes only.
// Departure: the radius, which the paper does not give, is kernel_radius().
double bias_correction(std::span<const NodePhoton> photons) {
    Bounds box;
    for (const NodePhoton& photon : photons)
        box.extend(photon.position);
    const double radius = kernel_radius(box);
    if (!(radius > 0)) return 0;
    const double inverse = 1 / (radius * radius);
    const Vec3 center = box.lower * 0.5f + box.upper * 0.5f;
    double sum = 0;
    double under_kernel = 0;
    for (const NodePhoton& photon : photons) {
        const double s_squared = squared_distance(photon.position, center) * inverse;
        if (s_squared >= 1) continue;
        sum += triweight_laplacian(std::sqrt(s_squared)) * double(photon.value);
        ++under_kernel;
    }
    if (under_kernel == 0) return 0;
    constexpr double kKernelConstant = std::numbers::pi * kTriweightSecondMoment;
    return kKernelConstant / (2 * under_kernel) * sum;
}

// Eq. 4. B is one number per node, so the sum of (Phi_j - mean + B)^2 is that of the squared
// deviations plus N B^2: the deviations themselves sum to zero. (The paper's sum starts at j = 0,
// a misprint for 1.)
double corrected_variance(const ValueStatistics& powers, double bias) {
    const auto n = double(powers.count);
    return (powers.squared_deviations + n * bias * bias) / (n - 1);
}

double node_error(double weight, double variance, double volume, double count) {
    return clamp_error(weight * variance * volume / count);
}

ProgressiveCriterion::ProgressiveCriterion(double alpha) : alpha_(alpha) {
    if (!(alpha >= 0 && alpha < 1)) {
        throw std::invalid_argument("ProgressiveCriterion: alpha must be in [0, 1)");
    }
}

// Departure: in its first pass a node has no last error, and takes the present one as it is.
double ProgressiveCriterion::error(const NodeView& view) const {
    const Node& node = view.node;
    if (node.values.count < 2) return node.error;
    const double present = clamp_error(error_of_pass(view));
    if (!node.has_last_error) return present;
    return clamp_error((1 - alpha_) * present + alpha_ * node.last_error);
}

double PaperErrorCriterion::error_of_pass(const NodeView& view) const {
    const Node& node = view.node;
    const double variance = corrected_variance(node.values, bias_correction(view.photons));
    return node_error(node.weight, variance, view.volume, double(node.values.count));
}

float ImageErrorCriterion::value(float power, double score) const {
    return power > 0 && score > 0 ? float(std::sqrt(score) / double(power)) : 0.0f;
}

double ImageErrorCriterion::error_of_pass(const NodeView& view) const {
    const ValueStatistics& values = view.node.values;
    return std::sqrt(values.mean * values.mean + values.squared_deviations / double(values.count));
}

}  // namespace aips
