// Parts that an image is the sum of, by where light has been scattered.
#pragma once

#include <cstdint>

namespace aips {

/// By the scatterings of a light path that are diffuse, glossy or in a medium; what passes straight
/// is none.
enum class ImagePart : std::uint8_t {
    Direct,    ///< none, or one that light has reached straight from an emitter
    Caustics,  ///< one that light has reached from an emitter by way of specular surfaces
    Indirect,  ///< two or more
};

inline constexpr std::uint32_t kImageParts = 3;
/// Of photons, direct light and caustics are summed apart: the rest is indirect.
inline constexpr std::uint32_t kPhotonParts = 2;

/// What one more scattering makes of light that would be `part` if it were seen by way of one
/// surface.
constexpr ImagePart scattered_on(ImagePart part, bool specular) {
    return specular && part != ImagePart::Indirect ? ImagePart::Caustics : ImagePart::Indirect;
}

/// How an eye path has been scattered so far.
struct EyeScatterings {
    std::uint8_t rough = 0;  ///< scatterings that are not specular; 2 stands for more
    bool specular = false;   ///< some specular one after the last of these

    void add(bool is_specular) {
        if (!is_specular && rough < 2) ++rough;
        specular = is_specular;
    }
    /// Part of light that the path meets, or of light that is scattered into it at a surface or in
    /// a medium, which `part` is of alone.
    ImagePart met() const {
        if (rough == 0) return ImagePart::Direct;
        if (rough > 1) return ImagePart::Indirect;
        return specular ? ImagePart::Caustics : ImagePart::Direct;
    }
    ImagePart scattered_in(ImagePart part = ImagePart::Direct) const {
        return rough == 0 ? part : ImagePart::Indirect;
    }
};

}  // namespace aips
