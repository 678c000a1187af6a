// Declarations of all parameters. Names follow LuxRender's sppm
// where it has one, so that a scene changes only the plugin's name. Defaults are those of Settings.
#include "parameters.h"

#include <array>
#include <charconv>
#include <deque>
#include <vector>

#include "parameter_values.h"

namespace aips {
namespace {

using lxs::ParameterDeclaration;
using lxs::ParameterType;

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
        integer("maxeyedepth", kUsualDepth,
                "Most surfaces that an eye path meets. Unless it is given, the first 64 smooth "
                "ones do not count.",
                1, 1024),
        integer("maxphotondepth", kUsualDepth,
                "Most surfaces that a photon path meets. Unless it is given, the first 64 smooth "
                "ones do not count.",
                1, 1024),
        integer("hitpointperpass", kDefaults.hit_points_per_pass,
                "Eye paths traced in each pass; 0: one per pixel (modes photonmap and ppm, whose "
                "one eye pass is kept: four).",
                0),
        number("startradius", kDefaults.start_radius,
               "Radius of the first density estimate, the same at all visible points, in their "
               "mean pixel footprints (widths; those beyond eight medians count as eight); 0: "
               "automatic (2).",
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

ParameterDeclaration occlusion_declaration(PluginKind kind) {
    return boolean("photonocclusion", defaults_of(kind).photon_occlusion,
                   "Photons count only where nothing separates them from what is seen, such as a "
                   "wall thinner than the radius (docs/understand/edges.md).");
}

ParameterDeclaration photons_declaration(PluginKind kind) {
    return integer("photonperpass", defaults_of(kind).photons_per_pass,
                   "Photon paths shot in each pass; 0: in mode progressive as many as the noise of "
                   "photons and eye paths asks for (docs/understand/photons-per-pass.md), else "
                   "1000000.",
                   0);
}

/// Not of exphotonmap: LuxRender's bounds the eye path by that name.
ParameterDeclaration whole_depth_declaration() {
    return {"maxdepth",
            ParameterType::Integer,
            "-1",
            "Most bounces of a whole path, from the camera to the light, counted as maxdepth of "
            "path; -1: what the depths of eye and photon path allow together.",
            -1,
            1e6};
}

/// Who carries light, and what decides where photons go.
std::vector<ParameterDeclaration> way_declarations() {
    return {
        choice("mode", kDefaults.mode,
               "Stochastic progressive photon mapping; a photon map seen by one frozen eye pass "
               "with a fixed radius; or progressive photon mapping with frozen hit points, each "
               "with its own radius.",
               kModes),
        boolean("continueeyepaths", kDefaults.continue_eye_paths,
                "In mode progressive: eye paths go on from surfaces that take photons, where that "
                "brings more for its time than photons do; not with guide paper "
                "(docs/understand/who-carries-which-light.md)."),
        boolean("photonturns", kDefaults.photon_turns,
                "Where eye paths go on and photons bring little, one of up to eight passes shoots "
                "for all (docs/understand/passes-without-photons.md)."),
        boolean(
            "guidelamps", kDefaults.guide_lamps,
            "In mode progressive: paths are drawn for lamps behind glass and in mirrors, beside "
            "eye paths; not with guide paper (docs/understand/lamp-paths.md)."),
        boolean("correctedges", kDefaults.correct_edges,
                "In mode progressive: at edges photons count by the part of their search disc that "
                "is surface (docs/understand/edges.md)."),
        boolean("narrowradii", kDefaults.narrow_radii,
                "Where radii adapt: those of pixels that are surely blurred are narrower "
                "(docs/understand/adaptive-radius.md)."),
        choice("guide", kDefaults.guide,
               "What decides where photons go: nothing; the adaptive tables of Liu and Zheng 2014; "
               "or what photons are worth to the image (docs/understand/guides.md).",
               kGuides),
    };
}

std::vector<ParameterDeclaration> paper_guide_declarations() {
    return {
        number(
            "guideshare", kDefaults.guide_share,
            "With guide paper: share of directions drawn from the guide; the rest comes from the "
            "BSDF.",
            0, 0.99),
        integer("iterationphotons", kDefaults.iteration_photons,
                "With guide paper: photon paths between two updates of the guide.", 1),
        integer("initialphotons", kDefaults.initial_photons,
                "With guide paper: unguided photon paths at the start of each pass.", 1),
        integer("nodephotons", kDefaults.node_photons,
                "With guide paper: photons that a node of the guide holds before it splits.", 2,
                65536),
        integer("treedepth", kDefaults.tree_depth,
                "With guide paper: greatest depth of the guide's kd-tree.", 1, 128),
        integer("maxnodes", kDefaults.max_nodes,
                "With guide paper: most nodes (leaves) of the guide's kd-tree.", 1, 1048576),
        integer("cdfresolution", kDefaults.cdf_resolution,
                "With guide paper: cells per side of a node's directional table.", 1, 64),
        number("erroralpha", kDefaults.error_alpha,
               "With guide paper: weight of the last pass in a node's error (eq. 8).", 0, 0.99),
        choice(
            "errorcriterion", kDefaults.error_criterion,
            "With guide paper: a node's error is noise and bias of its photons' density (eq. 2 to "
            "4); or, beyond the paper, what they are worth to the image "
            "(docs/understand/paper-guide.md).",
            kCriteria),
        choice("neighbours", kDefaults.neighbours,
               "With guide paper: of two nodes between which a photon flew, the one that it left "
               "knows the one that it reached; or, section 5.2 to the letter, the one where it "
               "landed knows the one where it was last; or both "
               "(docs/understand/paper-guide.md).",
               kNeighbours),
        boolean(
            "presenterrors", kDefaults.present_errors,
            "With guide paper: a table is made of the errors that neighbouring nodes have by then "
            "(eq. 5); otherwise of those that they had when each photon landed."),
        boolean(
            "firstlandings", kDefaults.first_landings,
            "With guide paper: nodes also hold the photons that come straight from a light where "
            "shadow rays bring that light to the image (directlightsampling); not with "
            "errorcriterion image."),
    };
}

std::vector<ParameterDeclaration> adaptive_guide_declarations() {
    return {
        boolean("guideemission", kDefaults.guide_emission,
                "With guide adaptive: guides where photons start."),
        boolean("eyeseeding", kDefaults.eye_seeding,
                "With guide adaptive: paths from the eye tell where photons ought to start."),
        boolean("guidebounces", kDefaults.guide_bounces,
                "With guide adaptive: guides where photons go on to from matte surfaces."),
        boolean(
            "guidesurvival", kDefaults.guide_survival,
            "With guide adaptive: photons go on by what they may still bring, where that pays."),
        boolean("guidechains", kDefaults.guide_chains,
                "With guide adaptive: before the first pass Markov chains explore where photons "
                "start that are seen, where the first look shows that next to none are."),
        boolean("guidescout", kDefaults.guide_scout,
                "With guide adaptive: a first look decides whether it guides; it is left out where "
                "many photon paths reach what is seen without it."),
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
    "between an eighth of the scheduled and twice it (after Kaplanyan and Dachsbacher 2013), and "
    "less where narrowradii says so; automatic, adaptive unless startradius or alpha ask for a "
    "schedule of their own, or guide is paper. The other modes have radii of their own: no effect "
    "there.";

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
        no_effect("wavelengthstratificationpasses", T::Integer, "8",
                  "Where wavelengths are needed they are stratified over all passes."),
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
    if (kind == PluginKind::Aips) {
        append(all, way_declarations());
        append(all, paper_guide_declarations());
        append(all, adaptive_guide_declarations());
    }
    append(all, common_declarations());
    if (kind != PluginKind::ExPhotonMap) all.push_back(whole_depth_declaration());
    all.push_back(photons_declaration(kind));
    all.push_back(occlusion_declaration(kind));
    if (kind == PluginKind::Aips || kind == PluginKind::Sppm) {
        all.push_back(radius_declaration(kind));
    }
    if (kind != PluginKind::ExPhotonMap) all.push_back(photon_sampler_declaration());
    append(all,
           kind == PluginKind::ExPhotonMap ? foreign_map_declarations() : foreign_declarations());
    return all;
}

}  // namespace

std::span<const ParameterDeclaration> parameter_declarations(PluginKind kind) {
    static const std::array<std::vector<ParameterDeclaration>, 4> all{
        declarations_of(PluginKind::Aips), declarations_of(PluginKind::Sppm),
        declarations_of(PluginKind::Ppm), declarations_of(PluginKind::ExPhotonMap)};
    return all[static_cast<std::size_t>(kind)];
}

}  // namespace aips
