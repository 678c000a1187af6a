// Whether an image shows anything, and if not, why.
#pragma once

#include <string>

#include "lxs/host/render_session.h"

namespace lxs {

/// What a user sees in the PNG.
struct ImageVerdict {
    enum class Appearance : std::uint8_t { Varied, Black, White };

    Appearance appearance = Appearance::Varied;
    std::string reason;  ///< the likely one; empty if the image is neither black nor white

    std::string_view name() const;  ///< "black", "white" or "varied"
};

/// Black or white only if every pixel is. Without light in the film, rays tell whether the camera
/// meets a surface, and whether a light reaches what it meets; with some, it is the exposure.
ImageVerdict judge_image(const RenderSession& session);

}  // namespace lxs
