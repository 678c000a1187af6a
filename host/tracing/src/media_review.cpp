// Rays on random walks, and what they tell of the surfaces that bound media.
#include "media_review.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "lxs/sdk/frame.h"
#include "lxs/sdk/medium.h"
#include "lxs/sdk/rays.h"
#include "lxs/sdk/warp.h"

namespace lxs {
namespace {

constexpr int kWalks = 64;          ///< from each start
constexpr int kWalkSurfaces = 12;   ///< on each walk
constexpr float kPassShare = 0.6f;  ///< of rays that come to what lets light through
/// Fewer of a surface's rays than one in so many are those that slip through edges.
constexpr int kTells = 4;
constexpr int kTellsOfNone = 2;  ///< likewise of rays that have entered no medium

enum class Fault : std::uint8_t {
    Contradiction,     ///< what is declared on the ray's side is not what the ray is in
    SeparatesNothing,  ///< glass2 without media, or with the same on both sides
    NestedGlass,       ///< glass with an index of its own, in a medium or in glass
    NoExterior,        ///< glass2 that says nothing of what is around it
};

/// Surfaces that have the same fault.
struct FaultKey {
    Fault fault = Fault::Contradiction;
    bool behind = false;                ///< met from there
    MediumNumber carried = kNoMedium;   ///< by the ray
    MediumNumber interior = kNoMedium;  ///< as declared
    MediumNumber exterior = kNoMedium;

    auto operator<=>(const FaultKey&) const = default;
};

/// How often one side of a surface was met, and with which fault.
struct SideCount {
    int met = 0;
    std::map<FaultKey, int> faults;
};

bool comes_before(const SourceLocation& a, const SourceLocation& b) {
    const auto place = [](const SourceLocation& where) {
        return std::tuple(where.file ? std::string_view(where.file->name) : std::string_view(),
                          where.line, where.column);
    };
    return place(a) < place(b);
}

class Walks {
  public:
    Walks(const MeetSurface& meet, const MediaTable& media) : meet_(meet), media_(media) {}

    void walk_from(const MediaStart& start) {
        for (int i = 0; i < kWalks; ++i)
            walk(ray_from_medium(start.place, direction_on_sphere(i, kWalks), 0, start.media));
    }

    void walk_to(const Vec3& target, const MediaStart& start) {
        const Vec3 way = target - start.place;
        if (way.length2() > 0) walk(ray_from_medium(start.place, way.normalized(), 0, start.media));
    }

    /// The surfaces with each fault.
    std::map<FaultKey, std::set<const Primitive*>> faults() const {
        std::map<FaultKey, std::set<const Primitive*>> found;
        for (const auto& [side, count] : sides_) {
            for (const auto& [key, times] : count.faults) {
                // Open water lets rays come to its ground that have not entered it.
                const int tells = key.carried == kNoMedium ? kTellsOfNone : kTells;
                if (tells * times >= count.met) found[key].insert(side.first);
            }
        }
        return found;
    }

  private:
    void walk(Ray ray) {
        std::vector<const Primitive*> glass;  // that was entered
        for (int i = 0; i < kWalkSurfaces; ++i) {
            SurfaceHit hit;
            const Surface* const surface = meet_(ray, hit);
            if (!surface) return;
            look(ray, hit, *surface, glass);
            const bool passes = surface->transmits && next() < kPassShare;
            if (passes && surface->own_index) cross(ray, hit, *surface, glass);
            ray = spawn_ray(hit, passes ? ray.direction : away(ray, hit), 0);
        }
    }

    static void cross(const Ray& ray, const SurfaceHit& hit, const Surface& surface,
                      std::vector<const Primitive*>& glass) {
        if (ray.direction.dot(hit.ng) <= 0) {
            glass.push_back(surface.primitive);
        } else if (!glass.empty()) {
            glass.pop_back();
        }
    }

    Vec3 away(const Ray& ray, const SurfaceHit& hit) {
        const Vec3 side = ray.direction.dot(hit.ng) > 0 ? -hit.ng : hit.ng;
        const float u = next();
        return Frame(side).to_world(square_to_cosine_hemisphere(Vec2(u, next())));
    }

    void look(const Ray& ray, const SurfaceHit& hit, const Surface& surface,
              const std::vector<const Primitive*>& glass) {
        const bool behind = ray.direction.dot(hit.ng) > 0;
        const MediumNumber near = behind ? surface.interior : surface.exterior;
        const MediumNumber carried = ray.media.known().innermost();
        SideCount& side = sides_[{surface.primitive, behind}];
        ++side.met;
        const auto add = [&](Fault fault) {
            const bool of_side = fault == Fault::Contradiction && behind;
            ++side.faults[{fault, of_side, carried, surface.interior, surface.exterior}];
        };
        if (near != kNoMedium && !same_optics(media_.medium(near), media_.medium(carried)))
            add(Fault::Contradiction);
        if (surface.index_of_media) {
            if (surface.interior == surface.exterior) {
                add(Fault::SeparatesNothing);
            } else if (!behind && near == kNoMedium && carried != kNoMedium) {
                add(Fault::NoExterior);
            }
        }
        const Medium* const medium = media_.medium(carried);
        const bool in_medium = medium && medium->index() != 1;
        if (surface.own_index && !behind && (in_medium || !glass.empty())) add(Fault::NestedGlass);
    }

    float next() { return static_cast<float>(numbers_() >> 8) * 0x1p-24f; }

    const MeetSurface& meet_;
    const MediaTable& media_;
    std::mt19937 numbers_{1};
    std::map<std::pair<const Primitive*, bool>, SideCount> sides_;
};

/// Reasons that a declaration does not fit, and what to write.
std::string contradiction(const FaultKey& key, const MediaTable& media) {
    const MediumNumber near = key.behind ? key.interior : key.exterior;
    const MediumNumber far = key.behind ? key.exterior : key.interior;
    const std::string carried = quoted_medium(media, key.carried);
    std::string text = fmt::format(
        "{} \"{}\" is not what rays are in that come to this side of the shape: they come in {}, "
        "and stay in that until they cross the surface",
        key.behind ? "Interior" : "Exterior", media.name(near), carried);
    if (same_optics(media.medium(far), media.medium(key.carried))) {
        text += "; Interior and Exterior look swapped, or the shape is inside out";
    } else if (key.behind) {
        text += "; the shape looks open or inside out, or another reaches into it";
    } else if (key.carried != kNoMedium) {
        text += fmt::format("; leave its Exterior out, or name {}", carried);
        if (media.medium(key.carried)->index() != 1) text += ", as for the inner walls of a vessel";
    } else {
        text += "; is the statement left over from a shape before?";
    }
    return text;
}

std::string text_of(const FaultKey& key, const MediaTable& media) {
    const std::string carried = quoted_medium(media, key.carried);
    switch (key.fault) {
        case Fault::Contradiction:
            return contradiction(key, media);
        case Fault::SeparatesNothing:
            if (key.interior == kNoMedium) {
                return fmt::format(
                    "\"glass2\" without Interior and Exterior bends nothing: rays stay in {}; the "
                    "inner walls of a vessel need what it is made of and what it holds",
                    carried);
            }
            return fmt::format(
                "\"glass2\" with \"{}\" as its Interior and its Exterior bends nothing",
                media.name(key.interior));
        case Fault::NestedGlass:
            return fmt::format(
                "\"glass\" has the index of its surface against vacuum, but rays come to it within "
                "{}: give both volumes and \"glass2\"",
                key.carried == kNoMedium ? std::string("other glass") : carried);
        case Fault::NoExterior:
            break;
    }
    return fmt::format("has no Exterior: rays come to it in {}, which is taken for it", carried);
}

}  // namespace

bool same_optics(const Medium* a, const Medium* b) {
    static const Medium vacuum(Rgb(0.0f), 1);
    const Medium& x = a ? *a : vacuum;
    const Medium& y = b ? *b : vacuum;
    const auto same = [](const IndexCurve& m, const IndexCurve& n) {
        return m.a == n.a && m.b == n.b && m.c == n.c;
    };
    const MediumCoefficients p = x.coefficients(), q = y.coefficients();
    return p.absorption == q.absorption && p.scattering == q.scattering &&
           (is_black(p.scattering) || p.asymmetry == q.asymmetry) &&
           same(x.index_curve(), y.index_curve());
}

std::string quoted_medium(const MediaTable& media, MediumNumber medium) {
    return medium == kNoMedium ? "no medium" : in_quotes(media.name(medium));
}

std::vector<MediaNote> review_media(const MeetSurface& meet, const MediaTable& media,
                                    const std::vector<MediaStart>& starts,
                                    const std::vector<Vec3>& targets) {
    Walks walks(meet, media);
    for (std::size_t i = 0; i < targets.size() && !starts.empty(); ++i)
        walks.walk_to(targets[i], starts[i % starts.size()]);
    for (const MediaStart& start : starts)
        walks.walk_from(start);
    std::vector<MediaNote> notes;
    for (const auto& [key, surfaces] : walks.faults()) {
        const auto first = std::min_element(surfaces.begin(), surfaces.end(),
                                            [](const Primitive* a, const Primitive* b) {
                                                return comes_before(a->where, b->where);
                                            });
        std::string text = text_of(key, media);
        if (surfaces.size() > 1)
            text += fmt::format(" (so do {} other shapes)", surfaces.size() - 1);
        notes.push_back({(*first)->where, text, key.fault == Fault::Contradiction});
    }
    std::stable_sort(notes.begin(), notes.end(), [](const MediaNote& a, const MediaNote& b) {
        return comes_before(a.where, b.where);
    });
    return notes;
}

}  // namespace lxs
