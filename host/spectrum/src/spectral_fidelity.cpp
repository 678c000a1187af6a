// How well colours stand for spectra: what decides whether a scene is rendered by wavelengths.
#include "lxs/spectrum/spectral_fidelity.h"

#include <algorithm>
#include <cmath>

#include "lxs/spectrum/daylight.h"

namespace lxs {
namespace {

SpectralTable tabulated(const Spectrum& spectrum) {
    SpectralTable table;
    for (std::size_t i = 0; i < kVisibleSteps; ++i)
        table[i] = spectrum(nm_of_step(i));
    return table;
}

SpectralTable spectrum_of(const Rgb& colour) {
    const Imath::V3d rgb(colour);
    return tabulated([&](double nm) { return primary_spectra(nm) ^ rgb; });
}

Spectrum function(const SpectralCurve& curve) {
    return [&curve](double nm) { return curve.at(nm); };
}

const std::vector<Imath::V3d>& responses() {
    static const std::vector<Imath::V3d> table = [] {
        std::vector<Imath::V3d> values;
        for (std::size_t i = 0; i < kVisibleSteps; ++i)
            values.push_back(daylight_response(nm_of_step(i)));
        return values;
    }();
    return table;
}

Imath::V3d colour_of_product(const SpectralTable& lamp, const SpectralTable& surface) {
    Imath::V3d sum(0.0);
    for (std::size_t i = 0; i < kVisibleSteps; ++i)
        sum += responses()[i] * (lamp[i] * surface[i]);
    return sum;
}

double greatest(const Imath::V3d& c) {
    return std::max({c.x, c.y, c.z});
}

double difference(const RepresentedSpectrum& lamp, const RepresentedSpectrum& surface) {
    const Imath::V3d exact = colour_of_product(lamp.exact, surface.exact);
    const Imath::V3d in_rgb = colour_of_product(lamp.by_colour, surface.by_colour);
    const double scale = std::max(greatest(exact), greatest(in_rgb));
    const Imath::V3d d = exact - in_rgb;
    return scale > 0 ? greatest({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) / scale : 0;
}

RepresentedSpectrum plain(const Rgb& colour, const char* name) {
    const SpectralTable table = spectrum_of(colour);
    return {table, table, name};
}

}  // namespace

RepresentedSpectrum represented_lamp(const SpectralCurve& lamp) {
    const SpectralCurve relative = relative_to_daylight(lamp);
    const SpectralTable exact = tabulated(function(relative));
    const Imath::V3d seen = colour_of_product(exact, tabulated([](double) { return 1.0; }));
    const Rgb colour =
        Rgb(Imath::V3d(std::max(seen.x, 0.0), std::max(seen.y, 0.0), std::max(seen.z, 0.0)));
    const float brightness = luminance(colour);
    return {exact, spectrum_of(brightness > 0 ? colour / brightness : Rgb(0.0f)), lamp.name()};
}

RepresentedSpectrum represented_surface(const SpectralCurve& reflectance) {
    return {tabulated(function(reflectance)), spectrum_of(colour_of_surface(function(reflectance))),
            "a surface of " + reflectance.name()};
}

RepresentedSpectrum represented_medium(const SpectralCurve& coefficient) {
    RepresentedSpectrum medium = represented_surface(coefficient);
    medium.name = "a medium of " + coefficient.name();
    const Rgb colour = colour_of_surface(function(coefficient));
    const double mean = (double{colour.x} + colour.y + colour.z) / 3;
    for (SpectralTable* table : {&medium.exact, &medium.by_colour}) {
        for (double& value : *table)
            value = mean > 0 ? std::exp(-value / mean) : 1;
    }
    return medium;
}

RepresentedSpectrum white_lamp() {
    return plain(Rgb(1.0f), "white light");
}

std::vector<RepresentedSpectrum> plain_surfaces() {
    return {plain(Rgb(1.0f), "a white surface"), plain(Rgb(0.8f, 0.2f, 0.2f), "a red surface"),
            plain(Rgb(0.2f, 0.8f, 0.2f), "a green surface"),
            plain(Rgb(0.2f, 0.2f, 0.8f), "a blue surface")};
}

Misrepresentation worst_pair(std::span<const RepresentedSpectrum> lamps,
                             std::span<const RepresentedSpectrum> surfaces) {
    Misrepresentation worst;
    for (const RepresentedSpectrum& lamp : lamps) {
        for (const RepresentedSpectrum& surface : surfaces) {
            const double found = difference(lamp, surface);
            if (!worst.pair.empty() && !(found > worst.difference)) continue;
            worst = {found, lamp.name + " on " + surface.name};
        }
    }
    return worst;
}

}  // namespace lxs
