// Edges found by rays, and what photons brought there.
#include "estimate/edge_correction.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <numbers>

#include "aips/core/base/constants.h"
#include "aips/core/sampling/sampling.h"
#include "base/assign_all.h"
#include "base/film_pixel.h"
#include "base/ordered_sum.h"
#include "base/parallel_for.h"

namespace aips {
namespace {

/// Chance of a place in a gather disc to be asked for likewise where no edge is known.
constexpr float kOcclusionAsked = 1.0f / float(kLateOneOf);

/// Luminance that photons brought to visible points, and what they bring more by their factors.
struct Brightening {
    double before = 0, added = 0;

    Brightening& operator+=(const Brightening& other) {
        before += other.before;
        added += other.added;
        return *this;
    }
};

}  // namespace

EdgeCorrection::EdgeCorrection(const Scene& scene, const Settings& settings, std::uint32_t width,
                               std::uint32_t height, const PhotonOcclusion* occlusion)
    : scene_(scene),
      settings_(settings),
      width_(width),
      height_(height),
      occlusion_(occlusion),
      noise_(width, height),
      edges_(std::size_t{width} * height),
      found_(edges_.size()),
      walls_(settings.photon_occlusion ? edges_.size() : 0),
      found_walls_(walls_.size()),
      gaps_(settings.continue_eye_paths ? edges_.size() : 0) {}

SurfaceQuestion EdgeCorrection::question(std::uint32_t pixel, Vec2 film) const {
    SurfaceQuestion question{edges_[pixel] ? kEdgeGrid : 1, believed(pixel)};
    if (occlusion_) {
        const bool wall = walls_[pixel] || occlusion_->asks_all(film);
        question.occlusion = wall ? 1 : kOcclusionAsked;
    }
    return question;
}

float EdgeCorrection::lost_share(Vec2 film) const {
    const std::uint32_t pixel = film_pixel(film, width_, height_);
    if (gaps_.empty() || !edges_[pixel]) return -1;
    const Gap& gap = gaps_[pixel];
    return gap.lost / (gap.asked + 1);
}

bool EdgeCorrection::loses(const VisiblePoint& point, Vec2 film, float time, RandomStream& random,
                           Arena& arena, std::uint32_t& rays) const {
    const std::uint32_t pixel = film_pixel(film, width_, height_);
    SurfaceShare surface(scene_, time, arena);
    const bool lost = surface.loses(point, gaps_[pixel].radius, question(pixel, film), random);
    rays += std::uint32_t(surface.rays());
    return lost;
}

std::uint64_t EdgeCorrection::correct(std::uint64_t pass, float time, const EyeImage& image,
                                      const GatherRadii& radii, PhotonFlux& flux) {
    std::atomic<std::uint64_t> rays{0};
    assign_all(factors_, image.visible_points.size(), 1.0f, image.positions.size());
    assign_all(met_walls_, walls_.empty() ? 0 : image.visible_points.size(), std::uint8_t{0},
               image.positions.size());
    const PointOwners& owners = image.owners;
    SharedWork work = work_on_points(owners, nullptr);
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(owners.first(factors_.size()), owners.last(factors_.size()),
                                        256),
        [&](const tbb::blocked_range<std::size_t>& range) {
            Arena arena;
            SurfaceShare surface(scene_, time, arena);
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                if (flux.accepted[i] == 0) continue;
                const VisiblePoint& point = image.visible_points[i];
                const std::uint32_t pixel =
                    film_pixel(image.positions[point.sample], width_, height_);
                const SurfaceQuestion question =
                    this->question(pixel, image.positions[point.sample]);
                if (question.believed >= 1) continue;
                RandomStream random(settings_.seed, pass, point.sample, RandomDomain::Edge);
                const float missing = surface.missing(point, radii.of(i), question, random);
                if (surface.met_separated()) met_walls_[i] = 1;
                if (flux.wants_inner && (edges_[pixel] || missing > 0)) {
                    const float radius = radii.of(i) * std::numbers::sqrt2_v<float> / 2;
                    flux.inner[i] *= 1 + surface.missing(point, radius, question, random);
                }
                factors_[i] = 1 + missing;
            }
            rays.fetch_add(surface.rays(), std::memory_order_relaxed);
        });
    std::uint64_t all_rays = rays.load();
    work.exchange([&, own = all_rays](std::uint32_t rank, StateArchive& archive) {
        plain_of_points(archive, owners, rank, factors_);
        plain_of_points(archive, owners, rank, met_walls_);
        plain_of_points(archive, owners, rank, flux.inner);
        std::uint64_t of_rank = own;
        archive.value(of_rank);
        if (archive.restoring()) all_rays += of_rank;
    });
    // Noise is that of photons as they came.
    if (adapts_radius(settings_)) noise_.add_pass(image, flux);
    apply(image, flux);
    remember(image, radii);
    return all_rays;
}

void EdgeCorrection::apply(const EyeImage& image, PhotonFlux& flux) {
    const auto apply_to = [&](std::size_t first, std::size_t last) {
        Brightening sum;
        for (std::size_t i = first; i < last; ++i) {
            if (settings_.transport_statistics) {
                const VisiblePoint& point = image.visible_points[i];
                const Rgb weight = point.throughput * left_out_f(point);
                for (std::size_t g = 0; g < image.groups; ++g) {
                    const auto brought =
                        double(luminance(weight * flux.flux[i * image.groups + g]));
                    sum += {brought, brought * double(factors_[i] - 1)};
                }
            }
            if (factors_[i] != 1) flux.scale_point(i, image.groups, factors_[i]);
        }
        return sum;
    };
    const auto [before, added] = ordered_sum<Brightening>(factors_.size(), apply_to);
    brightened_ = before > 0 ? 1 + added / before : 1;
}

/// Chance of a place in the disc of this pixel's points to pass for surface unasked.
float EdgeCorrection::believed(std::uint32_t pixel) const {
    if (!adapts_radius(settings_)) return 0;
    return float(std::min(kBeliefOfNoise * noise_.relative_variance(pixel), 1.0));
}

/// What this pass has found steers the next ones.
void EdgeCorrection::remember(const EyeImage& image, const GatherRadii& radii) {
    in_chunks(factors_.size(), kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (factors_[i] == 1) continue;
            const Vec2 place = image.positions[image.visible_points[i].sample];
            const std::uint32_t pixel = film_pixel(place, width_, height_);
            // Several visible points may be in one pixel: all say the same.
            std::atomic_ref(found_[pixel]).store(1, std::memory_order_relaxed);
            if (!gaps_.empty())
                std::atomic_ref(gaps_[pixel].radius).store(radii.of(i), std::memory_order_relaxed);
            if (!met_walls_.empty() && met_walls_[i])
                std::atomic_ref(found_walls_[pixel]).store(1, std::memory_order_relaxed);
        }
    });
    if (!gaps_.empty()) learn_gaps(image);
    age(edges_, found_);
    age(walls_, found_walls_);
}

void EdgeCorrection::learn_gaps(const EyeImage& image) {
    for (const VisiblePoint& point : image.visible_points) {
        if (point.place == DiscPlace::NotAsked) continue;
        Gap& gap = gaps_[film_pixel(image.positions[point.sample], width_, height_)];
        if (gap.asked >= kEdgePasses) {
            gap.asked /= 2;
            gap.lost /= 2;
        }
        gap.asked += 1;
        if (point.place == DiscPlace::Gap) gap.lost += 1;
    }
}

/// Sets or lowers the `passes` for which pixels count as what they were found to be.
void EdgeCorrection::age(std::vector<std::uint8_t>& passes, std::vector<std::uint8_t>& found) {
    in_chunks(passes.size(), kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (found[i]) {
                passes[i] = kEdgePasses;
            } else if (passes[i]) {
                --passes[i];
            }
            found[i] = 0;
        }
    });
}

void EdgeCorrection::state(StateArchive& archive) {
    noise_.state(archive);
    for (std::vector<std::uint8_t>* pixels : {&edges_, &walls_}) {
        archive.fixed(*pixels);
        for (const std::uint8_t passes : *pixels)
            StateArchive::check(passes <= kEdgePasses, "pixels at edges");
    }
    for (Gap& gap : gaps_) {
        for (float* value : {&gap.radius, &gap.asked, &gap.lost})
            archive.amount(*value);
        StateArchive::check(gap.lost <= gap.asked && gap.asked <= kEdgePasses + 1,
                            "light lost at edges");
    }
}

}  // namespace aips
