// Every light: its power, its photons, and what shadow rays bring of it.
#include "check_lights.h"

#include <array>
#include <numbers>

#include "direct_light_statistics.h"
#include "light_flux.h"
#include "tolerances.h"

namespace aips {
namespace {

/// Of these, places from which a light is looked at.
constexpr std::size_t kPlacesTried = 64;

/// "0.0796 times (1 / (4 pi))": factors that are easily forgotten have names.
std::string factor(double ratio) {
    constexpr double kDoublePi = std::numbers::pi;
    struct Named {
        double value;
        const char* name;
    };
    constexpr std::array<Named, 6> kNamed{{{4 * kDoublePi, "4 pi"},
                                           {2 * kDoublePi, "2 pi"},
                                           {kDoublePi, "pi"},
                                           {kDoublePi * kDoublePi, "pi^2"},
                                           {2, "2"},
                                           {4, "4"}}};
    for (const auto& [value, name] : kNamed) {
        if (std::abs(ratio / value - 1) < 0.08) return figure(ratio) + " times (" + name + ")";
        if (std::abs(ratio * value - 1) < 0.08) {
            return figure(ratio) + " times (1 / (" + name + "))";
        }
    }
    return figure(ratio) + " times";
}

class LightCheck {
  public:
    LightCheck(const Scene& scene, LightIndex number, HostFindings& findings)
        : scene_(scene),
          light_(*scene.lights()[number]),
          subject_(light_subject(scene, number)),
          findings_(findings) {}

    void report(const LightFlux& flux, const DirectLightStatistics& direct) {
        if (light_.group() >= scene_.light_groups()) {
            add("group", std::to_string(light_.group()),
                "below light_groups(), " + std::to_string(scene_.light_groups()));
        }
        if (any(flux.values, 0, "values", "finite values, none negative; unit directions") ||
            any(direct.values, 0, "values", "finite values, none negative; unit directions")) {
            return;
        }
        const bool doubtful = report_direct(direct);
        const bool emission = report_emission(flux, doubtful);
        report_power(flux, emission);
        if (!emission) {
            any(direct.coordinates, 2 * kRareAtLight, "emission_coordinates",
                "coordinates of a photon through the point");
        }
    }

  private:
    void add(const char* check, std::string found, std::string expected, double chance = 0) {
        findings_.add({subject_, check, std::move(found), std::move(expected), chance});
    }
    bool any(const CheckStatistics& statistics, double share, const char* check,
             const char* expected) {
        return findings_.add_if_over(statistics, share, subject_, check, expected);
    }

    /// Whether what sample_direct() brings is in doubt.
    bool report_direct(const DirectLightStatistics& direct) {
        any(direct.blocked, kRareAtLight, "visibility", "none through what lets nothing pass");
        any(direct.open, kRareAtLight, "visibility", "light, where nothing stops it");
        any(direct.shares, kRareAtLight, "visibility",
            "the share that surfaces and media let pass");
        any(direct.deltas, 0, "is_delta",
            light_.is_delta() ? "delta samples alone, as is_delta() says"
                              : "no delta sample, as is_delta() says");
        any(direct.behind, kRareAtLight, "missing directions",
            "samples wherever the light is seen from");
        const bool missed =
            any(direct.missed, kRareAtLight, "light point", "the light's surface there");
        const bool radiance =
            any(direct.radiances, kRareAtLight, "radiance", "the radiance that rays see there");
        const bool pdf = any(direct.pdfs, kRareAtLight, "pdf_direct", "the same density from both");
        const bool density =
            !missed && !pdf && differ(direct.by_samples, direct.by_density, 0.01, 1);
        if (density) {
            add("density of directions",
                "samples that bring " + figure(direct.by_samples.mean()) +
                    " where pdf_direct() tells " + figure(direct.by_density.mean()),
                "directions drawn as densely as pdf_direct() says", kChanceOfFinding);
        } else if (!pdf) {
            any(direct.unasked, kRareAtLight, "missing directions",
                "samples wherever the light is seen from");
        }
        return radiance || (density && !light_.at_infinity());
    }

    /// Whether photons are no measure of the light.
    bool report_emission(const LightFlux& flux, bool doubtful) {
        const Estimate &photons = flux.by_photons[0], &points = flux.by_points[0];
        const double total = std::max(photons.mean(), points.mean());
        const bool differs = differ(photons, points, kFluxTolerance * total);
        if (differs && doubtful) return true;
        const double ratio = points.mean() > 0 ? photons.mean() / points.mean() : 0;
        if (report_octants(flux, differs ? ratio : 1, kFluxTolerance * total)) return true;
        if (!differs) return false;
        add("emission",
            figure(photons.mean()) + " W by emit(), " + factor(ratio) + " what " +
                (light_.at_infinity() ? "escaped()" : "sample_direct()") + " sends",
            figure(points.mean()) + " W", kChanceOfFinding);
        return true;
    }

    /// Whether photons go where radiance does not, apart from an overall factor.
    bool report_octants(const LightFlux& flux, double ratio, double tolerance) {
        for (std::size_t i = 1; i < flux.by_photons.size(); ++i) {
            const Estimate &out = flux.by_photons[i], &in = flux.by_points[i];
            const double difference = std::abs(out.mean() - ratio * in.mean());
            if (difference < tolerance || difference < out.error() + ratio * in.error()) continue;
            add("directions of emission",
                figure(out.mean()) + " W by emit() in an octant, " + figure(in.mean()) +
                    " W by radiance",
                "photons where radiance goes", kChanceOfFinding);
            return true;
        }
        return false;
    }

    /// power() against what photons bring; if those are wrong themselves, one finding is enough.
    void report_power(const LightFlux& flux, bool emission_reported) {
        const double power = light_.power(), emitted = flux.emitted.mean();
        const double error = flux.emitted.error();
        if (!(power >= 0) || !std::isfinite(power)) {
            add("power", figure(power), "a finite number, not negative");
        } else if (power == 0 && emitted > error) {
            add("power", "0 of a light whose photons bring " + figure(emitted) + " W",
                "0 for dead lights only", kChanceOfFinding);
        } else if (!emission_reported && (power > kPowerTolerance * (emitted + error) ||
                                          power * kPowerTolerance < emitted - error)) {
            add("power",
                figure(power) + " W, " + (emitted > 0 ? factor(power / emitted) + " " : "") +
                    "what photons bring",
                "about " + figure(emitted) + " W", kChanceOfFinding);
        }
    }

    const Scene& scene_;
    const Light& light_;
    std::string subject_;
    HostFindings& findings_;
};

}  // namespace

void check_lights(const Scene& scene, const HostValidationSettings& settings,
                  const MetSurfaces& surfaces, HostFindings& findings) {
    const std::size_t count = scene.lights().size();
    if (count == 0) return;
    const std::size_t step = 1 + (count - 1) / std::max(1u, settings.most_lights);
    for (std::size_t i = 0; i < count; i += step) {
        RandomStream random = check_stream(settings, CheckStream::Lights, i);
        const auto number = LightIndex(i);
        // Rare photons count: twice as many samples as elsewhere, at all places together.
        const LightFlux flux =
            measure_flux(scene, *scene.lights()[i], 2 * settings.samples * settings.places, random);
        DirectLightStatistics direct;
        const std::size_t tried = std::min(kPlacesTried, surfaces.anywhere().size());
        for (std::size_t k = 0; k < tried; ++k) {
            const auto at = std::size_t(random.next() * float(surfaces.anywhere().size()));
            ask_direct_light(scene, number, surfaces.anywhere()[at], settings.samples,
                             settings.places, random, direct);
        }
        look_from_behind(scene, number, settings.time, random, direct.behind);
        LightCheck(scene, number, findings).report(flux, direct);
    }
}

}  // namespace aips
