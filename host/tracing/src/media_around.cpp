// Lines from a place, and their votes.
#include "media_around.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <vector>

#include "lxs/sdk/rays.h"
#include "lxs/sdk/warp.h"

namespace lxs {
namespace {

constexpr int kLines = 32;
constexpr int kMostSurfaces = 64;  ///< on one line
/// Open water is a plane, that the lines from a lamp below it meet upwards alone.
constexpr std::size_t kDecides = 4;  ///< one in so many lines

/// What a line from a place told.
struct Line {
    std::vector<MediumNumber> media;  ///< around the place, the innermost first
    bool ends = false;                ///< there are no more: it left the scene

    bool tells(std::size_t depth) const { return media.size() > depth || ends; }
};

/// Of the media that the line leaves, those that it has not entered are around its start. What is
/// opaque ends it, unless `through_all`.
Line follow(const MeetSurface& meet, const Vec3& from, const Vec3& direction, bool through_all) {
    Line line;
    std::vector<MediumNumber> entered;
    Ray ray = ray_from_medium(from, direction, 0, {});
    for (int i = 0; i < kMostSurfaces; ++i) {
        SurfaceHit hit;
        const Surface* const surface = meet(ray, hit);
        if (!surface) {
            line.ends = true;
            break;
        }
        // A lamp is asked what it stands in, not what its own shape says.
        if (surface->emissive_index != Surface::kNotEmissive) {
            ray = spawn_ray(hit, direction, 0);
            continue;
        }
        const bool behind = direction.dot(hit.ng) > 0;
        const MediumNumber near = behind ? surface->interior : surface->exterior;
        const MediumNumber far = behind ? surface->exterior : surface->interior;
        if (near != far) {
            const auto own = std::find(entered.rbegin(), entered.rend(), near);
            if (own != entered.rend()) {
                entered.erase(std::next(own).base());
            } else if (near != kNoMedium) {
                line.media.push_back(near);
            }
            if (far != kNoMedium) entered.push_back(far);
        } else if (near != kNoMedium && entered.empty() && line.media.empty()) {
            line.media.push_back(near);
            break;  // what bounds it is not known
        }
        if (!surface->transmits && !through_all) break;
        ray = spawn_ray(hit, direction, 0);
    }
    return line;
}

/// What most of the lines say of the medium at `depth`; nothing if they end there.
std::optional<MediumNumber> vote(const std::vector<Line>& lines, std::size_t depth) {
    std::map<MediumNumber, std::size_t> votes;
    std::size_t all = 0;
    for (const Line& line : lines) {
        all += line.tells(depth);
        if (line.media.size() > depth) ++votes[line.media[depth]];
    }
    const auto most =
        std::max_element(votes.begin(), votes.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == votes.end() || kDecides * most->second < all) return {};
    return most->first;
}

void keep(std::vector<Line>& lines, std::size_t depth, MediumNumber medium) {
    std::erase_if(lines, [=](const Line& line) {
        return line.media.size() <= depth || line.media[depth] != medium;
    });
}

std::vector<Line> lines_from(const MeetSurface& meet, std::span<const Vec3> places,
                             bool through_all) {
    std::vector<Line> lines;
    for (int i = 0; i < kLines; ++i) {
        const Vec3& from = places[static_cast<std::size_t>(i) % places.size()];
        lines.push_back(follow(meet, from, direction_on_sphere(i, kLines), through_all));
    }
    return lines;
}

}  // namespace

MediumNumber medium_along(const MeetSurface& meet, const Vec3& place, const Vec3& direction,
                          MediumNumber outside) {
    const Line line = follow(meet, place, direction, true);
    return line.media.empty() ? outside : line.media.front();
}

EnteredMedia media_around(const MeetSurface& meet, std::span<const Vec3> places,
                          const EnteredMedia& outside, MediumNumber declared) {
    if (places.empty()) return outside;
    std::vector<Line> lines = lines_from(meet, places, false);
    if (std::none_of(lines.begin(), lines.end(), [](const Line& line) { return line.tells(0); }))
        lines = lines_from(meet, places, true);
    const auto says_so = [=](const Line& line) {
        return !line.media.empty() && line.media.front() == declared;
    };
    if (declared != kNoMedium && std::any_of(lines.begin(), lines.end(), says_so))
        keep(lines, 0, declared);
    std::vector<MediumNumber> media;
    while (const auto medium = vote(lines, media.size())) {
        keep(lines, media.size(), *medium);
        media.push_back(*medium);
    }
    EnteredMedia around = outside;
    for (auto medium = media.rbegin(); medium != media.rend(); ++medium)
        around = around.entered(*medium);
    return around;
}

}  // namespace lxs
