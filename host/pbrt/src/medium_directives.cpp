// Directives of media.
#include <fmt/format.h>

#include <numeric>

#include "translator.h"

namespace lxs::pbrt {
namespace {

const Rgb kDefaultAbsorption(0.0011f, 0.0024f, 0.014f), kDefaultScattering(2.55f, 3.21f, 3.77f);

}  // namespace

void Translator::make_named_medium(Statement& statement) {
    const Name name = take_name(statement, 0);
    ParameterSet set = take_parameters(statement, 1, name);
    Parameters p(std::move(set), defaults("medium"), *state_.space, diagnostics_);
    const std::string type = p.text("type", "homogeneous");
    static const std::vector<std::string> kTypes{"homogeneous", "uniformgrid", "rgbgrid",
                                                 "cloud",       "nanovdb",     "heterogeneous"};
    if (std::find(kTypes.begin(), kTypes.end(), type) == kTypes.end())
        p.fail("type", unknown_name_message("medium", type, kTypes));
    const auto scale = static_cast<float>(p.number("scale", 1));
    Rgb absorption = kDefaultAbsorption, scattering = kDefaultScattering;
    if (p.given("preset"))
        p.leave_out("preset", "pbrt's default coefficients, of a medium like skin, are used");
    const bool grid = type != "homogeneous";
    absorption = spectra_.colour(p, "sigma_a", ColourOf::Surface, grid ? Rgb(1.0f) : absorption);
    scattering = spectra_.colour(p, "sigma_s", ColourOf::Surface, grid ? Rgb(1.0f) : scattering);
    double density = 1;
    if (grid) {
        const Numbers values = p.numbers(type == "rgbgrid" ? "sigma_s" : "density");
        for (const char* known : {"nx", "ny", "nz", "p0", "p1", "filename", "density", "wispiness",
                                  "frequency", "temperature", "temperatureoffset",
                                  "temperaturescale", "temperaturecutoff", "Lescale", "LeScale"})
            p.ignore(known);
        if (!values.empty())
            density = std::accumulate(values.begin(), values.end(), 0.0) /
                      static_cast<double>(values.size());
        else
            density = type == "cloud" ? 0.5 : 0;
        if (type == "rgbgrid") scattering = absorption = Rgb(1.0f);
        warn(p.where("type"),
             fmt::format("medium \"{}\" is not rendered with its shape: a homogeneous one with "
                         "its mean density is used",
                         type));
    }
    p.leave_out("Le", "media do not shine here");
    p.ignore("Lescale");
    const double g = std::clamp(p.number("g", 0), -1.0, 1.0);
    const float factor = scale * static_cast<float>(std::max(density, 0.0));
    add(NewStatement("MakeNamedVolume", statement.where)
            .name(name.text)
            .name("homogeneous")
            .set("float fresnel", 1)
            .set("color sigma_a", absorption * factor)
            .set("color sigma_s", scattering * factor)
            .set("color g", Numbers{g, g, g}));
    p.report_unused("medium");
}

void Translator::medium_interface(Statement& statement) {
    state_.inside = take_name(statement, 0).text;
    state_.outside = statement.arguments.size() > 1 ? take_name(statement, 1).text : state_.inside;
    if (statement.arguments.size() > 2)
        throw InputError(statement.arguments[2].where, "MediumInterface takes two names at most");
}

}  // namespace lxs::pbrt
