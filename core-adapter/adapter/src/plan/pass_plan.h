// The one planner: how many photons each pass shoots, which passes shoot, and who carries the light
// that both eye paths and photons can. One decision, from counted costs and measured moments.
//
// With N photon paths a pass leaves, as a mean over pixels of relative variances,
//     E = A + K / N + sum over leaves of e,   e = P, or 1 / (1 / P + 1 / W),   P = V / N + M B^2
// where A is what eye paths leave up to their visible points, K the light that photons alone carry
// (all that they carry, where eye paths do not go on), V and W what photons and continued eye paths
// leave of the rest, B what photons lose of it by their radii, which is there in full after M
// passes. A is less by what direct light gains where BSDF-sampled rays share it with shadow rays.
// It costs
//     C = eye + photons N + what the BSDF-sampled rays or continued paths of the leaves cost.
// The leaves whose eye paths send a BSDF-sampled ray or go on, and N, are chosen so that E C is
// least: of an image that is a mean over passes that is the error at a given time. If one of k
// passes shoots for all of them, E is greater by (k - 1) S and C less by F (1 - 1 / k): S is the
// square of what photons bring (an upper bound, as that evens out over k passes), F what shooting
// costs in itself. If beams in media take one of m photons, E is greater by (m - 1) B / N and C
// less by G N (1 - 1 / m): B is the variance of what a photon path brings to them, G what it costs
// to gather it there.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "aips/core/tables/share_table.h"

namespace aips {

/// Share of the eye where paths go on for the sake of direct light alone: squares of the light
/// that both carry count a millionth.
inline constexpr double kLeastEyeShare = 0x1p-10;

/// Bounds of the photon paths of a pass.
struct PhotonLimits {
    double fewest = 0, most = 0;
    std::uint32_t turns = 1;  ///< most passes of which one shoots
    double most_shot = std::numeric_limits<double>::infinity();  ///< by it
};

/// What passes told since the last decision: all that the plan depends on.
struct PlanFacts {
    std::vector<ShareMoments> leaves;  ///< ShareTable::moments(); none where eye paths do not go on
    std::vector<EyeShare> shares;      ///< [leaf]: in those passes
    double passes = 1;                 ///< so many
    double passes_until = 1;           ///< of the render, when the next decision comes; > 0
    bool counts_loss = false;          ///< whether it is known what photons lose
    double points = 0;                 ///< visible points in one of them
    double point_weight = 0;           ///< of one visible point's variance in the mean over pixels
    double points_per_pixel = 1;       ///< in a pass: what they all lose does not average out
    double variance = 0;  ///< mean over pixels of the relative variance in a pass, all in all
    /// The same of what eye paths bring by themselves; 0: not known.
    double own_variance = 0;
    /// The same of a single photon path, of light that no leaf knows.
    double photon_path_variance = 0;
    /// The same of what it brings to beams in media, if they took all photons there, and as they
    /// took them.
    double beam_path_variance = 0, thinned_variance = 0;
    double photon_paths = 0;   ///< in a pass that shoots
    std::uint32_t turns = 1;   ///< passes of which one does
    double eye_cost = 0;       ///< of a pass, without continued paths
    double shooting_cost = 0;  ///< part of it that passes without photons do not have
    /// Mean over pixels of the squared relative share of the image that photons brought.
    double photon_square = 0;
    double photon_path_cost = 0;  ///< of one, but for media
    double beam_path_cost = 0;    ///< of gathering all that one leaves in media
    double ray_cost = 0;          ///< of a continued path's ray
    bool independent = true;      ///< squares of single photons tell their variance
    double squared_error = 1;     ///< of photons, their bias included, over their variance

    /// Saves them, or restores them into new ones: a decision can be made again elsewhere.
    void state(StateArchive& archive);
};

struct PassPlan {
    std::vector<EyeShare> shares;  ///< [leaf]
    double photon_paths = 0;       ///< of a pass, as a mean over those that shoot and others
    std::uint32_t turns = 1;       ///< passes of which one shoots for all
    std::uint32_t thinning = 1;    ///< of so many photons in media a beam takes one
    double error = 0, cost = 0;    ///< E and C
    double going_on = 0;           ///< share of the visible points whose eye paths go on
    double bsdf_direct = 0;        ///< share of them that send a BSDF-sampled ray alone
    double eye_share = 0;          ///< mean over those of the eye's share
    /// Weighed variance that another visible point has to save to be worth gathering photons for.
    double point_price = 0;
};

/// One sentence for the log: who carries what.
std::string describe(const PassPlan& plan);

/// Deterministic. Without use for the eye all shares are 0.
PassPlan plan_passes(const PlanFacts& facts, const PhotonLimits& limits);

}  // namespace aips
