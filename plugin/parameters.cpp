// Declarations of all parameters, and the settings made from them. Names follow LuxRender's sppm
// where it has one, so that a scene changes only the plugin's name. Defaults are those of Settings.
#include "parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <deque>
#include <vector>

namespace aips {
namespace {

using lxs::ParameterDeclaration;
using lxs::ParameterType;

/// By number of Mode, GuideKind, CriterionKind, RadiusKind and PhotonSampler.
constexpr std::array<std::string_view, 3> kModes{"progressive", "photonmap", "ppm"};
constexpr std::array<std::string_view, 3> kGuides{"none", "paper", "adaptive"};
constexpr std::array<std::string_view, 2> kCriteria{"paper", "image"};
/// The first is of aips alone; LuxRender's plugins have the others.
constexpr std::array<std::string_view, 3> kRadii{"automatic", "schedule", "adaptive"};
constexpr std::array<std::string_view, 2> kPhotonSamplers{"halton", "amc"};
constexpr double kMaxCount = 4294967295.0;

/// What all defaults are.
constexpr Settings kDefaults;

/// A default as a scene would write it, kept for declarations to show.
template <class Number>
std::string_view text_of(Number value) {
    static std::deque<std::string> texts;
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return texts.emplace_back(text.data(), end);
}

ParameterDeclaration integer(std::string_view name, std::uint64_t value, std::string_view doc,
                             double minimum, double maximum = kMaxCount) {
    return {name, ParameterType::Integer, text_of(value), doc, minimum, maximum};
}

ParameterDeclaration number(std::string_view name, double value, std::string_view doc,
                            double minimum, double maximum) {
    return {name, ParameterType::Float, text_of(value), doc, minimum, maximum};
}

constexpr ParameterDeclaration boolean(std::string_view name, bool value, std::string_view doc) {
    return {name, ParameterType::Bool, value ? "true" : "false", doc};
}

/// One of `choices`, which are named by number of the enumeration that `value` is of.
template <class Enumeration>
constexpr ParameterDeclaration choice(std::string_view name, Enumeration value,
                                      std::string_view doc,
                                      std::span<const std::string_view> choices) {
    ParameterDeclaration d{name, ParameterType::String, choices[std::size_t(value)], doc};
    d.choices = choices;
    return d;
}

constexpr ParameterDeclaration no_effect(std::string_view name, ParameterType type,
                                         std::string_view value, std::string_view doc) {
    ParameterDeclaration d{name, type, value, doc};
    d.no_effect = true;
    return d;
}

/// What all plugins take.
std::vector<ParameterDeclaration> common_declarations() {
    return {
        integer("maxeyedepth", kDefaults.max_eye_depth, "Most surfaces that an eye path meets.", 1,
                1024),
        integer("maxphotondepth", kDefaults.max_photon_depth,
                "Most surfaces that a photon path meets.", 1, 1024),
        integer("hitpointperpass", kDefaults.hit_points_per_pass,
                "Eye paths traced in each pass; 0: one per pixel (modes photonmap and ppm, whose "
                "one eye pass is kept: four).",
                0),
        number("startradius", kDefaults.start_radius,
               "Radius of the first density estimate, the same at all visible points, in their "
               "mean pixel footprints (widths; those beyond eight medians count as eight); 0: "
               "automatic (2; 1 where chains take a guide's place).",
               0, 1e6),
        number("alpha", kDefaults.alpha,
               "Share of the variance reduction in the radius schedule (Knaus and Zwicker 2011), "
               "in ppm the share of each pass's photons that a hit point keeps (Hachisuka et al. "
               "2008); 1 keeps the radius.",
               1e-3, 1),
        boolean("includeenvironment", kDefaults.include_environment,
                "Lights at infinity are seen by eye rays and mirrored by specular surfaces."),
        boolean("directlightsampling", kDefaults.direct_light_sampling,
                "Direct light comes from shadow rays; photons then carry the rest."),
        boolean("learnlights", kDefaults.learn_lights,
                "Shadow rays choose the lights more often that were seen to light a place "
                "(docs/understand/learned-lights.md)."),
        boolean("storeglossy", kDefaults.store_glossy,
                "Glossy lobes take photons instead of bouncing the eye path."),
        boolean("debuglayers", kDefaults.debug_layers,
                "Adds layers to the EXR: the photons' part of the image, photon density, the "
                "guide's nodes (docs/reference/layers.md)."),
        integer("seed", kDefaults.seed, "Seed of all random numbers; --seed overrides it.", 0,
                9007199254740992.0),
    };
}

/// What a plugin takes where a scene says nothing: LuxRender's plugins have its values where ours
/// decides itself.
Settings defaults_of(PluginKind kind) {
    Settings settings = kDefaults;
    if (kind == PluginKind::Aips) return settings;
    settings.guide = GuideKind::None;
    settings.photons_per_pass = kUsualPhotonsPerPass;
    settings.radius = RadiusKind::Schedule;
    if (kind == PluginKind::Ppm) settings.mode = Mode::Ppm;
    if (kind == PluginKind::ExPhotonMap) settings.mode = Mode::PhotonMap;
    return settings;
}

ParameterDeclaration photons_declaration(PluginKind kind) {
    return integer("photonperpass", defaults_of(kind).photons_per_pass,
                   "Photon paths shot in each pass; 0: in mode progressive as many as the noise of "
                   "photons and eye paths asks for (docs/understand/photons-per-pass.md), else "
                   "1000000.",
                   0);
}

std::vector<ParameterDeclaration> guide_declarations() {
    return {
        choice("mode", kDefaults.mode,
               "Stochastic progressive photon mapping; a photon map seen by one frozen eye pass "
               "with a fixed radius; or progressive photon mapping with frozen hit points, each "
               "with its own radius.",
               kModes),
        choice("guide", kDefaults.guide,
               "What decides where photons go: nothing; the adaptive tables of Liu and Zheng 2014; "
               "or what photons are worth to the image (docs/understand/guides.md).",
               kGuides),
        number("guideshare", kDefaults.guide_share,
               "Share of directions drawn from the guide; the rest comes from the BSDF.", 0, 0.99),
        integer("iterationphotons", kDefaults.iteration_photons,
                "Photon paths between two updates of the guide.", 1),
        integer("initialphotons", kDefaults.initial_photons,
                "Unguided photon paths at the start of each pass.", 1),
        integer("nodephotons", kDefaults.node_photons,
                "Photons that a node of the guide holds before it splits.", 2, 65536),
        integer("treedepth", kDefaults.tree_depth, "Greatest depth of the guide's kd-tree.", 1,
                128),
        integer("maxnodes", kDefaults.max_nodes, "Most nodes (leaves) of the guide's kd-tree.", 1,
                1048576),
        integer("cdfresolution", kDefaults.cdf_resolution,
                "Cells per side of a node's directional table.", 1, 64),
        number("erroralpha", kDefaults.error_alpha,
               "Weight of the last pass in a node's error (eq. 8).", 0, 0.99),
        choice(
            "errorcriterion", kDefaults.error_criterion,
            "With guide paper: a node's error is noise and bias of its photons' density (eq. 2 to "
            "4); or, beyond the paper, what they are worth to the image "
            "(docs/understand/paper-guide.md).",
            kCriteria),
        boolean(
            "presenterrors", kDefaults.present_errors,
            "With guide paper: a table is made of the errors that neighbouring nodes have by then "
            "(eq. 5); otherwise of those that they had when each photon landed."),
        boolean(
            "firstlandings", kDefaults.first_landings,
            "With guide paper: nodes also hold the photons that come straight from a light where "
            "shadow rays bring that light to the image (directlightsampling); not with "
            "errorcriterion image."),
        boolean("guideemission", kDefaults.guide_emission,
                "With guide adaptive: guides where photons start."),
        boolean("eyeseeding", kDefaults.eye_seeding,
                "With guide adaptive: paths from the eye tell where photons ought to start."),
        boolean("guidebounces", kDefaults.guide_bounces,
                "With guide adaptive: guides where photons go on to from matte surfaces."),
        boolean(
            "guidesurvival", kDefaults.guide_survival,
            "With guide adaptive: photons go on by what they may still bring, where that pays."),
        boolean(
            "guidechains", kDefaults.guide_chains,
            "With guide adaptive: adaptive Markov chains (as photonsampler amc) take the guide's "
            "place where the first look shows that next to no photon path reaches what is seen."),
        boolean("guidescout", kDefaults.guide_scout,
                "With guide adaptive: a first look decides whether it guides; it is left out where "
                "many photon paths reach what is seen without it, and where next to none do."),
    };
}

std::span<const std::string_view> radii_of(PluginKind kind) {
    return std::span(kRadii).subspan(kind == PluginKind::Aips ? 0 : 1);
}

constexpr std::string_view kRadiusOfSppm =
    "How the radius goes on: schedule, the same at all visible points, falling with the photons "
    "shot; adaptive, at each visible point the one that balances noise and bias, between an eighth "
    "of the scheduled and twice it (after Kaplanyan and Dachsbacher 2013).";
constexpr std::string_view kRadiusOfAips =
    "How the radius goes on in mode progressive: schedule, the same at all visible points, falling "
    "with the photons shot; adaptive, at each visible point the one that balances noise and bias, "
    "between an eighth of the scheduled and twice it (after Kaplanyan and Dachsbacher 2013); "
    "automatic, adaptive unless startradius or alpha ask for a schedule of their own, or guide is "
    "paper. The other modes have radii of their own: no effect there.";

/// Of plugins that have mode progressive.
ParameterDeclaration radius_declaration(PluginKind kind) {
    ParameterDeclaration d =
        choice("radius", defaults_of(kind).radius,
               kind == PluginKind::Aips ? kRadiusOfAips : kRadiusOfSppm, kRadii);
    d.choices = radii_of(kind);
    return d;
}

ParameterDeclaration photon_sampler_declaration() {
    return choice("photonsampler", kDefaults.photon_sampler,
                  "Where unguided photon paths come from: halton, a low-discrepancy sequence "
                  "(scrambled Sobol'); amc, adaptive Markov chains on the paths that reach visible "
                  "points (Hachisuka and Jensen 2011).",
                  kPhotonSamplers);
}

/// LuxRender's other sppm parameters: accepted so that its scenes load as they are.
std::vector<ParameterDeclaration> foreign_declarations() {
    using T = ParameterType;
    return {
        no_effect("useproba", T::Bool, "true",
                  "The integrator decides: a schedule (Knaus and Zwicker), in ppm the photons."),
        no_effect("lookupaccel", T::String, "hashgrid", "A hashed grid is always used."),
        no_effect("pixelsampler", T::String, "hilbert", "Pixels are always visited in rows."),
        no_effect("parallelhashgridspare", T::Float, "1", "Size of LuxRender's hash grid."),
        no_effect("wavelengthstratificationpasses", T::Integer, "8", "Rendering is in RGB."),
        no_effect("schedulerblocksize", T::Integer, "0", "Size of LuxRender's work packets."),
        no_effect("startk", T::Integer, "30", "Neighbours of LuxRender's first estimate."),
        no_effect("debug", T::Bool, "false", "LuxRender's own debugging output."),
    };
}

void append(std::vector<ParameterDeclaration>& to, const std::vector<ParameterDeclaration>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

/// LuxRender's parameters of exphotonmap that have no meaning here.
std::vector<ParameterDeclaration> foreign_map_declarations() {
    using T = ParameterType;
    return {
        no_effect("renderingmode", T::String, "directlighting", "Shadow rays plus photons."),
        no_effect("finalgather", T::Bool, "true", "Photons are seen directly."),
        no_effect("finalgathersamples", T::Integer, "32", "Photons are seen directly."),
        no_effect("causticphotons", T::Integer, "20000", "One map holds all photons."),
        no_effect("indirectphotons", T::Integer, "200000", "One map holds all photons."),
        no_effect("directphotons", T::Integer, "200000", "One map holds all photons."),
        no_effect("radiancephotons", T::Integer, "200000", "No radiance photons."),
        no_effect("nphotonsused", T::Integer, "50", "The radius is fixed."),
        no_effect("maxphotondist", T::Float, "0.1", "See startradius."),
        no_effect("maxdepth", T::Integer, "5", "See maxeyedepth."),
    };
}

std::vector<ParameterDeclaration> declarations_of(PluginKind kind) {
    std::vector<ParameterDeclaration> all;
    if (kind == PluginKind::Aips) append(all, guide_declarations());
    append(all, common_declarations());
    all.push_back(photons_declaration(kind));
    if (kind == PluginKind::Aips || kind == PluginKind::Sppm) {
        all.push_back(radius_declaration(kind));
    }
    if (kind != PluginKind::ExPhotonMap) all.push_back(photon_sampler_declaration());
    append(all,
           kind == PluginKind::ExPhotonMap ? foreign_map_declarations() : foreign_declarations());
    return all;
}

void read_common(const lxs::ParameterReader& in, Settings& s) {
    const auto count = [&](std::string_view name, std::uint32_t value) {
        return static_cast<std::uint32_t>(in.integer(name, value));
    };
    s.max_eye_depth = count("maxeyedepth", s.max_eye_depth);
    s.max_photon_depth = count("maxphotondepth", s.max_photon_depth);
    s.photons_per_pass = count("photonperpass", s.photons_per_pass);
    s.hit_points_per_pass = count("hitpointperpass", s.hit_points_per_pass);
    s.start_radius = in.number("startradius", s.start_radius);
    s.alpha = in.number("alpha", s.alpha);
    s.include_environment = in.boolean("includeenvironment", s.include_environment);
    s.direct_light_sampling = in.boolean("directlightsampling", s.direct_light_sampling);
    s.learn_lights = in.boolean("learnlights", s.learn_lights);
    s.store_glossy = in.boolean("storeglossy", s.store_glossy);
    s.debug_layers = in.boolean("debuglayers", s.debug_layers);
    s.seed = static_cast<std::uint64_t>(in.integer("seed", std::int64_t(s.seed)));
}

/// What was chosen among `choices`, which are named by number of the enumeration.
template <class Enumeration>
Enumeration chosen(const lxs::ParameterReader& in, std::string_view name,
                   std::span<const std::string_view> choices, Enumeration unless_given) {
    const std::string choice = in.string(name, choices[std::size_t(unless_given)]);
    return static_cast<Enumeration>(std::find(choices.begin(), choices.end(), choice) -
                                    choices.begin());
}

void read_guide(const lxs::ParameterReader& in, Settings& s) {
    const auto count = [&](std::string_view name, std::uint32_t value) {
        return static_cast<std::uint32_t>(in.integer(name, value));
    };
    s.mode = chosen(in, "mode", kModes, s.mode);
    s.guide = chosen(in, "guide", kGuides, s.guide);
    s.guide_share = in.number("guideshare", s.guide_share);
    s.iteration_photons = count("iterationphotons", s.iteration_photons);
    s.initial_photons = count("initialphotons", s.initial_photons);
    s.node_photons = count("nodephotons", s.node_photons);
    s.tree_depth = count("treedepth", s.tree_depth);
    s.max_nodes = count("maxnodes", s.max_nodes);
    s.cdf_resolution = count("cdfresolution", s.cdf_resolution);
    s.error_alpha = in.number("erroralpha", s.error_alpha);
    s.error_criterion = chosen(in, "errorcriterion", kCriteria, s.error_criterion);
    s.present_errors = in.boolean("presenterrors", s.present_errors);
    s.first_landings = in.boolean("firstlandings", s.first_landings);
    s.guide_emission = in.boolean("guideemission", s.guide_emission);
    s.eye_seeding = in.boolean("eyeseeding", s.eye_seeding);
    s.guide_bounces = in.boolean("guidebounces", s.guide_bounces);
    s.guide_survival = in.boolean("guidesurvival", s.guide_survival);
    s.guide_chains = in.boolean("guidechains", s.guide_chains);
    s.guide_scout = in.boolean("guidescout", s.guide_scout);
}

void read_radius(const lxs::ParameterReader& in, Settings& s) {
    s.radius = chosen(in, "radius", kRadii, s.radius);
    // Who gives a radius, or how it falls, wants that one, even if it is the default's.
    const bool own = in.given("startradius") || in.given("alpha");
    if (s.radius == RadiusKind::Automatic && own) s.radius = RadiusKind::Schedule;
    if (s.radius == RadiusKind::Adaptive && !adapts_radius(s)) {
        in.diagnostics().warning(in.where("radius"),
                                 "radius \"adaptive\" is ignored: it takes effect with mode "
                                 "\"progressive\"");
    }
}

/// A guide decides itself where photon paths go. A scene of LuxRender's sppm that asks for amc
/// renders under guides too: a warning, not an error.
void read_photon_sampler(const lxs::ParameterReader& in, Settings& s) {
    const auto sampler = chosen(in, "photonsampler", kPhotonSamplers, s.photon_sampler);
    if (sampler != PhotonSampler::AdaptiveChains) return;
    if (s.guide == GuideKind::None) {
        s.photon_sampler = PhotonSampler::AdaptiveChains;
    } else {
        in.diagnostics().warning(in.where("photonsampler"),
                                 "photonsampler \"amc\" is ignored: the guide decides where photon "
                                 "paths go; it takes effect with guide \"none\"");
    }
}

}  // namespace

std::span<const ParameterDeclaration> parameter_declarations(PluginKind kind) {
    static const std::array<std::vector<ParameterDeclaration>, 4> all{
        declarations_of(PluginKind::Aips), declarations_of(PluginKind::Sppm),
        declarations_of(PluginKind::Ppm), declarations_of(PluginKind::ExPhotonMap)};
    return all[static_cast<std::size_t>(kind)];
}

Settings read_settings(PluginKind kind, const lxs::ParameterReader& parameters) {
    Settings settings = defaults_of(kind);
    read_common(parameters, settings);
    if (kind == PluginKind::Aips) read_guide(parameters, settings);
    if (kind != PluginKind::ExPhotonMap) read_photon_sampler(parameters, settings);
    if (kind == PluginKind::Aips || kind == PluginKind::Sppm) read_radius(parameters, settings);
    return settings;
}

}  // namespace aips
