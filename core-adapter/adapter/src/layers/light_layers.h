// Debug views of which light shadow rays ask, at the surfaces that the pixels show.
#pragma once

#include <cstddef>
#include <vector>

#include "aips/adapter/camera.h"
#include "eye/direct_light.h"
#include "eye/eye_pass.h"

namespace aips {

/// Layers lightchoice and lightshare of docs/reference/layers.md. They only read, and are of the
/// pass that was shown last alone: nothing of them need be saved.
class LightLayers {
  public:
    /// The film outlives the layers.
    explicit LightLayers(Film& film);

    /// Replaces the layers by what the choices are at the visible points of a pass.
    void show(const EyeImage& image, const DirectLight& lights);

    std::size_t memory_bytes() const;
    static std::size_t memory_bound_bytes(std::size_t pixels);

  private:
    Film& film_;
    std::vector<float> lights_;  // [pixel]: number of the likeliest light, from 1; 0: no point
    std::vector<float> shares_;  // [pixel]: its probability
};

}  // namespace aips
