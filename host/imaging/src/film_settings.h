// What the Film statement asks for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "color_space.h"
#include "lxs/imaging/film_frame.h"
#include "lxs/scene/contents.h"
#include "lxs/sdk/layers.h"
#include "tone_map.h"

namespace lxs {

/// Most sums of a film, 8 bytes each, of either part of what passes bring: 1 + 3 per light group
/// and pixel.
inline constexpr double kMaxFilmValues = 1 << 30;

struct FilmSettings {
    FilmFrame frame;
    std::string base_name = "luxout";
    double halt_time_seconds = 0;
    std::uint64_t halt_passes = 0;
    double halt_error = 0;
    /// Others of its kind that a sample needs to count in full in what is displayed; 0: none.
    std::uint32_t outlier_neighbours = 0;
    double write_interval_seconds = 60;
    double display_interval_seconds = 12;
    ToneMapSettings tone_map;
    /// File of a film's response curves, not read yet; empty for none.
    std::string response_file;
    SourceLocation response_where;
    LayersWanted layers;  ///< with `alpha`, the EXR and the PNG have an alpha channel
    /// The camera does not see lights at infinity, so that colours are those before the background,
    /// multiplied by alpha.
    bool hides_background = false;
    /// From the scene's colours to the film's, if those differ (colorspace_red ...).
    std::optional<ColorConversion> to_film_colors;
};

/// Reads and checks the Film statement; throws InputError, warns of what has no effect.
FilmSettings read_film_settings(const SceneContents& contents, Diagnostics& diagnostics);

/// The frame alone, for whom warnings of the Film statement are not meant.
FilmFrame read_film_frame(const SceneContents& contents);

}  // namespace lxs
