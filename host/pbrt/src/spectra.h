// Colours of parameters: pbrt's RGB, black bodies, spectra by wavelengths, by name and in files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parameters.h"

namespace lxs {
class StatementExecutor;
}

namespace lxs::pbrt {

/// What a colour is of, which decides what a spectrum of constant 1 looks like.
enum class ColourOf : std::uint8_t {
    Light,    ///< linear RGB; spectra are made luminance 1, as pbrt makes them
    Surface,  ///< linear RGB of a reflectance, transmittance or absorption
};

/// Reads the colours of one scene; remembers files.
class SpectrumReader {
  public:
    explicit SpectrumReader(StatementExecutor& executor) : executor_(executor) {}

    /// The colour of a parameter, `fallback` if it isn't given. Throws InputError for a texture, an
    /// unknown name, a file that can't be read, a negative value.
    Rgb colour(const Parameters& parameters, std::string_view name, ColourOf of,
               const Rgb& fallback) const;
    /// Whether it is given as RGB (v3: color, xyz), whose luminance is part of what it says.
    static bool is_rgb(const Parameters& parameters, std::string_view name);

  private:
    Rgb spectrum_colour(const Parameters& parameters, const ParameterValue& value,
                        ColourOf of) const;

    StatementExecutor& executor_;
};

/// A glass of a name as "glass-BK7": index at the yellow line of helium, and the number of Abbe.
struct Glass {
    double index = 1.5, abbe = 0;  ///< abbe 0: does not disperse
    /// Cauchy's B in square micrometres that has this dispersion between the lines F and C.
    double cauchy_b() const;
    /// The index at infinite wavelength that belongs to it.
    double cauchy_a() const;
};
std::optional<Glass> glass_by_name(std::string_view spectrum);

/// The name of one of our presets of metals for spectra as "metal-Au-eta" or a file "Au.eta.spd".
std::optional<std::string> metal_preset(std::string_view spectrum);

}  // namespace lxs::pbrt
