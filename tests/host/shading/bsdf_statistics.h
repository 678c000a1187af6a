// Statistical comparisons of a Bsdf's sampling with its density and values.
#pragma once

#include <random>

#include "lxs/sdk/bsdf.h"

namespace lxs {

/// Uniform numbers in [0, 1) from a fixed seed.
class UniformSource {
  public:
    explicit UniformSource(std::uint32_t seed) : engine_(seed) {}
    float operator()() { return static_cast<float>(engine_() >> 8) * 0x1p-24f; }
    Vec2 pair() {
        const float x = (*this)();
        return {x, (*this)()};
    }
    Vec3 direction();

  private:
    std::mt19937 engine_;
};

/// p-value of a chi-square test of sampled non-specular directions against `pdf`, over cells of
/// equal solid angle on the sphere around `axis` and one cell for everything that isn't scattered
/// or is specular. Cells with fewer than 5 expected samples are pooled.
double chi_square_p_value(const Bsdf& bsdf, const Vec3& wo, const Vec3& axis, LobeMask mask,
                          std::uint32_t seed);

/// Mean over samples of the weight, per channel: the albedo seen from `wo`.
struct MeanWeight {
    Rgb mean{0.0f};
    Rgb deviation{0.0f};  ///< standard deviation of the mean
};
MeanWeight mean_weight(const Bsdf& bsdf, const Vec3& wo, Transport transport, int samples,
                       std::uint32_t seed);

/// Integral of evaluate * |cos(wi, ns)| over all directions by a fixed quadrature around `ns`.
Rgb integrated_albedo(const Bsdf& bsdf, const Vec3& wo, const Vec3& ns);

}  // namespace lxs
