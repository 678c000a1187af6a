// The layers that a film keeps beside its image because a user asked for them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "film_accumulator.h"
#include "id_mattes.h"
#include "lxs/imaging/file_layers.h"
#include "lxs/sdk/invalid_samples.h"
#include "lxs/sdk/layers.h"
#include "lxs/spectrum/wavelengths.h"

namespace lxs {

/// Depth of pixels in which no sample met a surface: what Blender writes there.
inline constexpr float kDepthOfNothing = 1e10f;

class FilmLayers {
  public:
    FilmLayers(const LayersWanted& wanted, std::uint32_t width, std::uint32_t height,
               const PixelFilter& filter);

    const LayersWanted& wanted() const { return wanted_; }
    /// Names in a file of the layers wanted.
    static std::vector<std::string> names(const LayersWanted& wanted);

    /// As the film's.
    void add_parts(const PassSamples& parts) {
        if (parts_) parts_->add(parts);
    }
    void add_splats_of_parts(const PassSplats& parts) {
        if (parts_) parts_->add_splats(parts);
    }
    void add_surfaces(std::span<const Vec2> positions, std::span<const SeenSurface> surfaces);
    void clear();
    /// As FileFilm::set_wavelengths.
    void set_wavelengths(const Wavelengths& wavelengths);

    /// As FileFilm::set_names.
    void set_names(std::span<const std::string> objects, std::span<const std::string> materials);

    /// Adds the layers to those of a file, which begin with the image.
    /// `to_film` takes colours of the scene to those of the film.
    void append_to(FileLayers& layers, const std::function<void(std::span<Rgb>)>& to_film) const;

    /// Means of what is wanted: of reflectance, and of (1 + n) / 2; nullptr if it isn't wanted.
    const FilmAccumulator* albedo() const { return albedo_ ? &*albedo_ : nullptr; }
    const FilmAccumulator* normal() const { return normal_ ? &*normal_ : nullptr; }
    /// [pixel]; empty if it isn't wanted.
    std::span<const float> depth() const { return depth_; }
    /// [pixel]: the part that surfaces cover, 1 everywhere if nobody has told of surfaces; empty if
    /// it isn't wanted.
    std::vector<float> alpha() const;

    void state(StateArchive& archive);
    InvalidSampleList invalid_samples() const;
    std::size_t memory_bytes() const;

  private:
    void append_parts(std::vector<ColorLayer>& colors,
                      const std::function<void(std::span<Rgb>)>& to_film) const;
    void add_mattes(std::span<const Vec2> positions, std::span<const SeenSurface> surfaces);
    void add_depths(std::span<const Vec2> positions, std::span<const SeenSurface> surfaces);
    std::vector<Rgb> mean_normals() const;
    std::size_t pixels() const { return std::size_t{width_} * height_; }

    LayersWanted wanted_;
    std::uint32_t width_, height_;
    std::optional<FilmAccumulator> parts_;  ///< with an ImagePart for a light group
    std::optional<FilmAccumulator> albedo_;
    std::optional<FilmAccumulator> normal_;  ///< of (1 + n) / 2, which is never negative
    std::optional<FilmAccumulator> alpha_;   ///< of 1 where there is a surface
    bool told_of_surfaces_ = false;
    /// Masks of objects or of materials.
    struct Mattes {
        IdMattes mattes;
        std::vector<std::string> names;
    };
    std::optional<SampleCells> cells_;  ///< for these
    std::optional<Mattes> objects_, materials_;
    std::vector<float> depth_;  ///< [pixel]: the least so far; empty if not wanted
    std::uint64_t refused_depths_ = 0;
    std::vector<Rgb> values_;  ///< of the pass that is added, kept between passes
};

}  // namespace lxs
