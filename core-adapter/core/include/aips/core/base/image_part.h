// Parts that an image is the sum of, by where light has been scattered.
#pragma once

#include <cstdint>

namespace aips {

/// By the scatterings of a light path that are diffuse, glossy or in a medium; what passes straight
/// is none.
enum class ImagePart : std::uint8_t {
    Direct,    ///< none, or one that light has reached straight from a lamp
    Caustics,  ///< one that light has reached from a lamp by way of smooth surfaces
    Indirect,  ///< two or more
};

inline constexpr std::uint32_t kImageParts = 3;
/// Of photons, direct light and caustics are summed apart: the rest is indirect.
inline constexpr std::uint32_t kPhotonParts = 2;

/// What one more scattering makes of light that would be `part` if it were seen by way of one
/// surface.
constexpr ImagePart scattered_on(ImagePart part, bool smooth) {
    return smooth && part != ImagePart::Indirect ? ImagePart::Caustics : ImagePart::Indirect;
}

/// How an eye path has been scattered so far.
struct EyeScatterings {
    std::uint8_t rough = 0;  ///< scatterings that are not smooth; 2 stands for more
    bool smooth = false;     ///< some smooth one after the last of these

    void add(bool is_smooth) {
        if (!is_smooth && rough < 2) ++rough;
        smooth = is_smooth;
    }
    /// Part of light that the path meets, or of light that is scattered into it at a surface or in
    /// a medium, which `part` is of alone.
    ImagePart met() const {
        if (rough == 0) return ImagePart::Direct;
        if (rough > 1) return ImagePart::Indirect;
        return smooth ? ImagePart::Caustics : ImagePart::Direct;
    }
    ImagePart scattered_in(ImagePart part = ImagePart::Direct) const {
        return rough == 0 ? part : ImagePart::Indirect;
    }
};

}  // namespace aips
