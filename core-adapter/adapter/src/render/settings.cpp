// Checks and description of the engine's settings.
#include "aips/adapter/settings.h"

#include <locale>
#include <sstream>
#include <stdexcept>

namespace aips {

void validate(const Settings& s) {
    if (!(s.guide_share >= 0 && s.guide_share < 1)) {
        throw std::invalid_argument(
            "guideshare must be in [0, 1): without a share of BSDF sampling the guide could miss "
            "directions that carry light");
    }
    if (!(s.alpha > 0 && s.alpha <= 1)) throw std::invalid_argument("alpha must be in (0, 1]");
    if (!(s.error_alpha >= 0 && s.error_alpha < 1)) {
        throw std::invalid_argument("erroralpha must be in [0, 1)");
    }
    if (s.photon_sampler == PhotonSampler::AdaptiveChains && s.guide != GuideKind::None) {
        throw std::invalid_argument("photonsampler amc needs guide none");
    }
    if (s.cdf_resolution == 0) throw std::invalid_argument("cdfresolution must be at least 1");
}

namespace {

const char* name(Mode mode) {
    switch (mode) {
        case Mode::Progressive:
            return "progressive";
        case Mode::PhotonMap:
            return "photonmap";
        case Mode::Ppm:
            return "ppm";
    }
    return "";
}

const char* name(GuideKind guide) {
    switch (guide) {
        case GuideKind::None:
            return "none";
        case GuideKind::Paper:
            return "paper";
        case GuideKind::Adaptive:
            return "adaptive";
    }
    return "";
}

const char* name(CriterionKind criterion) {
    switch (criterion) {
        case CriterionKind::Paper:
            return "paper";
        case CriterionKind::Image:
            return "image";
    }
    return "";
}

const char* name(NeighbourKind neighbours) {
    switch (neighbours) {
        case NeighbourKind::Reached:
            return "reached";
        case NeighbourKind::Last:
            return "last";
        case NeighbourKind::Both:
            return "both";
    }
    return "";
}

/// Landings that shadow rays own are all first landings, and only the paper's criterion learns from
/// them: the other one goes by the image, to which they bring nothing.
bool uses_first_landings(const Settings& s) {
    return s.first_landings && s.direct_light_sampling && s.error_criterion == CriterionKind::Paper;
}

}  // namespace

std::string describe(const Settings& s) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    const auto depth = [](std::uint32_t asked) {
        return asked ? std::to_string(asked) : std::string("automatic");
    };
    out << "mode = " << name(s.mode) << ", guide = " << name(s.guide)
        << ", maxeyedepth = " << depth(s.max_eye_depth)
        << ", maxphotondepth = " << depth(s.max_photon_depth);
    if (s.max_bounces != kAnyBounces) out << ", maxdepth = " << s.max_bounces << " bounces";
    if (s.photons_per_pass) {
        out << ", photonperpass = " << s.photons_per_pass << " paths";
    } else {
        out << ", photonperpass = automatic";
    }
    if (s.hit_points_per_pass) out << ", hitpointperpass = " << s.hit_points_per_pass;
    if (s.start_radius > 0) {
        out << ", startradius = " << s.start_radius << " pixel footprints";
    } else {
        out << ", startradius = automatic";
    }
    if (adapts_radius(s)) out << ", radius = adaptive";
    if (adapts_radius(s) && !s.narrow_radii) out << ", narrowradii = false";
    out << ", alpha = " << s.alpha << ", seed = " << s.seed;
    if (s.photon_sampler == PhotonSampler::AdaptiveChains) out << ", photonsampler = amc";
    if (s.debug_layers) out << ", debuglayers = true";
    if (!s.learn_lights) out << ", learnlights = false";
    if (!s.continue_eye_paths) out << ", continueeyepaths = false";
    if (!s.photon_turns) out << ", photonturns = false";
    if (!s.guide_lamps) out << ", guidelamps = false";
    if (!s.correct_edges) out << ", correctedges = false";
    if (!s.photon_occlusion) out << ", photonocclusion = false";
    if (s.guide == GuideKind::Paper) {
        out << ", guideshare = " << s.guide_share << ", iterationphotons = " << s.iteration_photons
            << " paths, nodephotons = " << s.node_photons << ", treedepth = " << s.tree_depth
            << ", maxnodes = " << s.max_nodes << ", cdfresolution = " << s.cdf_resolution << "x"
            << s.cdf_resolution << ", erroralpha = " << s.error_alpha
            << ", errorcriterion = " << name(s.error_criterion)
            << ", neighbours = " << name(s.neighbours)
            << ", presenterrors = " << (s.present_errors ? "true" : "false")
            << ", firstlandings = " << (uses_first_landings(s) ? "true" : "false");
    }
    if (s.guide == GuideKind::Adaptive) {
        out << ", guideemission = " << (s.guide_emission ? "true" : "false")
            << ", eyeseeding = " << (s.eye_seeding ? "true" : "false")
            << ", guidebounces = " << (s.guide_bounces ? "true" : "false")
            << ", guidesurvival = " << (s.guide_survival ? "true" : "false")
            << ", guidechains = " << (s.guide_chains ? "true" : "false")
            << ", guidescout = " << (s.guide_scout ? "true" : "false");
    }
    return out.str();
}

}  // namespace aips
