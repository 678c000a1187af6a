// What is said of each setting.
#include "aips/adapter/settings_table.h"

#include <array>
#include <charconv>
#include <string>

namespace aips {
namespace {

// By number of Mode, GuideKind, RadiusKind, CriterionKind, NeighbourKind and PhotonSampler.
constexpr std::array<std::string_view, 3> kModes{"progressive", "photonmap", "ppm"};
constexpr std::array<std::string_view, 3> kGuides{"none", "paper", "adaptive"};
constexpr std::array<std::string_view, 3> kRadii{"automatic", "schedule", "adaptive"};
constexpr std::array<std::string_view, 2> kCriteria{"paper", "image"};
constexpr std::array<std::string_view, 3> kNeighbours{"reached", "last", "both"};
constexpr std::array<std::string_view, 2> kPhotonSamplers{"sobol", "amc"};
constexpr std::array<std::string_view, 1> kLuxRendersSamplers{"halton"};

constexpr std::string_view kUsualDepthText = "16";
static_assert(kUsualDepth == 16);

constexpr std::string_view kRadiusDoc =
    "How the radius goes on in mode progressive: schedule, the same at all visible points, falling "
    "with the photons shot; adaptive, at each visible point the one that balances noise and bias, "
    "between an eighth of the scheduled and twice it (after Kaplanyan and Dachsbacher 2013), and "
    "less where narrowradii says so; automatic, adaptive unless startradius or alpha ask for a "
    "schedule of their own, or guide is paper. The other modes have radii of their own: no effect "
    "there.";

bool unguided(const Settings& s) {
    return s.guide == GuideKind::None;
}
bool guided_adaptively(const Settings& s) {
    return s.guide == GuideKind::Adaptive;
}
bool guided_by_paper(const Settings& s) {
    return s.guide == GuideKind::Paper;
}
/// Photons that shadow rays own all come straight from a light, and only the paper's criterion
/// learns from them: the other one goes by the image, to which they bring nothing.
bool learns_from_direct_photons(const Settings& s) {
    return guided_by_paper(s) && s.direct_light_sampling &&
           s.error_criterion == CriterionKind::Paper;
}

constexpr SettingRow kRows[] = {
    {.name = "mode",
     .member = &Settings::mode,
     .group = SettingGroup::First,
     .doc =
         "Stochastic progressive photon mapping; a photon map seen by one frozen eye pass with a "
         "fixed radius; or progressive photon mapping with frozen hit points, each with its own "
         "radius.",
     .choices = kModes},
    {.name = "guide",
     .member = &Settings::guide,
     .group = SettingGroup::First,
     .doc = "What decides where photons go: nothing; the adaptive tables of Liu and Zheng 2014; or "
            "what photons contribute to the image (docs/understand/guides.md).",
     .choices = kGuides},
    {.name = "maxdepth",
     .member = &Settings::max_bounces,
     .group = SettingGroup::First,
     .doc = "Most bounces of a whole path, from the camera to the light, counted as maxdepth of "
            "path; -1: what the depths of eye and photon path allow together.",
     .minimum = -1,
     .maximum = 1e6,
     .default_text = "-1",
     .automatic = "any"},
    {.name = "maxeyedepth",
     .member = &Settings::max_eye_depth,
     .group = SettingGroup::First,
     .doc =
         "Most surfaces that an eye path meets. Unless it is given, the first 64 specular ones do "
         "not count.",
     .minimum = 1,
     .maximum = 1024,
     .default_text = kUsualDepthText,
     .automatic = "automatic"},
    {.name = "maxphotondepth",
     .member = &Settings::max_photon_depth,
     .group = SettingGroup::First,
     .doc =
         "Most surfaces that a photon path meets. Unless it is given, the first 64 specular ones "
         "do not count.",
     .minimum = 1,
     .maximum = 1024,
     .default_text = kUsualDepthText,
     .automatic = "automatic"},
    {.name = "photonperpass",
     .member = &Settings::photons_per_pass,
     .group = SettingGroup::First,
     .doc =
         "Photon paths shot in each pass; 0: in mode progressive as many as the noise of photons "
         "and eye paths asks for (docs/understand/sharing-light.md), else 1000000.",
     .automatic = "automatic"},
    {.name = "startradius",
     .member = &Settings::start_radius,
     .group = SettingGroup::First,
     .doc = "Radius of the first density estimate, the same at all visible points, in their mean "
            "pixel footprints (widths; those beyond eight medians count as eight); 0: automatic "
            "(2).",
     .maximum = 1e6,
     .automatic = "automatic"},
    {.name = "directlightsampling",
     .member = &Settings::direct_light_sampling,
     .group = SettingGroup::First,
     .doc = "Direct light comes from shadow rays; photons then carry the rest."},
    {.name = "seed",
     .member = &Settings::seed,
     .group = SettingGroup::First,
     .doc = "Seed of all random numbers; --seed overrides it.",
     .maximum = kMostSeed},

    {.name = "hitpointperpass",
     .member = &Settings::hit_points_per_pass,
     .doc =
         "Eye paths traced in each pass; 0: one per pixel (modes photonmap and ppm, whose one eye "
         "pass is kept: four).",
     .automatic = "automatic"},
    {.name = "radius",
     .member = &Settings::radius,
     .doc = kRadiusDoc,
     .choices = kRadii,
     .matters = [](const Settings& s) { return s.mode == Mode::Progressive; }},
    {.name = "alpha",
     .member = &Settings::alpha,
     .doc =
         "Share of the variance reduction in the radius schedule (Knaus and Zwicker 2011), in "
         "ppm the share of each pass's photons that a hit point keeps (Hachisuka et al. 2008); 1 "
         "keeps the radius.",
     .minimum = 1e-3,
     .maximum = 1},
    {.name = "includeenvironment",
     .member = &Settings::include_environment,
     .doc = "Lights at infinity are seen by eye rays and mirrored by specular surfaces."},
    {.name = "storeglossy",
     .member = &Settings::store_glossy,
     .doc = "Glossy lobes take photons instead of bouncing the eye path."},
    {.name = "photonsampler",
     .member = &Settings::photon_sampler,
     .doc = "Where unguided photon paths come from: sobol, a low-discrepancy sequence (scrambled "
            "Sobol'; LuxRender's halton is the same); amc, adaptive Markov chains on the paths "
            "that reach visible points (Hachisuka "
            "and Jensen 2011).",
     .choices = kPhotonSamplers,
     .aliases = kLuxRendersSamplers,
     .matters = unguided},
    {.name = "debuglayers",
     .member = &Settings::debug_layers,
     .doc = "Adds layers to the EXR: the photons' part of the image, photon density, the guide's "
            "nodes (docs/reference/layers.md)."},

    {.name = "photonocclusion",
     .member = &Settings::photon_occlusion,
     .group = SettingGroup::Study,
     .doc = "Photons count only where nothing separates them from what is seen, such as a wall "
            "thinner than the radius (docs/understand/radius.md)."},
    {.name = "correctedges",
     .member = &Settings::correct_edges,
     .group = SettingGroup::Study,
     .doc = "In mode progressive: at edges photons count by the part of their gather disc that is "
            "surface (docs/understand/radius.md)."},
    {.name = "narrowradii",
     .member = &Settings::narrow_radii,
     .group = SettingGroup::Study,
     .doc = "Where radii adapt: those of pixels that are surely blurred are narrower "
            "(docs/understand/radius.md).",
     .matters = adapts_radius},
    {.name = "learnlights",
     .member = &Settings::learn_lights,
     .group = SettingGroup::Study,
     .doc = "Shadow rays choose the lights more often that were seen to light a place "
            "(docs/understand/direct-light.md)."},
    {.name = "continueeyepaths",
     .member = &Settings::continue_eye_paths,
     .group = SettingGroup::Study,
     .doc =
         "In mode progressive: eye paths go on from surfaces that take photons, where that brings "
         "more for its time than photons do; not with guide paper "
         "(docs/understand/who-carries-which-light.md)."},
    {.name = "causticsongloss",
     .member = &Settings::caustics_on_gloss,
     .group = SettingGroup::Study,
     .doc =
         "With continueeyepaths: photons bring light to glossy lobes beside the eye path's bounce: "
         "caustics where that is better, other light from where the bounce seldom goes "
         "(docs/understand/who-carries-which-light.md)."},
    {.name = "photonturns",
     .member = &Settings::photon_turns,
     .group = SettingGroup::Study,
     .doc = "Where eye paths go on and photons bring little, one of up to eight passes shoots for "
            "all (docs/understand/sharing-light.md)."},
    {.name = "guidelamps",
     .member = &Settings::guide_emitters,
     .group = SettingGroup::Study,
     .doc = "In mode progressive: paths are drawn for emitters behind glass and in mirrors, beside "
            "eye "
            "paths; not with guide paper (docs/understand/direct-light.md)."},
    {.name = "guideemission",
     .member = &Settings::guide_emission,
     .group = SettingGroup::Study,
     .doc = "With guide adaptive: guides where photons start.",
     .matters = guided_adaptively},
    {.name = "eyeseeding",
     .member = &Settings::eye_seeding,
     .group = SettingGroup::Study,
     .doc = "With guide adaptive: paths from the eye tell where photons ought to start.",
     .matters = guided_adaptively},
    {.name = "guidebounces",
     .member = &Settings::guide_bounces,
     .group = SettingGroup::Study,
     .doc = "With guide adaptive: guides where photons go on to from matte surfaces.",
     .matters = guided_adaptively},
    {.name = "guidesurvival",
     .member = &Settings::guide_survival,
     .group = SettingGroup::Study,
     .doc = "With guide adaptive: photons go on by what they may still bring, where that pays.",
     .matters = guided_adaptively},
    {.name = "guidechains",
     .member = &Settings::guide_chains,
     .group = SettingGroup::Study,
     .doc = "With guide adaptive: before the first pass Markov chains explore where photons start "
            "that are seen, where the pilot pass shows that next to none are.",
     .matters = guided_adaptively},
    {.name = "guidescout",
     .member = &Settings::pilot_pass,
     .group = SettingGroup::Study,
     .doc =
         "With guide adaptive: a pilot pass decides whether it guides; it is left out where many "
         "photon paths reach what is seen without it.",
     .matters = guided_adaptively},

    {.name = "guideshare",
     .member = &Settings::guide_share,
     .group = SettingGroup::Paper,
     .doc = "Share of directions drawn from the guide; the rest comes from the BSDF.",
     .maximum = 0.99,
     .matters = guided_by_paper},
    {.name = "iterationphotons",
     .member = &Settings::iteration_photons,
     .group = SettingGroup::Paper,
     .doc = "Photon paths between two updates of the guide.",
     .minimum = 1,
     .matters = guided_by_paper},
    {.name = "initialphotons",
     .member = &Settings::initial_photons,
     .group = SettingGroup::Paper,
     .doc = "Unguided photon paths at the start of each pass.",
     .minimum = 1,
     .matters = guided_by_paper},
    {.name = "nodephotons",
     .member = &Settings::node_photons,
     .group = SettingGroup::Paper,
     .doc = "Photons that a node of the guide holds before it splits.",
     .minimum = 2,
     .maximum = 65536,
     .matters = guided_by_paper},
    {.name = "treedepth",
     .member = &Settings::tree_depth,
     .group = SettingGroup::Paper,
     .doc = "Greatest depth of the guide's kd-tree.",
     .minimum = 1,
     .maximum = 128,
     .matters = guided_by_paper},
    {.name = "maxnodes",
     .member = &Settings::max_nodes,
     .group = SettingGroup::Paper,
     .doc = "Most nodes (leaves) of the guide's kd-tree.",
     .minimum = 1,
     .maximum = 1048576,
     .matters = guided_by_paper},
    {.name = "cdfresolution",
     .member = &Settings::cdf_resolution,
     .group = SettingGroup::Paper,
     .doc = "Cells per side of a node's directional table.",
     .minimum = 1,
     .maximum = 64,
     .matters = guided_by_paper},
    {.name = "erroralpha",
     .member = &Settings::error_alpha,
     .group = SettingGroup::Paper,
     .doc = "Weight of the last pass in a node's error (eq. 8).",
     .maximum = 0.99,
     .matters = guided_by_paper},
    {.name = "errorcriterion",
     .member = &Settings::error_criterion,
     .group = SettingGroup::Paper,
     .doc = "A node's error is noise and bias of its photons' density (eq. 2 to 4); or, beyond the "
            "paper, what they contribute to the image (docs/understand/paper-guide.md).",
     .choices = kCriteria,
     .matters = guided_by_paper},
    {.name = "neighbours",
     .member = &Settings::neighbours,
     .group = SettingGroup::Paper,
     .doc =
         "Of two nodes between which a photon flew, the one that it left knows the one that it "
         "reached; or, section 5.2 to the letter, the one where it landed knows the one where it "
         "was last; or both (docs/understand/paper-guide.md).",
     .choices = kNeighbours,
     .matters = guided_by_paper},
    {.name = "presenterrors",
     .member = &Settings::present_errors,
     .group = SettingGroup::Paper,
     .doc = "A table is made of the errors that neighbouring nodes have by then (eq. 5); otherwise "
            "of those that they had when each photon landed.",
     .matters = guided_by_paper},
    {.name = "firstlandings",
     .member = &Settings::direct_photons,
     .group = SettingGroup::Paper,
     .doc = "Nodes also hold the photons that come straight from a light where shadow rays bring "
            "that light to the image (directlightsampling); not with errorcriterion image.",
     .matters = learns_from_direct_photons},
};

std::string written(bool value, const SettingRow& /*row*/) {
    return value ? "true" : "false";
}
template <class Number>
requires std::is_arithmetic_v<Number> std::string written(Number value, const SettingRow& /*row*/) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}
template <class Enumeration>
requires std::is_enum_v<Enumeration> std::string written(Enumeration value, const SettingRow& row) {
    return std::string(row.choices[std::size_t(value)]);
}

}  // namespace

std::span<const SettingRow> setting_rows() {
    return kRows;
}

bool is_default(const SettingRow& row, const Settings& settings) {
    constexpr Settings kDefaults;
    return std::visit([&](auto member) { return settings.*member == kDefaults.*member; },
                      row.member);
}

std::string text_of(const SettingRow& row, const Settings& settings) {
    if (!row.default_text.empty() && is_default(row, settings))
        return std::string(row.default_text);
    return std::visit([&](auto member) { return written(settings.*member, row); }, row.member);
}

}  // namespace aips
