// Trials of places in a gather disc.
//
// The number of trials until one succeeds has the mean 1 / p: no density has to be known to divide
// by it without bias (Qin et al. 2015, "Unbiased photon gathering for light transport simulation",
// use it for paths).
#include "estimate/surface_share.h"

#include "aips/core/sampling/sampling.h"
#include "estimate/constants.h"
#include "estimate/gather.h"
#include "estimate/photon_occlusion.h"
#include "eye/surface_normals.h"

namespace aips {
namespace {

/// Surfaces above each other that a place is looked for on.
constexpr int kMostSurfaces = 4;

}  // namespace

/// The gather disc of a visible point, on the eye's side.
class SurfaceShare::Disc {
  public:
    Disc(const VisiblePoint& point, float radius)
        : point_(point), radius_(radius), frame_(normal_towards(point.wo, point)) {}

    /// A place in it, from the unit square.
    Vec3 place(Vec2 u) const {
        const Vec2 d = square_to_concentric_disk(u);
        return point_.position + (frame_.s * d.x + frame_.t * d.y) * radius_;
    }
    /// Unit, towards the eye.
    Vec3 normal() const { return frame_.n; }
    /// From above a place straight down.
    void aim(Vec3 place, Ray& ray) const {
        ray.origin = place + frame_.n * (kSlab * radius_);
        ray.direction = -frame_.n;
    }
    bool within_slab(Vec3 position) const {
        return abs_dot(position - point_.position, frame_.n) <= kSlab * radius_;
    }
    /// Goes on beyond a surface.
    void go_below(Vec3 met, Ray& ray) const {
        ray.origin = met - frame_.n * occlusion_clearance(met, point_.position, radius_);
    }
    bool has(const SurfacePoint& met) const {
        return on_same_surface(point_, met.position,
                               dot(met.geometric_normal, point_.geometric_normal), radius_);
    }

    const VisiblePoint& point() const { return point_; }
    float radius() const { return radius_; }

  private:
    const VisiblePoint& point_;
    float radius_;
    Frame frame_;
};

SurfaceShare::SurfaceShare(const Scene& scene, float time, Arena& arena)
    : scene_(scene), arena_(arena) {
    ray_.time = time;
}

// All surfaces within the slab are looked at: below glass that stands on a floor, where photons
// land, the first one is the glass.
bool SurfaceShare::finds(const Disc& disc, Vec2 u, const SurfaceQuestion& question,
                         RandomStream& random) {
    disc.aim(disc.place(u), ray_);
    const bool asks_reach =
        question.occlusion >= 1 || (question.occlusion > 0 && random.next() < question.occlusion);
    for (int surface = 0; surface < kMostSurfaces; ++surface) {
        ++rays_;
        SurfacePoint met;
        const auto mark = arena_.mark();
        const bool any = scene_.intersect_shape(ray_, met, arena_);
        arena_.rewind(mark);
        if (!any || !disc.within_slab(met.position)) return false;
        if (disc.has(met)) {
            if (!asks_reach || reaches(disc, met)) return true;
            met_separated_ = true;
        }
        disc.go_below(met.position, ray_);
    }
    return false;
}

bool SurfaceShare::reaches(const Disc& disc, const SurfacePoint& met) {
    ++rays_;
    const Vec3 normal = normal_towards(disc.normal(), met);
    return !separated(scene_, disc.point(), met.position, normal, disc.radius(), ray_.time);
}

float SurfaceShare::missing(const VisiblePoint& point, float radius,
                            const SurfaceQuestion& question, RandomStream& random) {
    const std::uint32_t side = question.side;
    const Disc disc(point, radius);
    const auto passes = [&](Vec2 u) {
        if (question.believed > 0 && random.next() < question.believed) return true;
        return finds(disc, u, question, random);
    };
    met_separated_ = false;
    std::uint32_t trials = 0;
    for (std::uint32_t cell = 0; cell < side * side; ++cell) {
        const std::uint32_t column = cell % side, row = cell / side;
        const Vec2 within = random.next2();
        if (passes(
                {(float(column) + within.x) / float(side), (float(row) + within.y) / float(side)}))
            continue;
        // Its own trials, all over the disc: as many as 1 / p in the mean.
        for (std::uint32_t trial = 1; trial <= kMostTrials; ++trial) {
            ++trials;
            if (passes(random.next2())) break;
        }
    }
    return float(trials) / float(side * side);
}

// With p places of surface and p' that pass, missing() makes photons bring
// p (1 - (1 - p')^(kMostTrials + 1)) / p' of the light. That is the chance that one of so many
// places passes, and that the first that does is surface, whether it was asked or not.
bool SurfaceShare::loses(const VisiblePoint& point, float radius, const SurfaceQuestion& question,
                         RandomStream& random) {
    const Disc disc(point, radius);
    for (std::uint32_t trial = 0; trial <= kMostTrials; ++trial) {
        const bool believed = question.believed > 0 && random.next() < question.believed;
        const bool found = finds(disc, random.next2(), question, random);
        if (found || believed) return !found;
    }
    return true;
}

}  // namespace aips
