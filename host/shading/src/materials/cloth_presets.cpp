// Kinds of cloth by LuxRender's names. Their weaves are those that textbooks of weaving give for
// cloth of these names. What Irawan measured of the fibres and yarns of six fabrics (Appearance of
// Woven Cloth, thesis, Cornell University 2008) could not be had from there; the figures below are
// choices of ours, and a warning says so:
// - spun cotton and wool: staple fibres, twisted, rough, of which much light comes out again
// - silk and polyester: filaments, hardly twisted, smooth; charmeuse has a crepe weft, shantung a
//   weft of uneven thickness
#include "cloth_presets.h"

#include <fmt/format.h>

#include <array>
#include <string>

#include "unknown_preset.h"

namespace lxs::shading {
namespace {

constexpr Yarn kCotton{0.25f, 0.7f, 25, 14, 0.3f};
constexpr Yarn kWorsted{0.25f, 0.7f, 35, 18, 0.4f};
constexpr Yarn kPolyester{0.15f, 0.5f, 0, 7, 0.2f};
constexpr Yarn kSilk{0.15f, 0.5f, 0, 8, 0.3f};
constexpr Yarn kCrepeSilk{0.2f, 0.7f, 30, 12, 0.3f};
constexpr Yarn kWildSilk{0.1f, 0.7f, 10, 12, 0.3f};

constexpr Weave kPlain{2, 1, 1}, kSlubbed{2, 1, 1, 1.6f};
constexpr Weave kTwill21{3, 2, 1}, kTwill22{4, 2, 1}, kTwill31{4, 3, 1}, kSatin5{5, 4, 2};

constexpr std::array<ClothPreset, 6> kPresets{
    {{"denim", "3/1 twill", kTwill31, kCotton, kCotton},
     {"silk_charmeuse", "five-end satin", kSatin5, kSilk, kCrepeSilk},
     {"cotton_twill", "2/2 twill", kTwill22, kCotton, kCotton},
     {"wool_gabardine", "2/1 twill", kTwill21, kWorsted, kWorsted},
     {"polyester_lining_cloth", "plain weave", kPlain, kPolyester, kPolyester},
     {"silk_shantung", "plain weave with a thick weft", kSlubbed, kSilk, kWildSilk}}};

/// What old exporters write.
constexpr std::string_view kMisspelt = "wool_garbardine", kMeant = "wool_gabardine";

}  // namespace

const ClothPreset& read_cloth_preset(const ParameterReader& reader) {
    const std::string name = reader.string("presetname", kPresets[0].name);
    for (const ClothPreset& preset : kPresets) {
        if (preset.name != (name == kMisspelt ? kMeant : name)) continue;
        reader.diagnostics().warning(
            reader.where("presetname"),
            fmt::format("the measured constants of the fibres of cloth \"{}\" are not available; "
                        "its weave, a {}, has fibres of our choice",
                        preset.name, preset.weave_name));
        return preset;
    }
    warn_of_unknown_preset(reader, "presetname", "cloth", kPresets, kPresets[0].name);
    return kPresets[0];
}

}  // namespace lxs::shading
