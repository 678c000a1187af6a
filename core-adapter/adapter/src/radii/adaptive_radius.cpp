// Radii that balance noise and bias.
#include "radii/adaptive_radius.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/assign_all.h"
#include "base/constants.h"
#include "base/disjoint_ranges.h"
#include "base/parallel_for.h"
#include "base/vector_growth.h"
#include "radii/constants.h"
#include "radii/scheduled_radius.h"

namespace aips {
namespace {

constexpr std::uint32_t kProbeTurns = kFilmCell * kFilmCell;

/// The estimate if all contributions were multiplied by `factor`.
ProbeEstimate scaled(ProbeEstimate estimate, double factor) {
    estimate.second_moment *= factor * factor;
    for (LaplacianEstimate& laplacian : estimate.laplacian) {
        laplacian.value *= factor;
        laplacian.error2 *= factor * factor;
    }
    return estimate;
}

/// The radius to take where `optimal` would be best, and `schedule` is that of the schedule.
float in_range_of(double schedule, double optimal) {
    // No photon has been seen nearby, or numbers too large or too small to reckon with.
    if (!(optimal > 0 && optimal <= double(std::numeric_limits<float>::max())))
        return float(schedule);
    return float(std::clamp(optimal, kLeastOfSchedule * schedule, kGreatestOfSchedule * schedule));
}

/// Whether the visible points of a pixel have probes in a pass. 7 has no factor in common with 16:
/// all pixels take turns, neighbours not one after the other.
class ProbeTurn {
  public:
    ProbeTurn(std::uint64_t pass, std::uint32_t width)
        : width_(width), turn_(std::uint32_t(pass % kProbeTurns * 7 % kProbeTurns)) {}
    bool operator()(std::uint32_t pixel) const {
        const std::uint32_t column = pixel % width_, row = pixel / width_;
        return row % kFilmCell * kFilmCell + column % kFilmCell == turn_;
    }

  private:
    std::uint32_t width_, turn_;
};

}  // namespace

AdaptiveRadius::AdaptiveRadius(const Settings& settings, const Scene& scene, std::uint32_t width,
                               std::uint32_t height)
    : settings_(settings),
      floor_(scene),
      map_(width, height),
      of_one_path_(std::size_t{width} * height) {
    if (settings.narrow_radii) blur_.emplace(of_one_path_.size());
}

GatherRadii AdaptiveRadius::before_pass(const PassPhotons& photons, const EyeImage& image) {
    if (!(initial_ > 0)) {
        initial_ = initial_radius(settings_, image, floor_.least());
        unit_ = kProbeRadius * initial_;
    }
    pass_paths_ = double(photons.paths);
    const auto shot = double(photons.before);
    const double schedule = double(scheduled_radius(settings_, initial_, shot, floor_.least()));
    const double optimum =
        unit_ * optimal_radius(1, 1, shot + pass_paths_) / optimal_radius(1, 1, 1);
    renew();
    const std::size_t points = image.visible_points.size(), most = image.positions.size();
    reserve_with_room(radii_, points, most);
    reserve_with_room(pixels_, points, most);
    radii_.resize(points);
    pixels_.resize(points);
    const ProbeTurn has_turn(passes_++, map_.width());
    // Of each job, how many points have probes; then, where their numbers begin.
    std::vector<std::size_t> first((points + kItemsPerJob - 1) / kItemsPerJob + 1);
    in_chunks(points, kItemsPerJob, tbb_for, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const VisiblePoint& point = image.visible_points[i];
            pixels_[i] = map_.pixel(image.positions[point.sample]);
            const double radius = optimum * double(of_one_path_[pixels_[i]]);
            const float narrowing = blur_ ? blur_->narrowing(pixels_[i]) : 1;
            radii_[i] =
                std::max(narrowing * in_range_of(schedule, radius), floor_.at(point.position));
            first[begin / kItemsPerJob + 1] += has_turn(pixels_[i]) ? 1 : 0;
        }
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    reserve_with_room(probes_, first.back(), most);
    probes_.resize(first.back());
    in_chunks(points, kItemsPerJob, tbb_for, [&](std::size_t begin, std::size_t end) {
        std::size_t next = first[begin / kItemsPerJob];
        for (std::size_t i = begin; i < end; ++i) {
            if (has_turn(pixels_[i])) probes_[next++] = std::uint32_t(i);
        }
    });
    GatherRadii radii{std::span<const float>(radii_)};
    radii.probes = probes_;
    radii.probe_radius = float(unit_ * std::pow(1 + shot / kReferencePaths, kProbePower));
    probe_radius_ = double(radii.probe_radius);
    return radii;
}

void AdaptiveRadius::renew() {
    in_chunks(of_one_path_.size(), kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        for (std::size_t pixel = first; pixel < last; ++pixel) {
            const ProbeEstimate known = map_.mean(std::uint32_t(pixel));
            of_one_path_[pixel] =
                float(optimal_radius(known.second_moment, expected_squared_laplacian(known), 1));
        }
    });
}

// With lengths in units of the first probes' radius contributions are about as large as radiance
// whatever the scene's scale, and their fourth powers within range.
void AdaptiveRadius::after_pass(const PhotonFlux& flux) {
    if (blur_) learn_blur(flux);
    in_disjoint_ranges(
        probes_.size(), [&](std::size_t i) { return pixels_[probes_[i]]; },
        [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const ProbeEstimate estimate =
                    probe_estimate(flux.probes[i], probe_radius_ / unit_, pass_paths_);
                map_.add(pixels_[probes_[i]], scaled(estimate, 1 / (unit_ * unit_)));
            }
        });
}

/// In the same units, as far as they are the same for all of a pixel: what the surface and the eye
/// path take is left out.
void AdaptiveRadius::learn_blur(const PhotonFlux& flux) {
    const std::size_t groups = flux.flux.size() / radii_.size();
    in_disjoint_ranges(
        radii_.size(), [&](std::size_t i) { return pixels_[i]; },
        [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const double radius = double(radii_[i]) / unit_;
                const double scale = 1 / (radius * radius * pass_paths_);
                double whole = 0;
                for (const Rgb& group : std::span(flux.flux).subspan(i * groups, groups))
                    whole += double(luminance(group));
                const double half = 2 * double(luminance(flux.inner[i]));
                const double variance = double(flux.squares[i]) * scale * scale;
                blur_->add(pixels_[i], {whole * scale, half * scale, variance});
            }
        });
    blur_->end_pass();
}

// The rest is of one pass.
void AdaptiveRadius::state(StateArchive& archive, const EyeImage& /*image*/) {
    state_of_initial_radius(archive, initial_, floor_.least());
    unit_ = kProbeRadius * initial_;
    archive.value(passes_);
    map_.state(archive);
    if (blur_) blur_->state(archive);
    for (float& radius : of_one_path_)
        archive.value(radius);
}

std::size_t AdaptiveRadius::memory_bytes() const {
    return map_.memory_bytes() + (blur_ ? blur_->memory_bytes() : 0) +
           of_one_path_.capacity() * sizeof(float) +
           (pixels_.capacity() + probes_.capacity()) * sizeof(std::uint32_t) +
           radii_.capacity() * sizeof(float);
}

std::size_t AdaptiveRadius::memory_bound_bytes(std::size_t pixels, std::size_t visible_points,
                                               bool narrows) {
    const std::size_t point = kVectorGrowth * (sizeof(float) + 2 * sizeof(std::uint32_t));
    const std::size_t blur = narrows ? BlurMap::memory_bound_bytes(pixels) : 0;
    return CurvatureMap::memory_bound_bytes(pixels) + blur + pixels * sizeof(float) +
           visible_points * point;
}

}  // namespace aips
