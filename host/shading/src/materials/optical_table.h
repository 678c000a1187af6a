// Measured optical constants: tables of wavelength, n and k, and files of them.
#pragma once

#include <string>
#include <vector>

#include "lxs/scene/texture.h"
#include "lxs/sdk/diagnostics.h"

namespace lxs::shading {

struct OpticalConstants {
    double wavelength = 0;  ///< nanometres
    double n = 1, k = 0;
};

/// By ascending wavelength, at least one entry.
using OpticalTable = std::vector<OpticalConstants>;

/// Formats of files: Sopra's (evenly spaced in energy or wavelength, a header of four numbers),
/// LuxPop's (Angstroms, n, k), or whichever of the two it looks like. Other tables of three columns
/// are read as LuxPop's with the unit that puts them into visible light: Angstroms above 2000,
/// nanometres above 20, else micrometres.
enum class OpticalFormat : std::uint8_t { Any, Sopra, LuxPop };

/// Reads the file `path`; throws InputError at `where` if it can't be read or isn't of the format.
OpticalTable read_optical_table(const std::string& path, OpticalFormat format,
                                const SourceLocation& where);

/// Linear interpolation; the ends hold beyond the table.
OpticalConstants constants_at(const OpticalTable& table, double wavelength);

/// The constants at the three wavelengths that stand for red, green and blue.
FresnelValue rgb_constants(const OpticalTable& table);

}  // namespace lxs::shading
