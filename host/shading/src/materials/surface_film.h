// The thin film of mirrors, glass and polished metal: parameters.
#pragma once

#include "bsdfs/thin_film.h"
#include "prepared_texture.h"

namespace lxs::shading {

class SurfaceFilm {
  public:
    /// Reads "film" and "filmindex".
    SurfaceFilm(const ParameterReader& reader, const AssetContext& assets)
        : thickness_(read_limited(reader, assets, "film", 0, 0, 1e6f)),
          index_(read_limited(reader, assets, "filmindex", 1.5f, 1, 20)) {}

    ThinFilm at(const TexturePoint& point) const {
        return {thickness_.at(point), index_.at(point), point.wavelengths};
    }
    bool reads_image() const { return thickness_.reads_image() || index_.reads_image(); }
    bool varies() const { return thickness_.varies() || index_.varies(); }

  private:
    PreparedFloat thickness_, index_;
};

/// Declarations of what SurfaceFilm reads.
inline std::vector<ParameterDeclaration> film_parameters() {
    return {{"film", ParameterType::FloatTexture, "0",
             "thickness of a thin film that colours reflections, nanometres", 0},
            {"filmindex", ParameterType::FloatTexture, "1.5", "index of the thin film", 0}};
}

}  // namespace lxs::shading
