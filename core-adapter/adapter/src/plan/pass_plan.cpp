// The search for the shares and the photon paths of least error times cost.
#include "plan/pass_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "aips/core/base/constants.h"
#include "plan/constants.h"

namespace aips {
namespace {

/// Least variance of continued paths over their second moment: few samples, or a noisy mean of X Y,
/// may say less.
constexpr double kLeastEyeVariance = 0.05;

/// What is certain to be left of the measured variance by eye paths up to their visible points.
constexpr double kLeastEyeNoise = 0.02;

/// Most of the eye's variance that BSDF-sampled rays are taken to save.
constexpr double kMostSaved = 0.9;

/// Steps of a root of two by which fewer photon paths a pass are tried.
constexpr int kStepsOfFewerPhotons = 10;

/// The same for more (steps).
constexpr int kStepsOfMorePhotons = 4;

/// Of so many photons in media a beam takes one at most: with fewer a render's first passes know
/// too little of bright ones.
constexpr std::uint32_t kMostThinning = 64;

/// Photons of chains that come together at most, in what is foretold.
constexpr double kMostClusteredPhotons = 64;

/// A leaf's contribution to E and C.
struct LeafTerms {
    double photons = 0;  // V: relative variance times photon paths, times all its weight
    double lost = 0;     // squared, of light that photons lose, in as many passes as there will be
    double eye = 0;      // W
    double cost = 0;     // of its continued paths in a pass
    double bsdf_direct_cost = 0;  // if their BSDF-sampled rays alone are sent
    double direct = 0;            // variance of direct light that goes with these
    bool shares_direct = false;   // it is gone already
    std::size_t leaf = 0;
};

double mean(double sum, double count) {
    return count > 0 ? sum / count : 0;
}

/// How much of what one of both brought the other missed, with certainty: light that it seldom
/// meets, so that its own squares do not tell how seldom. A luminance times the root of a weight.
double missing(double found, double met, const ShareMoments& m) {
    const double chance = kSureErrors * std::sqrt(m.xx + m.yy);
    return mean(std::max(0.0, kSeldomMet * found - met - chance), m.continued);
}

double eye_variance(const ShareMoments& m) {
    // Effective paths that found light: where there are none, their variance is not known at all.
    // One is enough where photons found nothing.
    if (!(m.yy > 0) || (m.squares > 0 && m.y * m.y < kFoundByPaths * m.yy))
        return std::numeric_limits<double>::infinity();
    const double second = mean(m.yy, m.continued);
    const double variance = second - std::max(0.0, mean(m.xy, m.continued));
    const double missed = missing(m.x, m.y, m);
    return std::max({variance, kLeastEyeVariance * second, m.continued * missed * missed});
}

double joined(double photons, double eye) {
    if (!(photons > 0)) return 0;
    return std::isfinite(eye) ? photons * eye / (photons + eye) : photons;
}

class Search {
  public:
    explicit Search(const PlanFacts& facts) : facts_(facts) {
        double population = 0, spread = 0, squares = 0;
        for (const ShareMoments& leaf : facts.leaves) {
            population += leaf.population;
            spread += leaf.population * mean(leaf.spread, leaf.continued);
            squares += leaf.population * mean(leaf.squares, leaf.points);
        }
        if (!facts.independent && squares > 0)
            clusters_ = std::clamp(spread / squares, 1.0, kMostClusteredPhotons);
        lost_ = lost_light();
        own_ = facts.photon_path_variance * facts.squared_error;
        if (facts.photon_paths > 0)
            present_ = (facts.photon_path_variance + facts.thinned_variance) / facts.photon_paths;
        for (std::size_t i = 0; i < facts.leaves.size(); ++i) {
            if (population > 0) add_leaf(i, facts.leaves[i].population / population);
        }
        const double eye = std::max(
            {facts.variance - present_, facts.own_variance, kLeastEyeNoise * facts.variance});
        bound_savings(kMostSaved * eye);
        eye_ = kStratifiedEye * (eye + saved_);
    }

    PassPlan best(const PhotonLimits& limits) const {
        const double present = facts_.photon_paths / facts_.turns;
        PassPlan best = with(std::clamp(present, limits.fewest, limits.most));
        thin(best);
        double least = std::numeric_limits<double>::infinity();
        for (int step = -kStepsOfFewerPhotons; step <= kStepsOfMorePhotons; ++step) {
            const double paths =
                std::clamp(present * std::exp2(0.5 * step), limits.fewest, limits.most);
            if (step > 0 && paths * facts_.photon_path_cost > kGreatestRatio * facts_.eye_cost)
                continue;
            PassPlan plan = with(paths);
            take_turns(plan, limits);
            thin(plan);
            if (plan.error * plan.cost < least) {
                least = plan.error * plan.cost;
                best = plan;
            }
        }
        return best;
    }

    /// Where eye paths bring what photons lose at edges. Let photons lose a share m of the light L
    /// of a point. To bring it by eye paths takes m of them, whose squares add m E[Y^2] to the
    /// error, and saves (m L)^2 in as many passes as there will be, M. E C falls by all points
    /// with
    ///     M m^2 L^2 > m (E[Y^2] + E / C cost of a path).
    void fill(PassPlan& plan) const {
        const double error_of_cost = mean(plan.error, plan.cost) / facts_.point_weight;
        for (std::size_t i = 0; i < facts_.leaves.size(); ++i) {
            const ShareMoments& m = facts_.leaves[i];
            const double light = std::max(0.0, mean(m.xy, m.continued));
            const double eye = eye_variance(m);
            const double cost = facts_.ray_cost * mean(m.rays, m.continued) * error_of_cost;
            const double from = (eye + light + cost) / (facts_.passes_until * light);
            if (from < 1) plan.shares[i].fills_from = float(from);
        }
    }

  private:
    /// Share of the light that photons bring too little of, as radii reach over edges and into
    /// shadows, or as chains have not found it: what continued paths bring more, beyond chance.
    double lost_light() const {
        double photons = 0, eye = 0, variance = 0;
        for (const ShareMoments& m : facts_.leaves) {
            if (!(m.continued > 0)) continue;
            // Not less the square of the mean: a single bright path then says one standard error.
            const double square = mean(m.xx + m.yy - 2 * m.xy, m.continued);
            photons += m.population * mean(m.x, m.continued);
            eye += m.population * mean(m.y, m.continued);
            variance += sq(m.population) * std::max(0.0, square) / m.continued;
        }
        const double lost = eye - photons;
        return lost > kSureErrors * std::sqrt(variance) ? lost / eye : 0;
    }

    /// How much of the light of one leaf photons miss, beyond chance: where surfaces are smaller
    /// than the radius they lose far more than elsewhere. Not what they bring too much: light that
    /// paths seldom meet looks the same.
    static double bias_of(const ShareMoments& m) {
        if (!(m.continued > 0)) return 0;
        const double square = std::max(0.0, mean(m.xx + m.yy - 2 * m.xy, m.continued));
        const double difference = (m.y - m.x) / m.continued;
        return std::max(0.0, difference - kSureErrors * std::sqrt(square / m.continued));
    }

    /// Variance of a single photon path's contribution of light that both carry, `eye` being that
    /// of eye paths. What is seldom found at all is found together by a whole pass.
    double photon_variance(const ShareMoments& m, double eye) const {
        // No photon came: their variance is not known at all, and the eye is to carry all it may.
        if (!(m.squares > 0) && m.yy > 0)
            return facts_.photon_paths * eye / (1 - double(kMostEyeShare));
        const double missed = missing(m.y, m.x, m);
        return std::max(clusters_ * mean(m.squares, m.points),
                        facts_.photon_paths * facts_.passes * missed * missed);
    }

    /// The best number of passes of which one shoots the photons of all.
    void take_turns(PassPlan& plan, const PhotonLimits& limits) const {
        const double error = plan.error, cost = plan.cost;
        double least = std::numeric_limits<double>::infinity();
        for (std::uint32_t turns = 1;
             turns <= limits.turns && plan.photon_paths * turns <= limits.most_shot; turns *= 2) {
            const double e = error + (turns - 1) * facts_.photon_square;
            const double c = cost - facts_.shooting_cost * (1 - 1.0 / turns);
            if (e * c >= least) continue;
            least = e * c;
            plan.turns = turns;
            plan.error = e;
            plan.cost = c;
        }
    }

    /// How many photons in media a beam leaves out: each doubling is worth it as long as E C falls.
    void thin(PassPlan& plan) const {
        const double variance = facts_.beam_path_variance / plan.photon_paths;
        double gathering = facts_.beam_path_cost * plan.photon_paths;
        plan.error += variance;
        plan.cost += gathering;
        if (!(gathering > 0)) return;
        while (plan.thinning < kMostThinning) {
            const double e = plan.error + variance * plan.thinning;
            const double c = plan.cost - gathering / 2;
            if (e * c >= plan.error * plan.cost) return;
            plan.error = e;
            plan.cost = c;
            plan.thinning *= 2;
            gathering /= 2;
        }
    }

    /// Estimates of what direct light would gain may exceed what is there. What it has gained
    /// already is bounded by nothing: without it there would be as much more.
    void bound_savings(double most) {
        double all = 0;
        for (const LeafTerms& t : terms_)
            all += t.shares_direct ? 0 : t.direct;
        const double factor = all > most ? std::max(0.0, most) / all : 1;
        for (LeafTerms& t : terms_)
            t.direct *= kStratifiedEye * (t.shares_direct ? 1 : factor);
    }

    void add_leaf(std::size_t i, double population) {
        const ShareMoments& m = facts_.leaves[i];
        const double points = population * facts_.points;
        const double weight = points * facts_.point_weight;
        const double eye = eye_variance(m);
        const double photons = photon_variance(m, eye);
        const double own = clusters_ * mean(m.others, m.points);
        const EyeShare& now = facts_.shares[i];
        const auto share = double(now.share);
        const double n = facts_.photon_paths;
        if (n > 0) present_ += weight * (sq(1 - share) * photons + own) / n;
        if (share > 0 && std::isfinite(eye)) present_ += weight * sq(share) * eye;
        const double direct = weight * std::max(0.0, mean(m.direct_saved, m.continued));
        if (now.any()) saved_ += direct;
        own_ += weight * own * facts_.squared_error;
        const double lost =
            std::max(sq(lost_) * std::max(0.0, mean(m.xy, m.continued)), sq(bias_of(m)));
        const double ray_cost = points * facts_.ray_cost;
        terms_.push_back({.photons = weight * photons * facts_.squared_error,
                          .lost = facts_.counts_loss ? weight * facts_.points_per_pixel *
                                                           facts_.passes_until * lost
                                                     : 0,
                          .eye = weight * kStratifiedPaths * eye,
                          .cost = ray_cost * mean(m.rays, m.continued),
                          .bsdf_direct_cost = ray_cost,
                          .direct = direct,
                          .shares_direct = now.any(),
                          .leaf = i});
    }

    /// What a leaf's eye paths could do more, and what that saves and costs.
    struct Gain {
        double error = 0, cost = 0;
        const LeafTerms* terms = nullptr;
        bool bsdf_direct = false;
    };

    /// All at once, or BSDF-sampled direct light and then the rest: where the rest saves less for
    /// its cost.
    static void add_gains(const LeafTerms& t, double photons, std::vector<Gain>& gains) {
        const double shared = photons - joined(photons, t.eye);
        const double gain = shared + t.direct;
        if (!(gain > 0 && t.cost > 0 && std::isfinite(gain))) return;
        const double rest = t.cost - t.bsdf_direct_cost;
        if (rest > 0 && shared * t.bsdf_direct_cost < t.direct * rest) {
            gains.push_back({t.direct, t.bsdf_direct_cost, &t, true});
            if (shared > 0) gains.push_back({shared, rest, &t});
        } else {
            gains.push_back({gain, t.cost, &t});
        }
    }

    /// The best leaves for so many photon paths: those first whose paths save most for their cost.
    PassPlan with(double paths) const {
        std::vector<Gain> gains;
        PassPlan plan;
        plan.photon_paths = paths;
        plan.shares.assign(facts_.leaves.size(), {});
        plan.error = eye_ + own_ / paths;
        plan.cost = facts_.eye_cost + facts_.photon_path_cost * paths;
        const auto of_photons = [&](const LeafTerms& t) { return t.photons / paths + t.lost; };
        for (const LeafTerms& t : terms_) {
            plan.error += of_photons(t);
            add_gains(t, of_photons(t), gains);
        }
        // Of a leaf BSDF-sampled direct light comes first: it saves more for its cost.
        std::ranges::stable_sort(gains, [](const Gain& a, const Gain& b) {
            return a.error * b.cost > b.error * a.cost;
        });
        for (const Gain& g : gains) {
            if ((plan.error - g.error) * (plan.cost + g.cost) >= plan.error * plan.cost) break;
            plan.error -= g.error;
            plan.cost += g.cost;
            plan.shares[g.terms->leaf] =
                g.bsdf_direct ? EyeShare{.bsdf_direct = true}
                              : EyeShare{.share = share(of_photons(*g.terms), g.terms->eye)};
        }
        return plan;
    }

    /// Of the eye, where it goes on, for direct light's sake at least.
    static float share(double photons, double eye) {
        const double part = photons > 0 ? photons / (photons + eye) : 0;
        return float(std::clamp(part, kLeastEyeShare, kMostEyeShare));
    }

    static double sq(double x) { return x * x; }

    const PlanFacts& facts_;
    std::vector<LeafTerms> terms_;
    double clusters_ = 1;  // photons that come together as one
    double lost_ = 0;      // share of the light that photons lose
    double own_ = 0;       // K
    double eye_ = 0;       // A
    double present_ = 0;   // variance of photons and continued paths as they were
    double saved_ = 0;     // variance that direct light did not have, as some went on
};

}  // namespace

void PlanFacts::state(StateArchive& archive) {
    leaves.resize(archive.count(leaves.size(), sizeof(ShareMoments)));
    for (ShareMoments& leaf : leaves)
        leaf.state(archive);
    shares.resize(leaves.size());
    for (EyeShare& eye : shares) {
        archive.value(eye.share);
        archive.value(eye.bsdf_direct);
        archive.value(eye.fills_from);
    }
    for (double* fact :
         {&passes, &passes_until, &points, &point_weight, &points_per_pixel, &variance,
          &own_variance, &photon_path_variance, &beam_path_variance, &thinned_variance,
          &photon_paths, &eye_cost, &shooting_cost, &photon_square, &photon_path_cost,
          &beam_path_cost, &ray_cost, &squared_error})
        archive.value(*fact);
    for (bool* fact : {&counts_loss, &independent})
        archive.value(*fact);
    archive.value(turns);
}

PassPlan plan_passes(const PlanFacts& facts, const PhotonLimits& limits) {
    const Search search(facts);
    PassPlan plan = search.best(limits);
    search.fill(plan);
    double all = 0, sum = 0;
    for (std::size_t i = 0; i < facts.leaves.size(); ++i) {
        const double population = facts.leaves[i].population;
        all += population;
        if (plan.shares[i].share > 0) plan.going_on += population;
        if (plan.shares[i].bsdf_direct) plan.bsdf_direct += population;
        sum += population * double(plan.shares[i].share);
    }
    plan.point_price =
        mean(plan.error, plan.cost) * mean(facts.shooting_cost, facts.points) / facts.point_weight;
    plan.eye_share = mean(sum, plan.going_on);
    plan.going_on = mean(plan.going_on, all);
    plan.bsdf_direct = mean(plan.bsdf_direct, all);
    return plan;
}

std::string describe(const PassPlan& plan) {
    const auto percent = [](double share) { return std::to_string(std::lround(100 * share)); };
    const std::string photons =
        std::to_string(std::llround(plan.photon_paths)) + " photon paths a pass";
    const std::string rays = plan.bsdf_direct > 0 ? "; from " + percent(plan.bsdf_direct) +
                                                        " % a ray goes out for direct light alone"
                                                  : "";
    if (!(plan.going_on > 0)) {
        return "photons carry all indirect light to surfaces that take them" + rays + "; " +
               photons;
    }
    return "eye paths go on from " + percent(plan.going_on) +
           " % of the surfaces seen that take photons, and carry " + percent(plan.eye_share) +
           " % of the light there that both can" + rays + "; " + photons;
}

}  // namespace aips
