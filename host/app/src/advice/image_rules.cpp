// Advice by what the image shows.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "advice/advice_rules.h"

namespace lxs {
namespace {

constexpr double kBurntShare = 0.5;   ///< of the pixels, beyond which little is seen
constexpr double kBlackShare = 0.98;  ///< likewise
constexpr int kDarkest = 2;           ///< of 255: no screen shows it apart from black

/// Share of the picture's pixels of which every channel is within [least, most].
double share_within(std::span<const std::uint8_t> bytes, int least, int most) {
    std::size_t within = 0;
    for (std::size_t i = 0; i + 2 < bytes.size(); i += 3) {
        within += std::all_of(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                              bytes.begin() + static_cast<std::ptrdiff_t>(i) + 3,
                              [&](int byte) { return byte >= least && byte <= most; });
    }
    const std::size_t pixels = bytes.size() / 3;
    return pixels == 0 ? 0 : static_cast<double>(within) / static_cast<double>(pixels);
}

}  // namespace

AdviceText image_is_burnt_out(const AdviceFacts& facts) {
    const FileFilm& film = *facts.session.film;
    if (facts.image.appearance != ImageVerdict::Appearance::Varied) return {};
    const double white = share_within(facts.picture, 255, 255);
    if (white < kBurntShare) return {};
    return fmt::format(
        "{:.0f} % of the picture is plain white. The EXR has all of it; for the picture lower "
        "--exposure, or change the film's tonemapkernel \"{}\".",
        100 * white, film.tone_map_kernel());
}

AdviceText image_is_nearly_black(const AdviceFacts& facts) {
    if (facts.image.appearance != ImageVerdict::Appearance::Varied) return {};
    const double black = share_within(facts.picture, 0, kDarkest);
    if (black < kBlackShare) return {};
    return fmt::format(
        "{:.0f} % of the picture is black to the eye. Where the EXR has light, raise --exposure; "
        "where it has none, --explain tells which lights reach the image.",
        100 * black);
}

AdviceText everything_is_out_of_view(const AdviceFacts& facts) {
    const Bounds bounds = facts.session.scene->bounds();
    if (!facts.probe.seen().empty() || bounds.isEmpty() || !facts.image.reason.empty()) return {};
    const Vec3 to_scene = bounds.center() - facts.probe.eye();
    const double cosine = to_scene.normalized().dot(facts.probe.view());
    const double degrees = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
    return fmt::format(
        "the camera sees no surface, only what is at infinity: it looks {:.0f} degrees past the "
        "middle of the scene, at a distance of {:.3g}. Change LookAt or the transforms before it.",
        degrees, to_scene.length());
}

}  // namespace lxs
