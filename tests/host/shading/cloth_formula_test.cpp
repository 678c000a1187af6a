// Cloth at ten settings against its formula in double precision: the fibres' phase function (d'Eon
// et al. 2011, around the fibre Marschner et al. 2003), and what a yarn in the cloth shows of it.
#include "bsdfs/woven_bsdf.h"
#include "lux_formulas.h"

namespace lxs::lux::cloth_formula_test {
namespace {

/// A fibre's roughness and what goes through it, and how the yarn's surface leans along u.
struct Setting {
    double degrees, through, lean;
};
const std::vector<Setting> kYarns{{5, 0, 0},       {7, 0.2, 10},   {8, 0.3, -15}, {10, 0.5, 20},
                                  {12, 0.4, 0},    {14, 0.3, -25}, {16, 0, 30},   {18, 0.6, 5},
                                  {25, 0.25, -30}, {35, 0.1, 12}};

double dot(const Vec3& a, const Vec3& b) {
    return double{a.x} * b.x + double{a.y} * b.y + double{a.z} * b.z;
}

/// Along the fibre csch(1/v) / (2 v) exp(-s_a s_b / v) I0(c_a c_b / v), around it cos(phi / 2) / 4
/// or a wrapped Cauchy distribution about pi whose mean cosine is 0.6.
double phase(const Vec3& tangent, const Vec3& a, const Vec3& b, const Setting& s) {
    const double v = std::pow(s.degrees * kPi / 180, 2);
    const double sa = dot(tangent, a), sb = dot(tangent, b);
    const double ca = std::sqrt(1 - sa * sa), cb = std::sqrt(1 - sb * sb);
    const double along =
        std::exp(-sa * sb / v) * std::cyl_bessel_i(0, ca * cb / v) / (2 * v * std::sinh(1 / v));
    const double cosine = std::clamp((dot(a, b) - sa * sb) / (ca * cb), -1.0, 1.0);
    constexpr double kForward = 0.6;
    const double passed =
        (1 - kForward * kForward) / (2 * kPi * (1 + kForward * kForward + 2 * kForward * cosine));
    return along *
           ((1 - s.through) * 0.25 * std::cos(0.5 * std::acos(cosine)) + s.through * passed);
}

shading::FibreLobe fibres(const Setting& s) {
    return {static_cast<float>(std::pow(s.degrees * kPi / 180, 2)), static_cast<float>(s.through)};
}

TEST(ClothFormula, FibresPhaseFunction) {
    const Vec3 tangent(0.6f, 0.8f, 0);
    for (const Setting& s : kYarns) {
        for (const Pair& pair : pairs()) {
            const double wanted = phase(tangent, pair.wo(), pair.wi(), s);
            EXPECT_NEAR(fibres(s).value(tangent, pair.wo(), pair.wi()), wanted,
                        2e-4 * wanted + 1e-7)
                << s.degrees;
        }
    }
}

TEST(ClothFormula, YarnInTheCloth) {
    constexpr double kDiffuseShare = 0.3, kFibreShare = 0.6;
    for (const Setting& s : kYarns) {
        const Vec3 normal = Pair::direction(s.lean, 0), tangent(normal.z, 0, -normal.x);
        const shading::WovenBsdf bsdf(grey(kDiffuseShare), grey(kFibreShare),
                                      {normal, tangent, fibres(s)},
                                      Frame(Vec3(0, 0, 1), Vec3(1, 0, 0)), Vec3(0, 0, 1));
        // What a direction sees of the yarn per area of cloth: neighbours hide the rest.
        const auto seen = [&](const Vec3& w) {
            return std::min(double{w.z}, std::max(0.0, dot(normal, w)) / normal.z);
        };
        for (const Pair& pair : pairs()) {
            const Vec3 wo = pair.wo(), wi = pair.wi();
            const double mo = seen(wo), mi = seen(wi);
            const double layer = mo / wo.z * mi / wi.z * (1 + mo * mi) / (mo + mi);
            const double wanted =
                kDiffuseShare / kPi + kFibreShare * phase(tangent, wo, wi, s) * layer;
            EXPECT_NEAR(bsdf.evaluate(wo, wi, Transport::Radiance, kAllLobes).y, wanted,
                        3e-4 * wanted)
                << s.degrees << ' ' << s.lean;
        }
    }
}

}  // namespace
}  // namespace lxs::lux::cloth_formula_test
