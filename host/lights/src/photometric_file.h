// Photometric files of luminaires: IESNA LM-63 (1986 to 2002).
#pragma once

#include <string>
#include <vector>

#include "lxs/sdk/diagnostics.h"

namespace lxs {

/// Luminous intensities of a luminaire by direction (type C photometry).
struct PhotometricWeb {
    std::vector<double> vertical_deg;    ///< rising, from the nadir 0 to 180
    std::vector<double> horizontal_deg;  ///< rising, see LM-63 section 5 for the symmetries
    std::vector<double> candela;         ///< by horizontal, then vertical angle; >= 0

    /// Bilinear; zero beyond the vertical angles, mirrored as the last horizontal angle says: 0
    /// axially symmetric, 90 each quadrant, 180 both halves; 90 to 270 about that plane.
    double intensity(double vertical, double horizontal) const;
    double largest() const;
};

/// Reads a file; throws InputError at `where` with the cause. A lamp's dependence on tilt is left
/// out, photometry of types A and B is refused.
PhotometricWeb read_photometric_file(const std::string& path, const SourceLocation& where);

/// The same from the file's text.
PhotometricWeb parse_photometric_text(const std::string& text, const std::string& name,
                                      const SourceLocation& where);

}  // namespace lxs
