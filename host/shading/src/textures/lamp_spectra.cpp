// Spectra of lamps: what is known by physics, and stand-ins for the rest.
#include "lamp_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lxs::shading {
namespace {

using Source = LampSource;

constexpr std::string_view kCct = "nominal colour temperature of the kind of lamp";
constexpr std::string_view kFlame = "usual colour temperature of a soot flame";
constexpr std::string_view kLinesOnly =
    "the wavelengths are the element's, as in Sansonetti and Martin 2005, Handbook of Basic Atomic "
    "Spectroscopic Data";

// Names without an entry here are errors that list these.
constexpr std::array kLamps = {
    Lamp{"Alcohol", Source::StandIn, 1900, kFlame},
    Lamp{"AntiInsect", Source::StandIn, 2000, kCct},
    Lamp{"Butane", Source::StandIn, 1900, kFlame},
    Lamp{"CFL27K", Source::StandIn, 2700, kCct},
    Lamp{"CFL4K", Source::StandIn, 4000, kCct},
    Lamp{"CFL6K", Source::StandIn, 6000, kCct},
    Lamp{"Candle", Source::BlackBody, 1850, kFlame},
    Lamp{"CarbonArc", Source::StandIn, 3800, "temperature of the positive crater of a carbon arc"},
    Lamp{"Cd", Source::RoughLines, 0, kLinesOnly},
    Lamp{"Daylight", Source::StandIn, 6504, "correlated colour temperature of CIE D65"},
    Lamp{"FL37K", Source::StandIn, 3700, kCct},
    Lamp{"FLAV17K", Source::StandIn, 17000, kCct},
    Lamp{"FLAV8K", Source::StandIn, 8000, kCct},
    Lamp{"FLD2", Source::StandIn, 6500, kCct},
    Lamp{"GreenLaser", Source::Lines, 0, "frequency-doubled neodymium laser, 532 nm"},
    Lamp{"HPM2", Source::RoughLines, 0, kLinesOnly},
    Lamp{"HPMFL1", Source::StandIn, 4000, kCct},
    Lamp{"HPMFL2", Source::StandIn, 4000, kCct},
    Lamp{"HPS", Source::StandIn, 2100, kCct},
    Lamp{"HPX", Source::StandIn, 6000, kCct},
    Lamp{"Hg", Source::RoughLines, 0, kLinesOnly},
    Lamp{"Incandescent1", Source::BlackBody, 2600, "filament of a 40 W lamp"},
    Lamp{"Incandescent2", Source::BlackBody, 2856, "CIE illuminant A, 100 W lamp"},
    Lamp{"LCDS", Source::StandIn, 6500, kCct},
    Lamp{"LPM2", Source::RoughLines, 0, kLinesOnly},
    Lamp{"LPS", Source::Lines, 0, kLinesOnly},
    Lamp{"MHD", Source::StandIn, 5400, kCct},
    Lamp{"MHN", Source::StandIn, 4200, kCct},
    Lamp{"MHSc", Source::StandIn, 4000, kCct},
    Lamp{"MHWWD", Source::StandIn, 3000, kCct},
    Lamp{"MPS", Source::StandIn, 2000, kCct},
    Lamp{"Na", Source::Lines, 0, kLinesOnly},
    Lamp{"OliveOil", Source::StandIn, 1900, kFlame},
    Lamp{"Paraffin", Source::StandIn, 1900, kFlame},
    Lamp{"RedLaser", Source::Lines, 0, "helium-neon laser, 632.8 nm"},
    Lamp{"SHPS", Source::StandIn, 2500, kCct},
    Lamp{"TV", Source::StandIn, 6500, kCct},
    Lamp{"Welsbach", Source::StandIn, 2400, "usual colour temperature of a gas mantle"},
    Lamp{"Xe", Source::StandIn, 6000, kCct},
    Lamp{"Zn", Source::RoughLines, 0, kLinesOnly},
};

struct Line {
    std::string_view lamp;
    double nm;
    double intensity;  ///< relative within its lamp
};

constexpr std::array kLines = {
    Line{"Cd", 467.8, 200},     Line{"Cd", 480.0, 300},       Line{"Cd", 508.6, 1000},
    Line{"Cd", 643.8, 2000},    Line{"GreenLaser", 532.0, 1}, Line{"Hg", 404.7, 1800},
    Line{"Hg", 435.8, 4000},    Line{"Hg", 546.1, 1100},      Line{"Hg", 577.0, 240},
    Line{"Hg", 579.1, 280},     Line{"Na", 589.0, 2},         Line{"Na", 589.6, 1},
    Line{"RedLaser", 632.8, 1}, Line{"Zn", 468.0, 300},       Line{"Zn", 472.2, 400},
    Line{"Zn", 481.1, 400},     Line{"Zn", 636.2, 1000},
};

/// The element whose lines a lamp has.
std::string_view element(std::string_view lamp) {
    if (lamp == "LPS") return "Na";
    if (lamp == "LPM2" || lamp == "HPM2") return "Hg";
    return lamp;
}

/// Lines as narrow bells, so that sums at steps of a nanometre find them.
double lines_at(std::string_view lamp, double nm) {
    constexpr double kWidthNm = 1.5;
    double sum = 0;
    for (const Line& line : kLines) {
        const double t = (nm - line.nm) / kWidthNm;
        if (line.lamp == lamp) sum += line.intensity * std::exp(-0.5 * t * t);
    }
    return sum;
}

double strongest(std::string_view lamp) {
    double value = 0;
    for (const Line& line : kLines)
        if (line.lamp == lamp) value = std::max(value, lines_at(lamp, line.nm));
    return value;
}

}  // namespace

std::span<const Lamp> lamps() {
    return kLamps;
}

Spectrum lamp_spectrum(const Lamp& lamp) {
    if (lamp.kelvin > 0) return blackbody_spectrum(lamp.kelvin);
    const std::string_view name = element(lamp.name);
    return [name, largest = strongest(name)](double nm) { return lines_at(name, nm) / largest; };
}

}  // namespace lxs::shading
