// The settings that a scene's parameters ask for.
#include <algorithm>

#include "parameter_values.h"

namespace aips {
namespace {

void read_common(const lxs::ParameterReader& in, Settings& s) {
    const auto count = [&](std::string_view name, std::uint32_t value) {
        return static_cast<std::uint32_t>(in.integer(name, value));
    };
    // Who gives a depth wants that one, even if it is the default's.
    if (in.given("maxeyedepth")) s.max_eye_depth = count("maxeyedepth", kUsualDepth);
    if (in.given("maxphotondepth")) s.max_photon_depth = count("maxphotondepth", kUsualDepth);
    s.photons_per_pass = count("photonperpass", s.photons_per_pass);
    s.hit_points_per_pass = count("hitpointperpass", s.hit_points_per_pass);
    s.start_radius = in.number("startradius", s.start_radius);
    s.alpha = in.number("alpha", s.alpha);
    s.include_environment = in.boolean("includeenvironment", s.include_environment);
    s.direct_light_sampling = in.boolean("directlightsampling", s.direct_light_sampling);
    s.photon_occlusion = in.boolean("photonocclusion", s.photon_occlusion);
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
    s.continue_eye_paths = in.boolean("continueeyepaths", s.continue_eye_paths);
    s.photon_turns = in.boolean("photonturns", s.photon_turns);
    s.guide_lamps = in.boolean("guidelamps", s.guide_lamps);
    s.correct_edges = in.boolean("correctedges", s.correct_edges);
    s.narrow_radii = in.boolean("narrowradii", s.narrow_radii);
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
    s.neighbours = chosen(in, "neighbours", kNeighbours, s.neighbours);
    s.present_errors = in.boolean("presenterrors", s.present_errors);
    s.first_landings = in.boolean("firstlandings", s.first_landings);
    s.guide_emission = in.boolean("guideemission", s.guide_emission);
    s.eye_seeding = in.boolean("eyeseeding", s.eye_seeding);
    s.guide_bounces = in.boolean("guidebounces", s.guide_bounces);
    s.guide_survival = in.boolean("guidesurvival", s.guide_survival);
    s.guide_chains = in.boolean("guidechains", s.guide_chains);
    s.guide_scout = in.boolean("guidescout", s.guide_scout);
}

void read_whole_depth(const lxs::ParameterReader& in, Settings& s) {
    const std::int64_t bounces = in.integer("maxdepth", -1);
    if (bounces >= 0) s.max_bounces = static_cast<std::uint32_t>(bounces);
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

Settings defaults_of(PluginKind kind) {
    Settings settings;
    if (kind == PluginKind::Aips) return settings;
    settings.guide = GuideKind::None;
    settings.continue_eye_paths = false;
    settings.guide_lamps = false;
    settings.correct_edges = false;
    settings.photon_occlusion = false;
    settings.narrow_radii = false;
    settings.photons_per_pass = kUsualPhotonsPerPass;
    settings.radius = RadiusKind::Schedule;
    if (kind == PluginKind::Ppm) settings.mode = Mode::Ppm;
    if (kind == PluginKind::ExPhotonMap) settings.mode = Mode::PhotonMap;
    return settings;
}

Settings read_settings(PluginKind kind, const lxs::ParameterReader& parameters) {
    Settings settings = defaults_of(kind);
    read_common(parameters, settings);
    if (kind == PluginKind::Aips) read_guide(parameters, settings);
    if (kind != PluginKind::ExPhotonMap) read_whole_depth(parameters, settings);
    if (kind != PluginKind::ExPhotonMap) read_photon_sampler(parameters, settings);
    if (kind == PluginKind::Aips || kind == PluginKind::Sppm) read_radius(parameters, settings);
    return settings;
}

}  // namespace aips
