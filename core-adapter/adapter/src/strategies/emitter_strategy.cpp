// Searches for images of emitters, and paths through those that are known, in each pass.
#include "strategies/emitter_strategy.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "base/ordered_sum.h"
#include "base/vector_growth.h"
#include "strategies/constants.h"

namespace aips {
namespace {

/// Brightest that a sample counts in the image's usual luminance (mean luminances).
constexpr double kBrightSample = 4;

/// Rounds in which bright samples are cut to that.
constexpr int kCutRounds = 5;

/// Mean luminance of a pass, single bright samples left out.
double usual_luminance(const FilmPass& pass) {
    double mean = 0;
    for (int round = 0; round < kCutRounds; ++round) {
        const double most =
            round == 0 ? std::numeric_limits<double>::infinity() : kBrightSample * mean;
        const auto sum_of = [&](std::size_t first, std::size_t last) {
            double part = 0;
            for (std::size_t i = first; i < last; ++i) {
                const auto photons =
                    pass.photons.empty() ? 0.0 : double(luminance(pass.photons[i]));
                part += std::min(double(luminance(pass.eye[i])) + photons, most);
            }
            return part;
        };
        const auto sum = ordered_sum<double>(pass.eye.size(), sum_of);
        mean = sum * pass.groups / double(std::max<std::size_t>(pass.eye.size(), 1));
    }
    return mean;
}

}  // namespace

EmitterStrategy::EmitterStrategy(const Host& host, std::uint32_t eye_paths)
    : log_(host.log),
      pixels_(std::size_t{host.film.width()} * host.film.height()),
      groups_(host.scene.light_groups()),
      eye_paths_(eye_paths),
      images_(host.film.width(), host.film.height(), eye_paths / double(pixels_)) {}

std::uint64_t EmitterStrategy::begin_pass(const ComingPass& pass) {
    pass_rays_ = 0;
    search(pass);
    images_.begin_pass(mean_luminance_);
    trace_emitter_paths(pass.eye, pass.number, pass.time, pass.filter, splats_);
    pass_rays_ += splats_.rays;
    light_.add(splats_.light, 1 / double(pixels_));
    ++passes_;
    paths_ += splats_.paths;
    rays_ += pass_rays_;
    return pass_rays_;
}

/// Before the first pass, and on and on, as emitters that are seen in few places may take long to
/// be found.
void EmitterStrategy::search(const ComingPass& pass) {
    const bool first = pass.number == 0;
    const auto count =
        first ? std::uint32_t(std::ceil(kFirstSearches * double(pixels_))) : later_searches();
    const EmitterFindings found =
        search_emitters(pass.eye, pass.number, count, pass.time, pass.filter);
    searches_ += count;
    search_rays_ += found.rays;
    pass_rays_ += found.rays;
    images_.add(found.images);
    if (!first) return;
    const std::size_t images = images_.all().size();
    log_.info("lamps seen in glass and mirrors: " + std::to_string(images) +
              (images == 1 ? " small image" : " small images") + " found before the first pass");
}

/// So many that they take a share of the rays.
std::uint32_t EmitterStrategy::later_searches() const {
    const double rays_of_one = std::max(1.0, double(search_rays_) / double(searches_));
    return std::uint32_t(std::ceil(kSearching * eye_rays_ / rays_of_one));
}

CarriedLight EmitterStrategy::carry(const StrategyPass& /*pass*/, PassReport& /*report*/) {
    CarriedLight light;
    light.splats = FilmSplats{splats_.positions, splats_.radiance};
    return light;
}

void EmitterStrategy::end_pass(const StrategyPass& pass, const FilmPass& film_pass) {
    eye_rays_ = double(pass.eye_rays - pass_rays_);
    // Seldom, and of all pixels: what is drawn must not follow single eye paths, which are
    // stratified over passes.
    if (std::has_single_bit(pass.number + 1)) mean_luminance_ = usual_luminance(film_pass);
}

void EmitterStrategy::state(StateArchive& archive, const EyeImage& /*image*/) {
    images_.state(archive);
    for (double* sum : {&mean_luminance_, &eye_rays_})
        archive.amount(*sum);
    for (std::uint64_t* count : {&passes_, &paths_, &searches_, &search_rays_, &rays_})
        archive.value(*count);
    light_.state(archive);
}

void EmitterStrategy::add_to(EngineStatistics& statistics) const {
    statistics.emitter_paths += paths_;
    statistics.emitter_searches += searches_;
    statistics.emitter_rays += rays_;
    statistics.emitter_images += images_.all().size();
    for (std::size_t i = 0; i < light_.sums().size(); ++i)
        sum_at(statistics.transport.lights, i).seen += light_.sums()[i] / double(passes_);
}

std::size_t EmitterStrategy::memory_bytes() const {
    return images_.memory_bytes() + splats_.memory_bytes();
}

// Splats exist twice while blocks are joined; so do findings, which are kept in no pass.
std::size_t EmitterStrategy::memory_bound_bytes() const {
    const std::size_t splat = sizeof(Vec2) + groups_ * sizeof(Rgb);
    const auto searches = std::size_t(kFirstSearches * double(pixels_));
    return EmitterImages::memory_bound_bytes(pixels_) +
           2 * kVectorGrowth *
               (EmitterImages::most_paths(eye_paths_) * splat + searches * sizeof(EmitterImage));
}

}  // namespace aips
