// The light that a medium sends by itself.
#include "medium_light.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "lxs/sdk/hashed_numbers.h"
#include "warp.h"

namespace lxs {
namespace {

constexpr int kMostCells = 32;           ///< along the longest side
constexpr unsigned kSamplesOfACell = 8;  ///< one in each octant
/// Along which what bounds the medium is looked for there: along no axis or diagonal.
const Vec3 kAnyWay(0.48f, 0.36f, 0.8f);
/// Share of points that are drawn anywhere in the box: samples miss what is small.
constexpr float kAnywhere = 0.1f;

/// Mean luminance of what each cell sends per volume and steradian.
std::vector<float> sent_by_cells(const EmittingVolume& volume, const RegularGrid& grid,
                                 const FieldJobs& jobs) {
    std::vector<float> sent(grid.count());
    jobs(grid.cells[2], [&](int z) {
        for (int y = 0; y < grid.cells[1]; ++y) {
            for (int x = 0; x < grid.cells[0]; ++x) {
                double sum = 0;
                for (unsigned i = 0; i < kSamplesOfACell; ++i) {
                    const Vec3 octant(float(i & 1u), float(i >> 1 & 1u), float(i >> 2));
                    const Vec3 cell = Vec3(float(x), float(y), float(z));
                    const Vec3 place =
                        grid.bounds.min + (cell + octant * 0.5f + Vec3(0.25f)) * grid.width;
                    sum += double(luminance(volume.emission(place, kAnyWay)));
                }
                sent[grid.index({x, y, z})] = float(sum / kSamplesOfACell);
            }
        }
    });
    return sent;
}

}  // namespace

Rgb EmittingVolume::emission(const Vec3& position, const Vec3& direction) const {
    const Rgb sent = medium->emission_at(position);
    return !is_black(sent) && inside(position, direction) ? sent : Rgb(0.0f);
}

MediumLight::MediumLight(const LightPlacement& placement, EmittingVolume volume,
                         const FieldJobs& jobs)
    : PlacedLight(placement), volume_(std::move(volume)), grid_(volume_.bounds, kMostCells) {
    std::vector<float> weights = sent_by_cells(volume_, grid_, jobs);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    cell_volume_ = grid_.width.x * grid_.width.y * grid_.width.z;
    power_ = 4 * kPi * float(sum * double(cell_volume_));
    const double mean = sum > 0 ? sum / double(weights.size()) : 1;
    for (float& weight : weights)
        weight = float((1 - double(kAnywhere)) * double(weight) + double(kAnywhere) * mean);
    const auto rows = std::size_t(grid_.cells[1]) * std::size_t(grid_.cells[2]);
    cells_ = CellChoice(std::size_t(grid_.cells[0]), rows, weights);
}

float MediumLight::density(std::size_t cell) const {
    return cells_.probability(cell / cells_.width(), cell % cells_.width()) / cell_volume_;
}

MediumLight::Point MediumLight::sample_point(const Vec2& u) const {
    const DrawnCell drawn = cells_.draw(u);
    HashedNumbers numbers = HashedNumbers().about(u.x).about(u.y);
    const auto height = std::size_t(grid_.cells[1]);
    const std::size_t y = drawn.row % height, z = drawn.row / height;
    const Vec3 cell(float(drawn.column), float(y), float(z));
    const Vec3 share(drawn.share.x, drawn.share.y, numbers.next());
    return {grid_.bounds.min + (cell + share) * grid_.width, drawn.probability / cell_volume_,
            numbers.next()};
}

bool MediumLight::sample_emission(const PrimaryPoint& u, EmissionSample& sample) const {
    const Point point = sample_point(rounded_pair(u, 0));
    const Vec3 direction = uniform_sphere(u[2], rounded_pair(u, 2).y);
    sample.power = volume_.emission(point.position, direction) * (4 * kPi / point.pdf);
    sample.normal = Vec3(0.0f);
    sample.ray = Ray{};
    sample.ray.origin = point.position;
    sample.ray.direction = direction;
    sample.ray.media = media();
    return !is_black(sample.power);
}

bool MediumLight::sample_direct(const Vec3& p, const Vec3& /*n*/, const Vec2& u,
                                DirectSample& sample) const {
    sample.pdf = 0;
    const Point aim = sample_point(u);
    const Vec3 wi = (aim.position - p).normalized();
    if (!(wi.length2() > 0)) return false;
    const auto along = [&](const auto& take) {
        for (GridWalk cells(grid_, p, wi, std::numeric_limits<double>::infinity()); cells.inside();
             cells.go_on()) {
            if (!take(cells.from(), cells.to(), double(density(cells.cell())))) break;
        }
    };
    double all = 0;
    along([&](double from, double to, double density) {
        all += (to - from) * density;
        return true;
    });
    double left = double(aim.next) * all, distance = 0, chosen = 0;
    along([&](double from, double to, double density) {
        const double here = (to - from) * density;
        chosen = density;
        distance = left < here ? from + left / density : to;
        left -= here;
        return left >= 0;
    });
    const float pdf = line_pdf(p, wi);
    if (!(all > 0) || !(distance > 0) || !(pdf > 0) || !std::isfinite(pdf)) return false;
    sample = {};
    sample.wi = wi;
    sample.distance = float(distance);
    sample.segment_end = p + wi * sample.distance;
    sample.radiance = volume_.emission(sample.segment_end, wi) * float(all / chosen);
    sample.pdf = pdf;
    return true;
}

/// Of points at distance t on the line t^2 times as many lie within a steradian.
float MediumLight::line_pdf(const Vec3& p, const Vec3& wi) const {
    double sum = 0;
    for (GridWalk cells(grid_, p, wi, std::numeric_limits<double>::infinity()); cells.inside();
         cells.go_on()) {
        const double a = cells.from(), b = cells.to();
        sum += double(density(cells.cell())) * (b - a) * (a * a + a * b + b * b) / 3;
    }
    return float(sum);
}

float MediumLight::pdf_direct(const Vec3& p, const Vec3& /*n*/, const Vec3& wi,
                              const Vec3& /*light_p*/, const Vec3& /*light_n*/,
                              std::uint32_t /*primitive*/) const {
    return line_pdf(p, wi);
}

std::unique_ptr<PlacedLight> make_medium_light(const LightPlacement& placement,
                                               EmittingVolume volume, const FieldJobs& jobs) {
    return std::make_unique<MediumLight>(placement, std::move(volume), jobs);
}

}  // namespace lxs
