// Density estimation at the visible points.
#include "estimate/gather.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>

#include "base/parallel_for.h"
#include "estimate/constants.h"
#include "estimate/group_sums.h"
#include "eye/path_tip.h"
#include "eye/surface_normals.h"

namespace aips {
namespace {

/// f * power of one photon, without the constant f of Lambertian points; black if rejected.
/// `in_front` tells whether the photon came from the side that the point's geometric normal shows,
/// as the surface was where it landed: on a thin curved sheet, one that grazes the far side may lie
/// on the near side of the point's tangent plane.
Rgb reflected(const VisiblePoint& point, const GridPhoton& photon, bool in_front,
              GlossyPart& glossy) {
    if (!point.bsdf) {
        const bool same_side = in_front == (dot(point.wo, point.geometric_normal) > 0);
        return same_side ? photon.power * normal_ratio(point, photon.direction) : Rgb{};
    }
    // The Bsdf would take it for light from the other side.
    if (in_front != (dot(photon.direction, point.geometric_normal) > 0)) return {};
    // The photon's power already is flux; f alone remains, in the direction of radiance.
    const Rgb power = photon.power * normal_ratio(point, photon.direction);
    const auto by = [&](LobeMask lobes) {
        return lobes ? power * point.bsdf->evaluate(point.wo, photon.direction, Transport::Radiance,
                                                    lobes)
                     : Rgb{};
    };
    const PointGloss& gloss = point.gloss;
    if (!gloss.bounce) return by(point.receiving);
    const auto part = static_cast<ImagePart>(photon.part);
    const bool learns = gloss.learns && part == ImagePart::Caustics;
    const float density = gloss.photons.of(part);
    if (density > 0 || learns || photon.found_alone) {
        glossy.counted = by(kGlossy);
        if (!photon.found_alone) {
            glossy.pdf = point.bsdf->pdf(point.wo, photon.direction, gloss.bounce);
            if (learns) glossy.shared = glossy.counted;
            glossy.counted *= 1 - bounce_share(glossy.pdf, density);
        }
    }
    return by(point.receiving & LobeMask(~kGlossy));
}

/// Calls scale(value) for all values, on all threads.
template <class T, class Scale>
void scale_each(std::vector<T>& values, const Scale& scale) {
    in_chunks(values.size(), kItemsPerJob, tbb_for, [&](std::size_t first, std::size_t last) {
        for (T& value : std::span(values).subspan(first, last - first))
            scale(value);
    });
}

/// Photons on the glossy lobes of one visible point.
class GlossyPhotons {
  public:
    void add(Vec3 direction, float luminance, float pdf) {
        if (!(luminance > 0)) return;
        const Vec2 at = uniform_sphere_to_square(direction);
        const auto cell = [](float u) {
            return std::min(std::uint32_t(u * float(kSide)), kSide - 1);
        };
        photons_.push_back({cell(at.y) * kSide + cell(at.x), double(luminance), double(pdf)});
    }

    /// A bounce that goes where photon i came from brings the radiance there over its density. With
    /// the radiance of the cell's other photons, E[Y^2] is the sum over pairs of one cell of
    /// c_i c_j / (p_i q cell), q being the probability to bounce at all, and E[Y]^2 that over all
    /// pairs of c_i c_j. Lamps smaller than a cell or the gather disc say too little.
    void move_to(float bounce_pdf, GlossyFlux& flux) {
        std::ranges::stable_sort(photons_, {}, &Known::cell);
        double second = 0, light = 0, squares = 0;
        for (auto first = photons_.begin(); first != photons_.end();) {
            double of_cell = 0;
            auto last = first;
            for (; last != photons_.end() && last->cell == first->cell; ++last)
                of_cell += last->luminance;
            light += of_cell;
            for (; first != last; ++first) {
                const double c = first->luminance;
                squares += c * c;
                if (first->pdf > 0) second += c * (of_cell - c) / (first->pdf * kCell);
            }
        }
        flux.light += float(light);
        flux.photons += float(squares);
        const double squared_mean = light * light - squares;
        flux.bounce += float(std::max(second / double(bounce_pdf) - squared_mean, 0.0));
        photons_.clear();
    }

  private:
    static constexpr std::uint32_t kSide = 32;  // cells along a side of the square of directions
    static constexpr double kCell = 4 * double(kPi) / double(kSide * kSide);  // steradians
    struct Known {
        std::uint32_t cell;
        double luminance, pdf;
    };

    std::vector<Known> photons_;
};

/// Gathers visible points one after the other. Not for many threads at once.
class PointGather {
  public:
    PointGather(const EyeImage& image, const PhotonGrid& grid, const GatherRadii& radii,
                InvalidSampleFilter& filter, PhotonFlux& result, PhotonOcclusion* occlusion)
        : image_(image),
          grid_(grid),
          radii_(radii),
          filter_(filter),
          result_(result),
          occlusion_(occlusion),
          sums_(image.groups),
          parts_(kPhotonParts),
          inner_(1) {}

    void gather(std::size_t i) {
        const VisiblePoint& point = image_.visible_points[i];
        const float radius = radii_.of(i);
        // Left out of the flux, but what it absorbs is no contribution.
        const Rgb f = point.bsdf ? kWhite : point.kd;
        const auto for_each_accepted = [&](const auto& take) {
            grid_.for_each_in_radius(point.position, radius, [&](const GridPhoton& photon) {
                GlossyPart glossy;
                const Rgb value = contribution(point, photon, radius, &glossy);
                const bool brings = !is_black(value * f) || !is_black(glossy.shared);
                if (!brings || !filter_.accept(value, point.material)) return;
                take(photon, value, glossy);
            });
        };
        count_ = 0;
        squares_ = shareable_ = shareable_squares_ = 0;
        const OcclusionTest test =
            occlusion_ ? occlusion_->test_of(point, i, image_.positions[point.sample])
                       : OcclusionTest::None;
        if (test == OcclusionTest::None) {
            for_each_accepted(
                [&](const GridPhoton& photon, const Rgb& value, const GlossyPart& glossy) {
                    add(i, photon, value, glossy, radius);
                });
        } else {
            candidates_.clear();
            for_each_accepted(
                [&](const GridPhoton& photon, const Rgb& value, const GlossyPart& glossy) {
                    candidates_.push_back({&photon, value, glossy, luminance(value)});
                });
            const bool all = test == OcclusionTest::All || finds_blocked(point, radius);
            if (all) drop_blocked(point, i, radius);
            for (const Candidate& candidate : candidates_)
                add(i, *candidate.photon, candidate.value, candidate.glossy, radius);
        }
        move_to_result(i);
    }

    const GatherCounts& counts() const { return counts_; }

  private:
    /// A photon that the point accepts, unless something separates the two.
    struct Candidate {
        const GridPhoton* photon;
        Rgb value;
        GlossyPart glossy;
        float luminance;
    };

    bool blocks(const VisiblePoint& point, const GridPhoton& photon, float radius) {
        ++counts_.rays;
        return occlusion_->blocks(point, photon, radius);
    }

    /// Asks for a few of the candidates, by what they bring.
    bool finds_blocked(const VisiblePoint& point, float radius) {
        double sum = 0;
        for (const Candidate& candidate : candidates_)
            sum += double(candidate.luminance);
        if (!(sum > 0)) return false;
        RandomStream random = occlusion_->numbers(point);
        const std::size_t asks = std::min<std::size_t>(occlusion_->some(), candidates_.size());
        for (std::size_t ask = 0; ask < asks; ++ask) {
            double left = double(random.next()) * sum;
            std::size_t chosen = 0;
            while (chosen + 1 < candidates_.size() &&
                   (left -= double(candidates_[chosen].luminance)) >= 0)
                ++chosen;
            if (blocks(point, *candidates_[chosen].photon, radius)) return true;
        }
        return false;
    }

    void drop_blocked(const VisiblePoint& point, std::size_t i, float radius) {
        double all = 0, reached = 0;
        const std::size_t before = candidates_.size();
        std::erase_if(candidates_, [&](const Candidate& candidate) {
            const auto square = double(candidate.luminance) * double(candidate.luminance);
            all += square;
            if (blocks(point, *candidate.photon, radius)) return true;
            reached += square;
            return false;
        });
        if (candidates_.size() < before) occlusion_->found(i);
        occlusion_->add_squares(i, all, reached);
    }

    void add(std::size_t i, const GridPhoton& photon, const Rgb& value, const GlossyPart& glossy,
             float radius) {
        const VisiblePoint& point = image_.visible_points[i];
        if (point.gloss.learns)
            glossy_.add(photon.direction, luminance(point.throughput * glossy.shared), glossy.pdf);
        sums_.add(photon.light_group, value);
        if (result_.wants_parts) {
            const ImagePart part =
                point.scatterings.scattered_in(static_cast<ImagePart>(photon.part));
            if (part != ImagePart::Indirect) parts_.add(std::uint32_t(part), value);
        }
        if (result_.wants_inner &&
            length_squared(photon.position - point.position) <= radius * radius / 2)
            inner_.add(0, value);
        const auto square = double(luminance(value) * luminance(value));
        squares_ += square;
        if (result_.wants_shareable && photon.shareable) {
            const auto shareable = double(luminance(value - glossy.counted));
            shareable_ += shareable;
            shareable_squares_ += shareable * shareable;
        }
        ++count_;
    }

    void move_to_result(std::size_t i) {
        if (image_.visible_points[i].gloss.learns) {
            glossy_.move_to(image_.visible_points[i].gloss.bounce_pdf, result_.glossy[i]);
        }
        sums_.move_to(&result_.flux[i * image_.groups]);
        result_.accepted[i] = saturated_sum(result_.accepted[i], count_);
        result_.squares[i] += float(squares_);
        if (result_.wants_parts) parts_.move_to(&result_.parts[i * kPhotonParts]);
        if (result_.wants_inner) inner_.move_to(&result_.inner[i]);
        if (result_.wants_shareable) {
            result_.shareable[i].sum += float(shareable_);
            result_.shareable[i].squares += float(shareable_squares_);
        }
        counts_.photons += count_;
    }

    const EyeImage& image_;
    const PhotonGrid& grid_;
    const GatherRadii& radii_;
    InvalidSampleFilter& filter_;
    PhotonFlux& result_;
    PhotonOcclusion* occlusion_;
    GroupSums sums_, parts_, inner_;
    std::uint32_t count_ = 0;
    double squares_ = 0, shareable_ = 0, shareable_squares_ = 0;
    std::vector<Candidate> candidates_;
    GlossyPhotons glossy_;
    GatherCounts counts_;
};

}  // namespace

void GlossyFlux::scale(float factor) {
    light *= factor;
    photons *= factor * factor;
    bounce *= factor * factor;
}

void PhotonFlux::scale(double factor) {
    const auto linear = float(factor), squared = float(factor * factor);
    const auto scale_light = [&](Rgb& sum) { sum = sum * linear; };
    for (std::vector<Rgb>* sums : {&flux, &parts, &inner})
        scale_each(*sums, scale_light);
    scale_each(squares, [&](float& square) { square *= squared; });
    scale_each(shareable, [&](ShareableFlux& part) {
        part = {float(part.sum * factor), float(part.squares * factor * factor)};
    });
    scale_each(glossy, [&](GlossyFlux& sums) { sums.scale(linear); });
    scale_each(probes, [&](ProbeSums& sums) { sums.scale(factor); });
}

bool on_same_surface(const VisiblePoint& point, Vec3 position, float agreement, float radius) {
    return std::abs(agreement) >= kMinNormalAgreement &&
           abs_dot(position - point.position, point.geometric_normal) <= kSlab * radius;
}

Rgb contribution(const VisiblePoint& point, const GridPhoton& photon, float radius,
                 GlossyPart* glossy) {
    if (photon.bounces > point.photon_bounces) return {};
    const float agreement = dot(photon.normal, point.geometric_normal);
    if (!on_same_surface(point, photon.position, agreement, radius)) return {};
    GlossyPart part;
    const Rgb value = reflected(point, photon, agreement > 0, part);
    if (glossy) *glossy = part;
    return part.counted +
           (photon.shareable && point.eye_share > 0 ? value * (1 - point.eye_share) : value);
}

void gather_photons(const EyeImage& image, const PhotonGrid& grid, const GatherRadii& radii,
                    InvalidSampleFilter& filter, PhotonFlux& result, PhotonOcclusion* occlusion) {
    std::atomic<std::uint64_t> photons{0}, rays{0};
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(image.owners.first(image.visible_points.size()),
                                        image.owners.last(image.visible_points.size()), 64),
        [&](const tbb::blocked_range<std::size_t>& range) {
            PointGather point(image, grid, radii, filter, result, occlusion);
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                point.gather(i);
            photons.fetch_add(point.counts().photons, std::memory_order_relaxed);
            rays.fetch_add(point.counts().rays, std::memory_order_relaxed);
        });
    result.counts.photons += photons.load();
    result.counts.rays += rays.load();
}

void exchange_flux(const EyeImage& image, const GatherCounts& before, SharedWork& work,
                   PhotonFlux& flux, PhotonOcclusion* occlusion) {
    const GatherCounts own{flux.counts.photons - before.photons, flux.counts.rays - before.rays};
    work.exchange([&](std::uint32_t rank, StateArchive& archive) {
        plain_of_points(archive, image.owners, rank, flux.flux, image.groups);
        plain_of_points(archive, image.owners, rank, flux.accepted);
        plain_of_points(archive, image.owners, rank, flux.squares);
        plain_of_points(archive, image.owners, rank, flux.shareable);
        plain_of_points(archive, image.owners, rank, flux.glossy);
        plain_of_points(archive, image.owners, rank, flux.parts, kPhotonParts);
        plain_of_points(archive, image.owners, rank, flux.inner);
        if (occlusion) occlusion->exchange(rank, archive, image.owners);
        GatherCounts of_rank = own;
        archive.value(of_rank.photons);
        archive.value(of_rank.rays);
        if (!archive.restoring()) return;
        flux.counts.photons += of_rank.photons;
        flux.counts.rays += of_rank.rays;
    });
}

}  // namespace aips
