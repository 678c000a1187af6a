// Joining continued eye paths and photons, and learning from both.
#include "strategies/shared_light.h"

#include <algorithm>

#include "base/constants.h"
#include "base/film_pixel.h"
#include "base/ordered_sum.h"
#include "base/parallel_for.h"
#include "contribution/pass_noise.h"
#include "estimate/pixel_estimate.h"
#include "eye/surface_normals.h"
#include "plan/constants.h"
#include "strategies/constants.h"

namespace aips {
namespace {

/// Visible points that what another render learned of shared light counts for.
constexpr double kRememberedPoints = 1e4;

/// Visible points of a job, and jobs whose samples are kept at once: 8 MiB of them.
constexpr std::size_t kPointsPerSharingJob = 512, kSharingJobs = 128;

/// Of eye paths that went on from visible points.
struct WentOn {
    double rays = 0;
    std::uint64_t paths = 0;

    WentOn& operator+=(const WentOn& other) {
        rays += other.rays;
        paths += other.paths;
        return *this;
    }
};

WentOn went_on(std::span<const VisiblePoint> points) {
    return ordered_sum<WentOn>(points.size(), [&](std::size_t first, std::size_t last) {
        WentOn sum;
        for (const VisiblePoint& point : points.subspan(first, last - first))
            sum += {double(point.eye_rays), std::uint64_t{point.continued || point.fills}};
        return sum;
    });
}

/// What point number `i` tells of a pass with `paths` photon paths.
ShareSample sample_of(const EyeImage& image, const PhotonFlux& flux, std::size_t i, double weight,
                      float radius, std::uint64_t photon_paths) {
    const auto paths = double(photon_paths);
    const VisiblePoint& point = image.visible_points[i];
    ShareSample sample;
    sample.position = point.position;
    sample.normal = normal_towards(point.wo, point);
    sample.weight = weight;
    sample.continued = point.continued;
    sample.photon_paths = paths;
    sample.rays = double(point.eye_rays);
    sample.eye = double(luminance_over_groups(image.continued, point.sample, image.groups));
    sample.direct_saved = double(point.direct.taken()) - double(point.direct.added());
    const auto brought = double(luminance_over_groups(flux.flux, i, image.groups));
    if (!(brought > 0)) return sample;
    const double scale = luminance_of_point(image, flux, i, radius, photon_paths) / brought;
    const double rest = 1 - double(point.eye_share);
    const ShareableFlux& part = flux.shareable[i];
    sample.photons = scale * double(part.sum) / rest;
    if (point.fills) sample.filled = sample.eye;
    sample.squares = paths * scale * scale * double(part.squares) / (rest * rest);
    // Trimmed as the noise of a pass is: single pixels are not to decide on the photons of all.
    const double others =
        scale * scale * std::max(0.0, double(flux.squares[i]) - double(part.squares));
    sample.others = paths * trimmed(others, weight);
    return sample;
}

}  // namespace

void SharedLight::join(const ShotPass& pass, const EyeImage& image, const PhotonFlux& flux,
                       const GatherRadii& radii, const PixelImportance& importance,
                       std::span<Rgb> radiance) {
    const WentOn counted = went_on(image.visible_points);
    rays_ = counted.rays;
    continued_ += counted.paths;
    own_noise_.add_pass(image, importance, pass.number > 0);
    photon_square_.add_pass(image, radiance);
    // Before the first pass all pixels weigh alike, in no unit.
    if (pass.number > 0) learn(pass, image, flux, radii, importance);
    add_eye_share(image, radiance);
    if (pass.number > 0 && shares_.gloss) learn_gloss(pass, image, flux, radii, importance);
}

void SharedLight::go_on_alone(const EyeImage& image, std::span<Rgb> radiance) {
    continued_ += went_on(image.visible_points).paths;
    add_eye_share(image, radiance);
}

void SharedLight::add_eye_share(const EyeImage& image, std::span<Rgb> radiance) const {
    in_chunks(image.visible_points.size(), kItemsPerJob, tbb_for,
              [&](std::size_t first, std::size_t last) {
                  for (std::size_t i = first; i < last; ++i) {
                      const VisiblePoint& point = image.visible_points[i];
                      const float share = point.continued_share();
                      if (!(share > 0)) continue;
                      const std::size_t at = std::size_t(point.sample) * image.groups;
                      for (std::size_t g = at; g < at + image.groups; ++g)
                          radiance[g] += image.continued[g] * share;
                  }
              });
}

void SharedLight::learn(const ShotPass& pass, const EyeImage& image, const PhotonFlux& flux,
                        const GatherRadii& radii, const PixelImportance& importance) {
    const std::size_t points = image.visible_points.size();
    std::vector<std::vector<ShareSample>> samples(
        std::min(kSharingJobs, (points + kPointsPerSharingJob - 1) / kPointsPerSharingJob));
    const auto collect = [&](std::size_t first, std::size_t last, std::vector<ShareSample>& into) {
        into.clear();
        for (std::size_t i = first; i < last; ++i) {
            const VisiblePoint& point = image.visible_points[i];
            if (!shares_.learns_from(pass.number, point.sample)) continue;
            const std::uint32_t pixel = film_pixel(image.positions[point.sample], width_, height_);
            const auto weight = double(importance.weight_of_sharing(pixel));
            into.push_back(sample_of(image, flux, i, weight, radii.of(i), pass.photon_paths));
        }
    };
    std::size_t learned = 0;
    for (std::size_t begin = 0; begin < points; begin += kSharingJobs * kPointsPerSharingJob) {
        tbb_for(std::uint32_t(samples.size()), [&](std::uint32_t job) {
            const std::size_t first = begin + job * kPointsPerSharingJob;
            collect(first, std::min(first + kPointsPerSharingJob, points), samples[job]);
        });
        shares_.table.add(samples, tbb_for);
        for (const std::vector<ShareSample>& of_job : samples)
            learned += of_job.size();
    }
    shares_.table.update(learned);
}

void SharedLight::learn_gloss(const ShotPass& pass, const EyeImage& image, const PhotonFlux& flux,
                              const GatherRadii& radii, const PixelImportance& importance) {
    std::size_t learned = 0;
    for (std::size_t i = 0; i < image.visible_points.size(); ++i) {
        const VisiblePoint& point = image.visible_points[i];
        if (!point.gloss.learns) continue;
        const std::uint32_t pixel = film_pixel(image.positions[point.sample], width_, height_);
        const double scale = per_disk_and_path(radii.of(i), pass.photon_paths);
        const GlossyFlux& told = flux.glossy[i];
        learned += shares_.gloss->add(
            {.position = point.position,
             .normal = normal_towards(point.wo, point),
             .weight = double(importance.weight_of_sharing(pixel)),
             .light = scale * double(told.light),
             .photons = scale * scale * double(pass.photon_paths) * double(told.photons),
             .bounce = scale * scale * double(told.bounce)});
    }
    shares_.gloss->update(learned);
}

void SharedLight::add_to(PlanFacts& facts, const PixelImportance& importance) {
    facts.leaves = shares_.table.moments();
    const auto shares = shares_.table.shares();
    facts.shares.assign(shares.begin(), shares.end());
    facts.own_variance = own_noise_.take();
    facts.photon_square = photon_square_.take(importance);
}

void SharedLight::take(const PassPlan& plan, std::uint64_t pass) {
    shares_.table.set_shares(plan.shares);
    set_any();
    shares_.table.forget(kShareMemory);
    if (shares_.gloss) shares_.gloss->choose({plan.photon_paths, plan.point_price}, kShareMemory);
    eye_part_ = plan.going_on * plan.eye_share;
    shares_.passes_before = pass;
}

void SharedLight::set_any() {
    shares_.any = std::ranges::any_of(
        shares_.table.shares(), [](const EyeShare& eye) { return eye.any() || eye.may_fill(); });
}

void SharedLight::add_to(EngineStatistics& s) const {
    s.continued_paths += continued_;
    s.eye_share = eye_part_;
    s.transport.caustics_on_gloss = shares_.gloss.has_value();
}

void SharedLight::state(StateArchive& archive) {
    shares_.table.state(archive);
    if (shares_.gloss) shares_.gloss->state(archive);
    set_any();
    own_noise_.state(archive);
    photon_square_.state(archive);
    archive.value(shares_.passes_before);
    archive.value(continued_);
    archive.amount(eye_part_);
}

void SharedLight::learned(LearnedParts& parts) {
    parts.part("shares", 0, [&](StateArchive& archive) {
        shares_.table.state(archive);
        archive.amount(eye_part_);
        if (!archive.restoring()) return;
        shares_.table.fade(kRememberedPoints);
        set_any();
    });
}

}  // namespace aips
