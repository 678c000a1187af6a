// From linear radiance to 8-bit display values.
// Sources: Reinhard et al. 2002 (photographic tone reproduction); Ward 1994 (contrast-based scale).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "camera_response.h"
#include "lxs/sdk/types.h"

namespace lxs {

/// LuxRender's tone mapping parameters, with its defaults and with what it makes of them.
struct ToneMapSettings {
    enum class Kernel : std::uint8_t {
        AutoLinear,
        Linear,
        Reinhard,
        Contrast,
        MaxWhite,
        NonLinear
    };
    /// What becomes of colours that are brighter than the display in some channel.
    enum class Clamp : std::uint8_t {
        Luminance,  ///< moved towards the grey of their luminance until they fit
        Hue,        ///< moved towards a grey of 1/3
        Darken,     ///< scaled down as a whole
        Cut         ///< each channel on its own
    };

    Kernel kernel = Kernel::AutoLinear;
    Clamp clamp = Clamp::Cut;
    Imath::V3d luminance_weights{0.2126, 0.7152, 0.0722};  ///< of the image's R, G and B
    double gamma = 2.2;              ///< of the display: a value is encoded as value^(1 / gamma)
    double linear_sensitivity = 50;  ///< ISO speed
    double linear_exposure = 1;      ///< seconds
    double linear_fstop = 2.8;
    double linear_gamma = 1;
    double reinhard_prescale = 1, reinhard_postscale = 1;
    double reinhard_burn = 6;   ///< luminance, in units of the mapped key, that becomes white
    double contrast_ywa = 1;    ///< luminance that the display's viewer is adapted to, cd m^-2
    double exposure_stops = 0;  ///< what the kernel gives is multiplied by 2 to this power
    std::shared_ptr<const CameraResponse> response = nullptr;  ///< after the kernel; null: none
};

/// As the Film statement names it.
std::string_view name(ToneMapSettings::Kernel kernel);

/// Interleaved RGB bytes of `image`, which must be finite and not negative.
std::vector<std::uint8_t> tone_map(std::span<const Rgb> image, const ToneMapSettings& settings);

}  // namespace lxs
