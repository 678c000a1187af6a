// From spectra to linear RGB: the standard observer and the primaries of Rec. 709.
#pragma once

#include "lxs/sdk/types.h"

namespace lxs {

inline constexpr double kFirstVisibleNm = 360, kLastVisibleNm = 830;

/// CIE 1931 colour matching functions x, y, z at `nm` nanometres: the CIE's table at steps of 5 nm
/// (CIE 15:2004), linear in between, 0 outside of 380 to 780 nm.
Imath::V3d colour_matching(double nm);

/// Linear RGB (Rec. 709 primaries, white D65) of the tristimulus values `xyz`.
Imath::V3d rgb_of_xyz(const Imath::V3d& xyz);

/// The same with negative components set to zero.
Rgb clipped_rgb_of_xyz(const Imath::V3d& xyz);

/// What light of `nm` nanometres adds to R, G and B, per nanometre, scaled such that each channel
/// sums to 1 over the visible range: a flat spectrum of 1 is the colour (1, 1, 1), as scenes write
/// it. Single values may be negative: pure colours lie outside of the primaries' gamut.
Imath::V3d rgb_response(double nm);

}  // namespace lxs
