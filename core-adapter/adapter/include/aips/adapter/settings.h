// The engine's settings, with their defaults.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace aips {

enum class Mode : std::uint8_t {
    Progressive,  ///< new eye paths in every pass, shrinking radius (Knaus & Zwicker 2011)
    PhotonMap,    ///< one eye pass, frozen; fixed radius (Jensen 1996)
    Ppm  ///< one eye pass, frozen; a radius per visible point (Hachisuka, Ogaki & Jensen 2008)
};

/// Whether all passes see the visible points of one eye pass.
constexpr bool freezes_eye_pass(Mode mode) {
    return mode != Mode::Progressive;
}

/// How the gather radius goes on in mode=progressive.
enum class RadiusKind : std::uint8_t {
    Automatic,  ///< Adaptive, unless the settings ask for a schedule of their own: adapts_radius()
    Schedule,   ///< one for all visible points, by the photons shot (Knaus & Zwicker 2011)
    Adaptive    ///< by noise and bias around each pixel (Kaplanyan & Dachsbacher 2013)
};

enum class GuideKind : std::uint8_t {
    None,     ///< plain photon shooting
    Paper,    ///< Liu & Zheng 2014
    Adaptive  ///< by what photons contribute to the image: docs/understand/guides.md
};

/// What guide=paper takes for a node's error.
enum class CriterionKind : std::uint8_t {
    Paper,  ///< noise and bias of the photons' density (eq. 2 to 4)
    Image   ///< what its photons contribute to the image
};

/// Which node guide=paper tells of the other, of two between which a photon flew.
enum class NeighbourKind : std::uint8_t {
    Reached,  ///< the one that it left: where its photons go is its neighbour
    Last,     ///< the one where it landed: where its photons were last (the paper's words)
    Both
};

/// Where the random numbers of unguided photon paths come from.
enum class PhotonSampler : std::uint8_t {
    Sequence,       ///< emission from an Owen-scrambled Sobol' sequence
    AdaptiveChains  ///< Markov chains on the visible paths (Hachisuka & Jensen 2011)
};

/// Photon paths a pass of LuxRender's sppm, and wherever they do not follow the noise and none were
/// asked for.
inline constexpr std::uint32_t kUsualPhotonsPerPass = 1'000'000;

/// Surfaces that a path meets at most where no bound was asked for, and those beside them that
/// count for nothing, being specular: light goes through a dozen panes of glass.
inline constexpr std::uint32_t kUsualDepth = 16;
inline constexpr std::uint32_t kUsualSpecularSurfaces = 64;

/// How far a path goes.
struct DepthLimit {
    std::uint32_t surfaces = 0;  ///< met at most, but for the specular ones that do not count
    std::uint32_t specular = 0;  ///< the first so many surfaces whose lobes all are specular
};

/// Settings::max_bounces that bounds nothing.
inline constexpr std::uint32_t kAnyBounces = std::numeric_limits<std::uint32_t>::max();

/// Everything that a user may set, with its default. Names, ranges and what is said of each stand
/// in settings_table.h.
struct Settings {
    Mode mode = Mode::Progressive;
    GuideKind guide = GuideKind::Adaptive;
    PhotonSampler photon_sampler = PhotonSampler::Sequence;  ///< AdaptiveChains: guide none only
    std::uint64_t seed = 0;

    std::uint32_t max_eye_depth = 0;     ///< surfaces that an eye path may meet; 0: the usual limit
    std::uint32_t max_photon_depth = 0;  ///< of a photon path, likewise
    /// Bounces that an eye path and the photon or shadow ray that it meets may have together.
    std::uint32_t max_bounces = kAnyBounces;
    std::uint32_t photons_per_pass = 0;     ///< 0: by the noise (docs/understand/sharing-light.md)
    std::uint32_t hit_points_per_pass = 0;  ///< eye paths a pass; 0: one a pixel (frozen: four)
    double start_radius = 0;  ///< in mean pixel footprints at the visible points; 0: automatic
    double alpha = 0.7;       ///< how slowly the radius shrinks: 1 keeps it
    bool include_environment = true;    ///< lights at infinity are seen by eye rays
    bool direct_light_sampling = true;  ///< direct light by shadow rays instead of photons
    bool learn_lights = true;           ///< shadow rays go where lights were seen to come from
    /// Eye paths go on from their visible points where they carry light better than photons do.
    bool continue_eye_paths = true;
    /// Where photons bring little, one of several passes shoots for all.
    bool photon_turns = true;
    /// Paths are drawn for emitters that specular surfaces show, beside eye paths.
    bool guide_emitters = true;
    /// Density estimates count the part of a gather disc that is surface, not all of it.
    bool correct_edges = true;
    /// Photons count only where nothing separates them from the visible point.
    bool photon_occlusion = true;
    /// Where radii adapt: those of pixels that are surely blurred are narrower.
    bool narrow_radii = true;
    /// Photons bring light to glossy lobes beside the bounce: caustics where that is better, and
    /// what bounces seldom meet.
    bool caustics_on_gloss = true;
    bool store_glossy = false;  ///< glossy lobes receive photons instead of bouncing
    bool debug_layers = false;  ///< extra layers of the film: docs/reference/layers.md

    double guide_share = 0.5;  ///< share of guided directions in the one-sample mixture
    std::uint32_t iteration_photons = 4000;  ///< photon paths between two updates of the guide
    std::uint32_t initial_photons = 1000;    ///< unguided paths at the start of each pass
    std::uint32_t node_photons = 32;         ///< photons that a node holds before it splits
    std::uint32_t tree_depth = 64;
    std::uint32_t max_nodes = 16384;   ///< leaves of the guide's kd-tree
    std::uint32_t cdf_resolution = 8;  ///< cells per side of a directional table
    double error_alpha = 0.4;          ///< weight of the last pass's error (eq. 8)
    CriterionKind error_criterion = CriterionKind::Paper;
    NeighbourKind neighbours = NeighbourKind::Reached;  ///< guide=paper: section 5.2
    bool present_errors = true;  ///< guide=paper: eq. 5 takes neighbours' errors of now
    bool direct_photons = true;  ///< guide=paper learns from light that shadow rays own

    bool guide_emission = true;  ///< guide=adaptive guides where photons start
    bool eye_seeding = true;    ///< guide=adaptive learns from the eye where photons ought to start
    bool guide_bounces = true;  ///< guide=adaptive guides where photons go on to
    bool guide_survival = true;  ///< guide=adaptive decides which photons go on
    bool pilot_pass = true;    ///< guide=adaptive is left out where a pilot pass tells it can't pay
    bool guide_chains = true;  ///< then chains explore where next to nothing is seen

    /// Tells what each light and material did: EngineStatistics::transport.
    bool transport_statistics = false;

    RadiusKind radius = RadiusKind::Automatic;  ///< mode=progressive; other modes have their own

    bool operator==(const Settings&) const = default;
};

constexpr DepthLimit depth_limit(std::uint32_t asked) {
    return asked ? DepthLimit{asked, 0} : DepthLimit{kUsualDepth, kUsualSpecularSurfaces};
}
constexpr DepthLimit eye_depth(const Settings& settings) {
    return depth_limit(settings.max_eye_depth);
}
constexpr DepthLimit photon_depth(const Settings& settings) {
    return depth_limit(settings.max_photon_depth);
}

/// Whether photons may bring light that shadow rays do not, as far as depths tell.
constexpr bool photons_may_scatter(const Settings& settings) {
    return photon_depth(settings).surfaces > 1 && settings.max_bounces > 1;
}

/// Whether visible points' radii follow noise and bias around them. By radius=automatic they do in
/// mode=progressive, unless start_radius or alpha ask for a schedule of their own: who gives a
/// radius, or how it falls, wants that one. The paper's engine and Markov chains have one radius.
constexpr bool adapts_radius(const Settings& settings) {
    if (settings.mode != Mode::Progressive) return false;
    if (settings.radius != RadiusKind::Automatic) return settings.radius == RadiusKind::Adaptive;
    const bool own_schedule = settings.start_radius != 0 || settings.alpha != Settings{}.alpha;
    return !own_schedule && settings.guide != GuideKind::Paper &&
           settings.photon_sampler == PhotonSampler::Sequence;
}

/// Throws std::invalid_argument, with one clear message, where a setting is out of its range or two
/// do not go together.
void validate(const Settings& settings);

/// The settings in effect, one "name = value" each, for the log at the start of a render.
std::string describe(const Settings& settings);

}  // namespace aips
