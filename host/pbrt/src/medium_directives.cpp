// Directives of media.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

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
    const bool shaped = type != "homogeneous";
    absorption = spectra_.colour(p, "sigma_a", ColourOf::Surface, shaped ? Rgb(1.0f) : absorption);
    scattering = spectra_.colour(p, "sigma_s", ColourOf::Surface, shaped ? Rgb(1.0f) : scattering);
    p.leave_out("Le", "media do not shine here");
    for (const char* known : {"Lescale", "LeScale"})
        p.ignore(known);
    const double g = std::clamp(p.number("g", 0), -1.0, 1.0);
    NewStatement made("MakeNamedVolume", statement.where);
    made.name(name.text);
    if (const bool grid = type == "uniformgrid" || type == "heterogeneous"; grid) {
        const Density density = density_grid(p, name.text);
        made.name("heterogeneous");
        for (const auto& [head, colour] :
             {std::pair("sigma_a", absorption), {"sigma_s", scattering}}) {
            const std::string texture = fresh(name.text + "/" + head);
            add(NewStatement("Texture", statement.where)
                    .name(texture)
                    .name("color")
                    .name("mix")
                    .set("texture amount", density.texture)
                    .set("color tex1", Rgb(0.0f))
                    .set("color tex2", colour * (scale * density.most)));
            made.set(fmt::format("texture {}", head).c_str(), texture);
        }
    } else {
        const float factor = scale * (shaped ? mean_density(p, type) : 1.0f);
        if (type == "rgbgrid") scattering = absorption = Rgb(1.0f);
        made.name("homogeneous")
            .set("color sigma_a", absorption * factor)
            .set("color sigma_s", scattering * factor);
    }
    add(std::move(made.set("float fresnel", 1).set("color g", Numbers{g, g, g})));
    p.report_unused("medium");
}

/// Of a medium that is rendered without its shape.
float Translator::mean_density(Parameters& p, const std::string& type) {
    const Numbers values = p.numbers(type == "rgbgrid" ? "sigma_s" : "density");
    for (const char* known :
         {"nx", "ny", "nz", "p0", "p1", "filename", "density", "wispiness", "frequency",
          "temperature", "temperatureoffset", "temperaturescale", "temperaturecutoff"})
        p.ignore(known);
    warn(p.where("type"),
         fmt::format("medium \"{}\" is not rendered with its shape: a homogeneous one with its "
                     "mean density is used",
                     type));
    if (values.empty()) return type == "cloud" ? 0.5f : 0.0f;
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    return static_cast<float>(std::max(sum / static_cast<double>(values.size()), 0.0));
}

/// Writes a medium's grid as a texture of densities up to 1.
Translator::Density Translator::density_grid(Parameters& p, const std::string& medium) {
    Numbers values = p.numbers("density");
    if (values.empty()) p.fail("density", "a grid needs \"density\"");
    const SourceLocation& at = p.where("density");
    const double most = std::max(*std::ranges::max_element(values), 0.0);
    for (double& value : values)
        value = most > 0 ? std::max(value, 0.0) / most : 0;
    const Vec3 low = p.point("p0").value_or(Vec3(0.0f));
    const Vec3 high = p.point("p1").value_or(Vec3(1.0f));
    for (const char* known :
         {"temperature", "temperatureoffset", "temperaturescale", "temperaturecutoff"})
        p.ignore(known);
    const std::string texture = fresh(medium + "/density");
    add("TransformBegin", at);
    place(at, false, "medium");
    const Vec3 size = high - low;
    add(NewStatement("ConcatTransform", at)
            .list({size.x, 0, 0, 0, 0, size.y, 0, 0, 0, 0, size.z, 0, low.x, low.y, low.z, 1}));
    add(NewStatement("Texture", at)
            .name(texture)
            .name("float")
            .name("densitygrid")
            .set("integer nx", static_cast<int>(p.number("nx", 1)))
            .set("integer ny", static_cast<int>(p.number("ny", 1)))
            .set("integer nz", static_cast<int>(p.number("nz", 1)))
            .set("float density", std::move(values), &at)
            .set("string wrap", "black"));
    add("TransformEnd", at);
    return {texture, static_cast<float>(most)};
}

void Translator::medium_interface(Statement& statement) {
    state_.inside = take_name(statement, 0).text;
    state_.outside = statement.arguments.size() > 1 ? take_name(statement, 1).text : state_.inside;
    if (statement.arguments.size() > 2)
        throw InputError(statement.arguments[2].where, "MediumInterface takes two names at most");
}

}  // namespace lxs::pbrt
