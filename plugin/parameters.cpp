// Declarations of all parameters, and the settings made from them. Names follow LuxRender's sppm
// where it has one, so that a scene changes only the plugin's name.
#include "parameters.h"

#include <algorithm>
#include <array>
#include <vector>

namespace aips {
namespace {

using lxs::ParameterDeclaration;
using lxs::ParameterType;

/// By number of Mode, GuideKind and CriterionKind.
constexpr std::array<std::string_view, 3> kModes{"progressive", "photonmap", "ppm"};
constexpr std::array<std::string_view, 3> kGuides{"none", "paper", "adaptive"};
constexpr std::array<std::string_view, 2> kCriteria{"paper", "image"};
/// The first is the default of aips, and of it alone; LuxRender's plugins have the others.
constexpr std::array<std::string_view, 3> kRadii{"automatic", "schedule", "adaptive"};
constexpr std::array<std::string_view, 2> kPhotonSamplers{"halton", "amc"};
constexpr double kMaxCount = 4294967295.0;

constexpr ParameterDeclaration integer(std::string_view name, std::string_view value,
                                       std::string_view doc, double minimum,
                                       double maximum = kMaxCount) {
    return {name, ParameterType::Integer, value, doc, minimum, maximum};
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
        integer("maxeyedepth", "16", "Most surfaces that an eye path meets.", 1, 1024),
        integer("maxphotondepth", "16", "Most surfaces that a photon path meets.", 1, 1024),
        integer("hitpointperpass", "0",
                "Eye paths traced in each pass; 0: one per pixel (modes photonmap and ppm, whose "
                "one eye pass is kept: four).",
                0),
        {"startradius", ParameterType::Float, "0",
         "Radius of the first density estimate, the same at all visible points, in their mean "
         "pixel "
         "footprints (widths; those beyond eight medians count as eight); 0: automatic (2; 1 where "
         "chains take a guide's place).",
         0, 1e6},
        {"alpha", ParameterType::Float, "0.7",
         "Share of the variance reduction in the radius schedule (Knaus and Zwicker 2011), in ppm "
         "the "
         "share of each pass's photons that a hit point keeps (Hachisuka et al. 2008); 1 keeps the "
         "radius.",
         1e-3, 1},
        {"includeenvironment", ParameterType::Bool, "true",
         "Lights at infinity are seen by eye rays and mirrored by specular surfaces."},
        {"directlightsampling", ParameterType::Bool, "true",
         "Direct light comes from shadow rays; photons then carry the rest."},
        {"learnlights", ParameterType::Bool, "true",
         "Shadow rays choose the lights more often that were seen to light a place "
         "(docs/learned-lights.md)."},
        {"storeglossy", ParameterType::Bool, "false",
         "Glossy lobes take photons instead of bouncing the eye path."},
        {"debuglayers", ParameterType::Bool, "false",
         "Adds layers to the EXR: the photons' part of the image, photon density, the guide's "
         "nodes "
         "(docs/debug-layers.md)."},
        integer("seed", "0", "Seed of all random numbers; --seed overrides it.", 0,
                9007199254740992.0),
    };
}

/// LuxRender's plugins have its default, ours decides itself.
ParameterDeclaration photons_declaration(PluginKind kind) {
    return integer("photonperpass", kind == PluginKind::Aips ? "0" : "1000000",
                   "Photon paths shot in each pass; 0: in mode progressive as many as the noise of "
                   "photons and eye paths asks for (docs/photons-per-pass.md), else 1000000.",
                   0);
}

std::vector<ParameterDeclaration> guide_declarations() {
    ParameterDeclaration mode{"mode", ParameterType::String, "progressive",
                              "Stochastic progressive photon mapping; a photon map seen by one "
                              "frozen eye pass with a fixed radius; or progressive photon mapping "
                              "with frozen hit points, each with its own radius."};
    mode.choices = kModes;
    ParameterDeclaration guide{"guide", ParameterType::String, "adaptive",
                               "What decides where photons go: nothing; the adaptive tables of "
                               "Liu and Zheng 2014; or what photons are worth to the image "
                               "(docs/adaptive-guide.md)."};
    guide.choices = kGuides;
    ParameterDeclaration criterion{"errorcriterion", ParameterType::String, "paper",
                                   "With guide paper: a node's error is noise and bias of its "
                                   "photons' density (eq. 2 to 4); or, beyond the paper, what they "
                                   "are worth to the image (docs/paper-guide.md)."};
    criterion.choices = kCriteria;
    return {
        mode,
        guide,
        {"guideshare", ParameterType::Float, "0.5",
         "Share of directions drawn from the guide; the rest comes from the BSDF.", 0, 0.99},
        integer("iterationphotons", "4000", "Photon paths between two updates of the guide.", 1),
        integer("initialphotons", "1000", "Unguided photon paths at the start of each pass.", 1),
        integer("nodephotons", "32", "Photons that a node of the guide holds before it splits.", 2,
                65536),
        integer("treedepth", "64", "Greatest depth of the guide's kd-tree.", 1, 128),
        integer("maxnodes", "16384", "Most nodes (leaves) of the guide's kd-tree.", 1, 1048576),
        integer("cdfresolution", "8", "Cells per side of a node's directional table.", 1, 64),
        {"erroralpha", ParameterType::Float, "0.4",
         "Weight of the last pass in a node's error (eq. 8).", 0, 0.99},
        criterion,
        {"presenterrors", ParameterType::Bool, "true",
         "With guide paper: a table is made of the errors that neighbouring nodes have by then "
         "(eq. 5); otherwise of those that they had when each photon landed."},
        {"firstlandings", ParameterType::Bool, "true",
         "With guide paper: nodes also hold the photons that come straight from a light where "
         "shadow rays bring that light to the image (directlightsampling); not with "
         "errorcriterion image."},
        {"guideemission", ParameterType::Bool, "true",
         "With guide adaptive: guides where photons start."},
        {"eyeseeding", ParameterType::Bool, "true",
         "With guide adaptive: paths from the eye tell where photons ought to start."},
        {"guidebounces", ParameterType::Bool, "true",
         "With guide adaptive: guides where photons go on to from matte surfaces."},
        {"guidesurvival", ParameterType::Bool, "true",
         "With guide adaptive: photons go on by what they may still bring, where that pays."},
        {"guidechains", ParameterType::Bool, "true",
         "With guide adaptive: adaptive Markov chains (as photonsampler amc) take the guide's "
         "place where the first look shows that next to no photon path reaches what is seen."},
        {"guidescout", ParameterType::Bool, "true",
         "With guide adaptive: a first look decides whether it guides; it is left out where many "
         "photon paths reach what is seen without it, and where next to none do."},
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
    ParameterDeclaration d{"radius", ParameterType::String, radii_of(kind).front(),
                           kind == PluginKind::Aips ? kRadiusOfAips : kRadiusOfSppm};
    d.choices = radii_of(kind);
    return d;
}

ParameterDeclaration photon_sampler_declaration() {
    ParameterDeclaration d{"photonsampler", ParameterType::String, "halton",
                           "Where unguided photon paths come from: halton, a low-discrepancy "
                           "sequence (scrambled Sobol'); amc, adaptive Markov chains on the paths "
                           "that reach visible points (Hachisuka and Jensen 2011)."};
    d.choices = kPhotonSamplers;
    return d;
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

void read_common(PluginKind kind, const lxs::ParameterReader& in, Settings& s) {
    const auto count = [&](std::string_view name, std::uint32_t value) {
        return static_cast<std::uint32_t>(in.integer(name, value));
    };
    s.max_eye_depth = count("maxeyedepth", s.max_eye_depth);
    s.max_photon_depth = count("maxphotondepth", s.max_photon_depth);
    s.photons_per_pass =
        count("photonperpass", kind == PluginKind::Aips ? 0 : kUsualPhotonsPerPass);
    s.hit_points_per_pass = count("hitpointperpass", s.hit_points_per_pass);
    s.start_radius = in.number("startradius", s.start_radius);
    s.alpha = in.number("alpha", s.alpha);
    s.include_environment = in.boolean("includeenvironment", s.include_environment);
    s.direct_light_sampling = in.boolean("directlightsampling", s.direct_light_sampling);
    s.learn_lights = in.boolean("learnlights", s.learn_lights);
    s.store_glossy = in.boolean("storeglossy", s.store_glossy);
    s.debug_layers = in.boolean("debuglayers", s.debug_layers);
    s.seed = static_cast<std::uint64_t>(in.integer("seed", 0));
}

/// The number, among `choices`, of what was chosen.
std::ptrdiff_t chosen(const lxs::ParameterReader& in, std::string_view name,
                      std::span<const std::string_view> choices, std::string_view unless_given) {
    const std::string choice = in.string(name, unless_given);
    return std::find(choices.begin(), choices.end(), choice) - choices.begin();
}

void read_guide(const lxs::ParameterReader& in, Settings& s) {
    const auto count = [&](std::string_view name, std::uint32_t value) {
        return static_cast<std::uint32_t>(in.integer(name, value));
    };
    s.mode = static_cast<Mode>(chosen(in, "mode", kModes, kModes[0]));
    s.guide = static_cast<GuideKind>(chosen(in, "guide", kGuides, "adaptive"));
    s.guide_share = in.number("guideshare", s.guide_share);
    s.iteration_photons = count("iterationphotons", s.iteration_photons);
    s.initial_photons = count("initialphotons", s.initial_photons);
    s.node_photons = count("nodephotons", s.node_photons);
    s.tree_depth = count("treedepth", s.tree_depth);
    s.max_nodes = count("maxnodes", s.max_nodes);
    s.cdf_resolution = count("cdfresolution", s.cdf_resolution);
    s.error_alpha = in.number("erroralpha", s.error_alpha);
    s.error_criterion =
        static_cast<CriterionKind>(chosen(in, "errorcriterion", kCriteria, kCriteria[0]));
    s.present_errors = in.boolean("presenterrors", s.present_errors);
    s.first_landings = in.boolean("firstlandings", s.first_landings);
    s.guide_emission = in.boolean("guideemission", s.guide_emission);
    s.eye_seeding = in.boolean("eyeseeding", s.eye_seeding);
    s.guide_bounces = in.boolean("guidebounces", s.guide_bounces);
    s.guide_survival = in.boolean("guidesurvival", s.guide_survival);
    s.guide_chains = in.boolean("guidechains", s.guide_chains);
    s.guide_scout = in.boolean("guidescout", s.guide_scout);
}

void read_radius(PluginKind kind, const lxs::ParameterReader& in, Settings& s) {
    const std::string radius = in.string("radius", radii_of(kind).front());
    if (radius == "schedule") return;
    if (radius == "automatic") {
        // Who gives a radius, or how it falls, wants that one; the paper's engine has one radius.
        const bool own = in.given("startradius") || in.given("alpha");
        const bool adapts = s.mode == Mode::Progressive && s.guide != GuideKind::Paper &&
                            s.photon_sampler == PhotonSampler::Sequence;
        if (!own && adapts) s.radius = RadiusKind::Adaptive;
        return;
    }
    s.radius = RadiusKind::Adaptive;
    if (!adapts_radius(s)) {
        in.diagnostics().warning(in.where("radius"),
                                 "radius \"adaptive\" is ignored: it takes effect with mode "
                                 "\"progressive\"");
    }
}

/// A guide decides itself where photon paths go. A scene of LuxRender's sppm that asks for amc
/// renders under guides too: a warning, not an error.
void read_photon_sampler(const lxs::ParameterReader& in, Settings& s) {
    if (in.string("photonsampler", "halton") != "amc") return;
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
    Settings settings;
    read_common(kind, parameters, settings);
    settings.guide = GuideKind::None;
    if (kind == PluginKind::Aips) read_guide(parameters, settings);
    if (kind == PluginKind::Ppm) settings.mode = Mode::Ppm;
    if (kind == PluginKind::ExPhotonMap) {
        settings.mode = Mode::PhotonMap;
    } else {
        read_photon_sampler(parameters, settings);
    }
    if (kind == PluginKind::Aips || kind == PluginKind::Sppm) {
        read_radius(kind, parameters, settings);
    }
    return settings;
}

}  // namespace aips
