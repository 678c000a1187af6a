// Learning how eye paths and photons share light.
#include "aips/core/tables/share_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace aips {
namespace {

/// What the halves of a leaf keep of what it knew at most: of its points, and, apart from that, of
/// those from which eye paths went on (visible points).
constexpr double kInheritedPoints = 256;

/// Of samples that are left out.
constexpr std::uint32_t kNoBranch = std::numeric_limits<std::uint32_t>::max();

bool usable(const ShareSample& s) {
    const auto amount = [](double x) { return x >= 0 && std::isfinite(x); };
    return amount(s.weight) && amount(s.photons) && amount(s.squares) && amount(s.others) &&
           amount(s.eye) && amount(s.filled) && amount(s.rays) && amount(s.photon_paths) &&
           std::isfinite(s.weight * s.photons * s.photons * s.photon_paths) &&
           std::isfinite(s.weight * s.squares) && std::isfinite(s.weight * s.others) &&
           std::isfinite(s.weight * s.eye * s.eye) && std::isfinite(s.weight * s.direct_saved);
}

/// Its score: where errors may come from, whichever way light is carried there.
VertexScore vertex_of(const ShareSample& s) {
    return {s.position, s.normal, s.weight * (s.photons * s.photons + s.eye * s.eye), 1};
}

ShareMoments moments_of(const ShareSample& s) {
    ShareMoments m;
    m.population = m.points = 1;
    m.squares = s.weight * s.squares;
    m.others = s.weight * s.others;
    if (!s.continued) return m;
    const double root = std::sqrt(s.weight);
    m.continued = 1;
    m.xx = s.weight * s.photons * s.photons;
    m.xy = s.weight * s.photons * s.eye;
    m.spread = s.weight * s.photons * (s.photons - s.eye) * s.photon_paths;
    m.yy = s.weight * s.eye * s.eye;
    m.x = root * (s.photons + s.filled);
    m.y = root * s.eye;
    m.rays = s.rays;
    m.direct_saved = s.weight * s.direct_saved;
    return m;
}

}  // namespace

void ShareMoments::add(const ShareMoments& o) {
    population += o.population;
    points += o.points;
    squares += o.squares;
    others += o.others;
    continued += o.continued;
    xx += o.xx;
    xy += o.xy;
    yy += o.yy;
    spread += o.spread;
    x += o.x;
    y += o.y;
    rays += o.rays;
    direct_saved += o.direct_saved;
}

void ShareMoments::scale_points(double factor) {
    for (double* sum : {&population, &points, &squares, &others})
        *sum *= factor;
}

void ShareMoments::scale_continued(double factor) {
    for (double* sum : {&continued, &xx, &xy, &yy, &spread, &x, &y, &rays, &direct_saved})
        *sum *= factor;
}

void ShareMoments::scale(double factor) {
    scale_points(factor);
    scale_continued(factor);
}

void ShareMoments::state(StateArchive& archive) {
    for (double* sum :
         {&population, &points, &squares, &others, &continued, &xx, &xy, &yy, &x, &y, &rays})
        archive.amount(*sum);
    for (double* sum : {&spread, &direct_saved}) {
        archive.value(*sum);
        StateArchive::check(std::isfinite(*sum), "a sum that is no number");
    }
}

ShareTable::ShareTable(const Bounds& scene, const ShareTableSettings& settings)
    : settings_(settings), places_(scene, settings.places) {
    if (!(settings.prior_count > 0))
        throw std::invalid_argument("ShareTable: prior_count must be > 0");
    leaves_.reserve(settings.places.max_leaves);
    shares_.reserve(settings.places.max_leaves);
    add_leaves();
}

bool ShareTable::add(const ShareSample& s) {
    const std::uint32_t branch = branch_of(s);
    if (branch == kNoBranch) return false;
    places_.add_at(branch, vertex_of(s));
    leaves_[places_.leaf_of(branch)].add(moments_of(s));
    everywhere_.add(moments_of(s));
    return true;
}

/// What the samples of a group tell.
struct ShareTable::Group {
    /// Of one leaf.
    struct Part {
        ScoreCache::Sums places;
        ShareMoments moments;
    };
    std::vector<std::uint32_t> branches;  // each once, in the order of its first sample
    std::vector<Part> parts;              // of these
    ShareMoments sum;
};

ShareTable::Group ShareTable::group_of(std::span<const ShareSample> samples) const {
    Group group;
    std::vector<std::uint32_t> part_of(places_.branch_end(), kNoBranch);  // [branch]
    for (const ShareSample& s : samples) {
        const std::uint32_t branch = branch_of(s);
        if (branch == kNoBranch) continue;
        if (part_of[branch] == kNoBranch) {
            part_of[branch] = std::uint32_t(group.parts.size());
            group.branches.push_back(branch);
            group.parts.emplace_back();
        }
        Group::Part& part = group.parts[part_of[branch]];
        places_.add_to(part.places, branch, vertex_of(s));
        part.moments.add(moments_of(s));
    }
    for (const Group::Part& part : group.parts)
        group.sum.add(part.moments);
    return group;
}

void ShareTable::add(std::span<const std::vector<ShareSample>> samples,
                     const ParallelFor& parallel) {
    constexpr std::uint32_t kJobs = 64;
    std::vector<Group> groups(samples.size());
    parallel(std::uint32_t(samples.size()),
             [&](std::uint32_t g) { groups[g] = group_of(samples[g]); });
    // Every job looks at all branches and takes its part of them.
    parallel(kJobs, [&](std::uint32_t job) {
        for (const Group& group : groups) {
            for (std::size_t i = 0; i < group.branches.size(); ++i) {
                const std::uint32_t branch = group.branches[i];
                if (branch % kJobs != job) continue;
                places_.add_at(branch, group.parts[i].places);
                leaves_[places_.leaf_of(branch)].add(group.parts[i].moments);
            }
        }
    });
    for (const Group& group : groups)
        everywhere_.add(group.sum);
}

std::uint32_t ShareTable::branch_of(const ShareSample& s) const {
    if (!usable(s) || !ScoreCache::usable(vertex_of(s))) return kNoBranch;
    return places_.branch_at(s.position, s.normal);
}

void ShareTable::update(std::size_t samples) {
    places_.update(double(samples));
    add_leaves();
}

// Both halves of a leaf start with what it knew, weighing less than what they will meet. Of eye
// paths that went on they keep more: where one in many does, a share of what the leaf knew of them
// would be too little to judge by, split after split.
void ShareTable::add_leaves() {
    for (auto i = std::uint32_t(leaves_.size()); i < places_.leaf_count(); ++i) {
        const std::uint32_t parent = places_.parent_of(i);
        if (parent == i) {
            leaves_.emplace_back();
            shares_.emplace_back();
            continue;
        }
        ShareMoments& from = leaves_[parent];
        const double half = from.population / 2;
        from.scale_points(std::min(0.5, kInheritedPoints / std::max(from.points, 1.0)));
        from.scale_continued(std::min(1.0, kInheritedPoints / std::max(from.continued, 1.0)));
        from.population = half;
        leaves_.push_back(from);
        shares_.push_back(shares_[parent]);
    }
}

std::vector<ShareMoments> ShareTable::moments() const {
    std::vector<ShareMoments> result(leaves_);
    if (!(everywhere_.points > 0)) return result;
    ShareMoments prior = everywhere_;
    prior.population = 0;
    prior.scale(std::min(1.0, settings_.prior_count / everywhere_.points));
    for (ShareMoments& leaf : result)
        leaf.add(prior);
    return result;
}

void ShareTable::forget(double factor) {
    everywhere_.scale(factor);
    for (ShareMoments& leaf : leaves_)
        leaf.scale(factor);
}

void ShareTable::fade(double points) {
    places_.fade(points);
    if (everywhere_.points > points) forget(points / everywhere_.points);
}

void ShareTable::set_shares(std::span<const EyeShare> shares) {
    if (shares.size() != shares_.size())
        throw std::invalid_argument("ShareTable: not a share for each leaf");
    shares_.assign(shares.begin(), shares.end());
}

void ShareTable::state(StateArchive& archive) {
    places_.state(archive);
    if (archive.restoring()) {
        leaves_.assign(places_.leaf_count(), {});
        shares_.assign(places_.leaf_count(), {});
    }
    everywhere_.state(archive);
    for (ShareMoments& leaf : leaves_)
        leaf.state(archive);
    for (EyeShare& eye : shares_) {
        archive.value(eye.share);
        archive.value(eye.bsdf_direct);
        archive.value(eye.fills_from);
        StateArchive::check(eye.share >= 0 && eye.share < 1 && eye.fills_from > 0,
                            "a share of light that is none");
    }
}

std::size_t ShareTable::memory_bytes() const {
    return places_.memory_bytes() + leaves_.capacity() * sizeof(ShareMoments) +
           shares_.capacity() * sizeof(EyeShare);
}

std::size_t ShareTable::memory_bound_bytes(const ShareTableSettings& settings) {
    // moments() makes a copy for as long as shares are chosen.
    return ScoreCache::memory_bound_bytes(settings.places) +
           settings.places.max_leaves * (2 * sizeof(ShareMoments) + 2 * sizeof(EyeShare));
}

}  // namespace aips
