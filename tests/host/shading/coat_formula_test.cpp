// Glossy materials and car paint against LuxRender's formulas, ten settings each.
#include "lux_formulas.h"
#include "lxs/spectrum/reflectance_colour.h"

namespace lxs::lux::coat_formula_test {
namespace {

struct Coat {
    double kd, ks, u, v, ka = 0, d = 0, index = 0, sigma = 0;

    double r0() const { return index > 0 ? ks * std::pow((index - 1) / (index + 1), 2) : ks; }
    std::vector<ParameterValue> values(const std::string& prefix = "") const {
        const auto grey = [](double c) { return Rgb(static_cast<float>(c)); };
        std::vector<ParameterValue> all{
            color(prefix + "Ks", grey(ks)),   color(prefix + "Ka", grey(ka)),
            number(prefix + "d", d),          number(prefix + "index", index),
            number(prefix + "uroughness", u), number(prefix + "vroughness", v)};
        if (prefix.empty()) all.push_back(color("Kd", grey(kd)));
        return all;
    }
    double facets(const Half& h) const {
        return schlick_fresnel(h.u, r0()) * Facets{u, v}.reflection(h);
    }
    /// What the coating leaves of the base.
    double left(const Half& h) const {
        return coat_absorption(h, ka, d) * (1 - schlick_fresnel(h.u, r0()));
    }
};

const std::vector<Coat> kCoats{{0.5, 0.04, 0.1, 0.1},
                               {0.2, 0.1, 0.3, 0.3},
                               {0.7, 0.02, 0.05, 0.05},
                               {0.6, 0.06, 0.1, 0.3},
                               {0.6, 0.06, 0.3, 0.1},
                               {0.5, 0.04, 0.2, 0.2, 0.7, 0.4},
                               {0.5, 1, 0.2, 0.2, 0, 0, 1.5},
                               {0.5, 0.5, 0.2, 0.2, 0, 0, 1.8},
                               {0.6, 0.05, 0.2, 0.2, 0, 0, 0, 30},
                               {0.4, 0.05, 0.2, 0.25, 1, 0.2, 0, 75}};
// A grain's shadowing is limited a little even here.
constexpr double kTolerance = 6e-3;

TEST(CoatFormula, Glossy) {
    ShadingFixture scene;
    for (const Coat& c : kCoats) {
        auto values = c.values();
        values.push_back(number("sigma", c.sigma));
        const auto material = scene.make_material("glossy", values);
        expect_formula(*material, kTolerance, [&](const Vec3& wo, const Vec3& wi) {
            const Half h(wo, wi);
            return c.facets(h) + c.left(h) * c.kd / kPi * oren_nayar(wo, wi, c.sigma);
        });
        // The back shows the base alone.
        expect_formula(
            *material, kTolerance,
            [&](const Vec3& wo, const Vec3& wi) {
                return c.kd / kPi * oren_nayar(wo, wi, c.sigma);
            },
            1, kBelow, kBelow);
    }
}

TEST(CoatFormula, GlossyThatIsNotSeparable) {
    ShadingFixture scene;
    for (const Coat& c : kCoats) {
        auto values = c.values();
        values.push_back(flag("separable", false));
        const auto material = scene.make_material("glossy", values);
        expect_formula(*material, kTolerance, [&](const Vec3& wo, const Vec3& wi) {
            const Half h(wo, wi);
            return c.facets(h) + c.left(h) * c.kd / kPi;
        });
        expect_formula(
            *material, kTolerance,
            [&](const Vec3& wo, const Vec3& wi) {
                return c.left(Half(wo * kBelow, wi * kBelow)) * c.kd / kPi;
            },
            1, kBelow, kBelow);
    }
}

TEST(CoatFormula, GlossyLossy) {
    ShadingFixture scene;
    for (const Coat& c : kCoats) {
        for (const char* name : {"glossy_lossy", "substrate", "plastic"}) {
            expect_formula(
                *scene.make_material(name, c.values()), 1e-3, [&](const Vec3& wo, const Vec3& wi) {
                    const Half h(wo, wi);
                    const auto shade = [](double cosine) {
                        return 1 - std::pow(1 - cosine / 2, 5);
                    };
                    const double base =
                        28 / (23 * kPi) * c.kd * (1 - c.r0()) * shade(h.cos_o) * shade(h.cos_i);
                    return base * coat_absorption(h, c.ka, c.d) +
                           Facets{c.u, c.v}.density(h) * schlick_fresnel(h.u, c.r0()) /
                               (4 * h.u * std::max(h.cos_o, h.cos_i));
                });
        }
    }
}

TEST(CoatFormula, GlossyTranslucent) {
    ShadingFixture scene;
    constexpr double kThrough = 0.5;
    for (std::size_t i = 0; i < kCoats.size(); ++i) {
        const Coat &front = kCoats[i], &back = kCoats[(i + 3) % kCoats.size()];
        auto values = front.values();
        for (const ParameterValue& value : back.values("backface_"))
            values.push_back(value);
        values.push_back(color("Kt", Rgb(static_cast<float>(kThrough))));
        values.push_back(flag("onesided", false));
        const auto material = scene.make_material("glossytranslucent", values);
        expect_formula(*material, kTolerance, [&](const Vec3& wo, const Vec3& wi) {
            const Half h(wo, wi);
            return front.facets(h) + front.left(h) * front.kd / kPi;
        });
        expect_formula(
            *material, kTolerance,
            [&](const Vec3& wo, const Vec3& wi) {
                const Half h(wo * kBelow, wi * kBelow);
                return back.facets(h) + back.left(h) * front.kd / kPi;
            },
            1, kBelow, kBelow);
        expect_formula(
            *material, kTolerance,
            [&](const Vec3& wo, const Vec3& wi) {
                const Half h(wo, wi * kBelow);
                const double past = std::sqrt((1 - schlick_fresnel(h.u, front.r0())) *
                                              (1 - schlick_fresnel(h.u, back.r0())));
                const double left =
                    std::exp(-front.ka * front.d / h.cos_o - back.ka * back.d / h.cos_i);
                return past * left * kThrough * (1 - front.kd) / kPi;
            },
            1, Vec3(1.0f), kBelow);
    }
}

TEST(CoatFormula, GlossyCoating) {
    ShadingFixture scene;
    scene.materials["base"] =
        scene.make_material("mattetranslucent", {color("Kr", Rgb(0.3f)), color("Kt", Rgb(0.4f))});
    for (const Coat& c : kCoats) {
        auto values = c.values();
        values.pop_back();  // Kd
        values.push_back(text("basematerial", "base"));
        const auto material = scene.make_material("glossycoating", values);
        expect_formula(*material, kTolerance, [&](const Vec3& wo, const Vec3& wi) {
            const Half h(wo, wi);
            return c.facets(h) + c.left(h) * 0.3 / kPi;
        });
        expect_formula(
            *material, kTolerance, [](const Vec3&, const Vec3&) { return 0.3 / kPi; }, 1, kBelow,
            kBelow);
        expect_formula(
            *material, kTolerance,
            [&](const Vec3& wo, const Vec3& wi) {
                const Half h(wo, wi * kBelow);
                return coat_absorption(h, c.ka, c.d) * std::sqrt(1 - schlick_fresnel(h.u, c.r0())) *
                       0.4 / kPi;
            },
            1, Vec3(1.0f), kBelow);
    }
}

/// Lobes of Ks, R and M.
struct Paint {
    const char* name;
    Rgb kd;
    struct Lobe {
        Rgb ks;
        double r, m;
    } lobes[3];
};

// From LuxRender 1.9's table.
const std::vector<Paint> kPaints{{"ford f8",
                                  {0.0012f, 0.0015f, 0.0018f},
                                  {{{0.0049f, 0.0076f, 0.0120f}, 0.15, 0.32},
                                   {{0.0100f, 0.0130f, 0.0180f}, 0.087, 0.11},
                                   {{0.0070f, 0.0065f, 0.0077f}, 0.9, 0.013}}},
                                 {"polaris silber",
                                  {0.0550f, 0.0630f, 0.0710f},
                                  {{{0.0650f, 0.0820f, 0.0880f}, 1.0, 0.38},
                                   {{0.1100f, 0.1100f, 0.1300f}, 0.92, 0.17},
                                   {{0.0080f, 0.0130f, 0.0150f}, 0.9, 0.013}}},
                                 {"2k acrylack",
                                  {0.4200f, 0.3200f, 0.1000f},
                                  {{Rgb(0.0f), 1.0, 0.88},
                                   {{0.0280f, 0.0260f, 0.0060f}, 0.9, 0.8},
                                   {{0.0170f, 0.0075f, 0.0041f}, 0.17, 0.015}}},
                                 {"white",
                                  {0.6100f, 0.6300f, 0.5500f},
                                  {{{2.6e-6f, 3.1e-4f, 3.1e-8f}, 0.049, 1.0},
                                   {{0.0130f, 0.0110f, 0.0083f}, 0.45, 0.15},
                                   {{0.0490f, 0.0420f, 0.0370f}, 0.17, 0.015}}},
                                 {"blue matte",
                                  {0.0099f, 0.0360f, 0.1200f},
                                  {{{0.0032f, 0.0045f, 0.0059f}, 1.0, 0.16},
                                   {{0.1800f, 0.2300f, 0.2800f}, 0.046, 0.075},
                                   {{0.0400f, 0.0490f, 0.0510f}, 0.17, 0.034}}}};

double paint_value(const Paint& paint, const Half& h, int channel, double absorption) {
    double sum = colour_of_reflectance(paint.kd)[channel] / kPi * absorption;
    for (const Paint::Lobe& lobe : paint.lobes) {
        sum += std::max(0.0f, colour_of_reflectance(lobe.ks)[channel]) *
               schlick_fresnel(h.u, lobe.r) * Facets{lobe.m, lobe.m}.reflection(h);
    }
    return sum;
}

TEST(CoatFormula, CarPaintByNameAndByParameters) {
    ShadingFixture scene;
    for (const Paint& paint : kPaints) {
        std::vector<ParameterValue> own{color("Kd", paint.kd), color("Ka", Rgb(0.5f)),
                                        number("d", 0.3)};
        for (int i = 0; i < 3; ++i) {
            const std::string n = std::to_string(i + 1);
            own.push_back(color("Ks" + n, paint.lobes[i].ks));
            own.push_back(number("R" + n, paint.lobes[i].r));
            own.push_back(number("M" + n, paint.lobes[i].m));
        }
        const auto named = scene.make_material("carpaint", {text("name", paint.name)});
        const auto written = scene.make_material("carpaint", own);
        for (int channel = 0; channel < 3; ++channel) {
            expect_formula(
                *named, 2e-3,
                [&](const Vec3& wo, const Vec3& wi) {
                    return paint_value(paint, Half(wo, wi), channel, 1);
                },
                channel);
            expect_formula(
                *written, 2e-3,
                [&](const Vec3& wo, const Vec3& wi) {
                    const Half h(wo, wi);
                    return paint_value(paint, h, channel, coat_absorption(h, 0.5, 0.3));
                },
                channel);
            expect_formula(
                *named, 2e-3,
                [&](const Vec3&, const Vec3&) {
                    return colour_of_reflectance(paint.kd)[channel] / kPi;
                },
                channel, kBelow, kBelow);
        }
    }
    EXPECT_TRUE(scene.diagnostics.warnings.empty());
}

}  // namespace
}  // namespace lxs::lux::coat_formula_test
