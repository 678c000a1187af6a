// Asks the rules.
#include "lxs/host/advice.h"

#include <exception>

#include "advice/advice_rules.h"

namespace lxs {
namespace {

struct Rule {
    std::string_view name;
    AdviceText (*look)(const AdviceFacts& facts);
};

constexpr Rule kRules[] = {
    {"everything out of view", &everything_is_out_of_view},
    {"image burnt out", &image_is_burnt_out},
    {"image nearly black", &image_is_nearly_black},
    {"photon depth", &photon_depth_cuts_caustics},
    {"eye depth", &eye_depth_cuts_glass},
    {"light takes the photons", &light_takes_photons_for_nothing},
    {"camera in a solid", &camera_is_inside_glass},
    {"lamp in a solid", &lamp_is_inside_a_solid},
    {"glass inside out", &glass_is_inside_out},
    {"architectural glass", &architectural_glass_is_curved},
    {"path misses caustics", &path_misses_caustics},
    {"gloss misses caustics", &gloss_misses_caustics},
    {"radius too wide", &radius_is_wider_than_objects},
};

}  // namespace

std::vector<Advice> advise(const RenderSession& session, const TransportStatistics& transport,
                           const ImageVerdict& image) {
    std::vector<Advice> advice;
    try {
        SceneProbe probe(session);
        const std::vector<std::uint8_t> picture = session.film->tone_mapped();
        const AdviceFacts facts{session, transport, image, picture, probe};
        for (const Rule& rule : kRules) {
            if (auto text = rule.look(facts)) advice.push_back({rule.name, std::move(*text)});
        }
    } catch (const std::exception&) {  // what was found so far is all there is
    }
    return advice;
}

}  // namespace lxs
