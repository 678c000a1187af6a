// The known images of emitters that specular surfaces make, as a density that paths are drawn from
// beside the eye's own.
//
// Paths of both kinds are weighed by the balance heuristic at their own coordinates (Veach 1997,
// chapter 9): film position, and choices at specular surfaces. No density of directions is needed,
// as both kinds meet the same emitters at the same coordinates. Images are found by searches of
// their own (emitter_paths/emitter_search.h): eye paths are stratified over passes, and would keep
// away from places that they had told of.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aips/core/base/state_archive.h"
#include "aips/core/tables/discrete_distribution.h"
#include "emitter_images/emitter_image.h"

namespace aips {

/// Most images that are known, some 3 MB, and most entries of them in the lists of pixels.
inline constexpr std::size_t kMostImages = 1u << 15;
inline constexpr std::size_t kMostEntries = 8 * kMostImages;

/// Coordinates of a path through the image of an emitter.
struct EmitterDraw {
    Vec2 film;  ///< pixels; may lie outside of the film, where it shows nothing
    SpecularChoices choices{};
};

/// Const while a pass is traced, when many threads may ask.
class EmitterImages {
  public:
    /// Of a film of so many pixels, with so many eye paths a pixel and pass.
    EmitterImages(std::uint32_t width, std::uint32_t height, double eye_paths_per_pixel);

    /// Whether an image of this shape and place is one that paths of its own pay for.
    bool suits(const EmitterImage& image) const;
    /// Keeps those among `found` that are new, suitable and within what memory holds.
    void add(std::span<const EmitterImage> found);
    /// Before each pass: how many paths are drawn, and through which images. The image's mean
    /// luminance: 0 if it is not known.
    void begin_pass(double mean_luminance);

    /// Emitter paths of the pass.
    std::uint32_t paths() const { return paths_; }
    /// Path number `i` of pass `pass`.
    EmitterDraw draw(std::uint64_t seed, std::uint64_t pass, std::uint32_t i) const;
    /// What the light of eye paths counts that meet emitters at these coordinates, in (0, 1]; that
    /// of emitter paths counts the same for each eye path that a pixel has.
    double eye_share(Vec2 film, const SpecularChoices& choices) const;

    /// Those that are known.
    std::span<const EmitterImage> all() const { return images_; }
    /// Between passes: saves all, or restores it.
    void state(StateArchive& archive);
    std::size_t memory_bytes() const;
    static std::size_t memory_bound_bytes(std::size_t pixels);
    /// Most emitter paths of a pass.
    static std::size_t most_paths(std::size_t eye_paths);

  private:
    bool known(const EmitterImage& image) const;
    void file(std::uint32_t image);
    double set_choice(double mean_luminance);
    static double part_of_pixel(const EmitterImage& image, double mean_luminance);
    template <class Use>
    void for_each_pixel(const EmitterImage& image, const Use& use) const;
    std::size_t pixel_count() const { return std::size_t{width_} * height_; }

    std::uint32_t width_, height_;
    double per_pixel_;  // eye paths of a pass
    std::vector<EmitterImage> images_;
    // Lists of the images that a pixel has a part in: [pixel] the first entry, and entries.
    struct Entry {
        std::uint32_t image = 0, next = 0;
    };
    std::vector<std::uint32_t> first_;
    std::vector<Entry> entries_;
    DiscreteDistribution choice_;  // of an image
    std::uint32_t paths_ = 0;
};

}  // namespace aips
