// Directives of media.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "medium_presets.h"
#include "translator.h"

namespace lxs::pbrt {
namespace {

/// The unit cube's place: that of the box between two corners.
Numbers box_matrix(const Vec3& low, const Vec3& high) {
    const Vec3 size = high - low;
    return {size.x, 0, 0, 0, 0, size.y, 0, 0, 0, 0, size.z, 0, low.x, low.y, low.z, 1};
}

}  // namespace

void Translator::make_named_medium(Statement& statement) {
    const Name name = take_name(statement, 0);
    ParameterSet set = take_parameters(statement, 1, name);
    Parameters p(std::move(set), defaults("medium"), *state_.space, diagnostics_);
    const std::string type = p.text("type", "homogeneous");
    static const std::vector<std::string> known_types{
        "homogeneous", "uniformgrid", "rgbgrid", "cloud", "nanovdb", "heterogeneous"};
    if (std::find(known_types.begin(), known_types.end(), type) == known_types.end())
        p.fail("type", unknown_name_message("medium", type, known_types));
    const auto scale = static_cast<float>(p.number("scale", 1));
    const Rgb shine = emission_of_medium(p, type) * scale;
    const double g = std::clamp(p.number("g", 0), -1.0, 1.0);
    NewStatement made("MakeNamedVolume", statement.where);
    made.name(name.text).name(type == "homogeneous" ? "homogeneous" : "heterogeneous");
    if (type == "homogeneous") {
        const Coefficients given = coefficients(p);
        made.set("color sigma_a", given.absorption * scale)
            .set("color sigma_s", given.scattering * scale);
        if (!is_black(shine)) made.set("color emission", given.absorption * shine);
    } else if (type == "rgbgrid") {
        for (const char* const head : {"sigma_a", "sigma_s"})
            made.set(fmt::format("texture {}", head).c_str(),
                     colour_grid(p, head, name.text, scale));
    } else {
        const Coefficients given = coefficients(p);
        const Density density = type == "cloud"     ? cloud(p, name.text)
                                : type == "nanovdb" ? filed_density(p, name.text)
                                                    : density_grid(p, name.text);
        std::vector<std::pair<const char*, Rgb>> parts{{"sigma_a", given.absorption * scale},
                                                       {"sigma_s", given.scattering * scale}};
        if (!is_black(shine)) parts.emplace_back("emission", given.absorption * shine);
        for (const auto& [head, colour] : parts) {
            const std::string texture = fresh(name.text + "/" + head);
            add(NewStatement("Texture", statement.where)
                    .name(texture)
                    .name("color")
                    .name("mix")
                    .set("texture amount", density.texture)
                    .set("color tex1", Rgb(0.0f))
                    .set("color tex2", colour * density.most));
            made.set(fmt::format("texture {}", head).c_str(), texture);
        }
    }
    add(std::move(made.set("float fresnel", 1).set("color g", Numbers{g, g, g})));
    p.report_unused("medium");
}

/// By name, or one by one.
Translator::Coefficients Translator::coefficients(const Parameters& p) {
    const std::string preset = p.text("preset", "");
    if (!preset.empty()) {
        if (const auto known = medium_preset(preset)) return {known->absorption, known->scattering};
        warn(p.where("preset"),
             fmt::format("there is no medium \"{}\": its coefficients count", preset));
    }
    return {spectra_.colour(p, "sigma_a", ColourOf::Surface, Rgb(1.0f)),
            spectra_.colour(p, "sigma_s", ColourOf::Surface, Rgb(1.0f))};
}

/// Radiance that a medium sends, over its absorption, where that is the same everywhere.
Rgb Translator::emission_of_medium(Parameters& p, const std::string& type) {
    for (const char* const grid : {"temperature", "temperaturename"})
        p.leave_out(grid, "media do not shine by temperature here");
    for (const char* const known : {"temperatureoffset", "temperaturescale", "temperaturecutoff"})
        p.ignore(known);
    const char* const scale = p.given("LeScale") ? "LeScale" : "Lescale";
    if (type == "cloud" || type == "rgbgrid" || type == "nanovdb") {
        p.leave_out("Le", "media of this type do not shine here");
        p.ignore(scale);
        return Rgb(0.0f);
    }
    if (!p.given("Le")) return Rgb(0.0f);
    const Numbers scales = p.numbers(scale);
    if (scales.size() > 1) {
        warn(p.where(scale), "a medium's light is not scaled by cells here: it does not shine");
        return Rgb(0.0f);
    }
    return spectra_.colour(p, "Le", ColourOf::Light, Rgb(0.0f)) *
           (scales.empty() ? 1.0f : float(scales.front()));
}

/// The box of a grid or cloud: its corners in the space of the medium.
Bounds Translator::medium_box(const Parameters& p) {
    return {p.point("p0").value_or(Vec3(0.0f)), p.point("p1").value_or(Vec3(1.0f))};
}

/// Writes a texture in the medium's space, moved on by `matrix`.
void Translator::add_in_medium(NewStatement texture, const SourceLocation& at, Numbers matrix) {
    add("TransformBegin", at);
    place(at, false, "medium");
    if (!matrix.empty()) add(NewStatement("ConcatTransform", at).list(std::move(matrix)));
    add(std::move(texture));
    add("TransformEnd", at);
}

/// Number of cells along each axis.
void Translator::set_cells(NewStatement& made, const Parameters& p) {
    for (const char* const n : {"nx", "ny", "nz"})
        made.set(fmt::format("integer {}", n).c_str(), static_cast<int>(p.number(n, 1)));
}

/// Writes a medium's grid as a texture of densities up to 1.
Translator::Density Translator::density_grid(Parameters& p, const std::string& medium) {
    Numbers values = p.numbers("density");
    if (values.empty()) p.fail("density", "a grid needs \"density\"");
    const SourceLocation at = p.where("density");
    const double most = std::max(*std::ranges::max_element(values), 0.0);
    for (double& value : values)
        value = most > 0 ? std::max(value, 0.0) / most : 0;
    const std::string texture = fresh(medium + "/density");
    NewStatement made("Texture", at);
    made.name(texture).name("float").name("densitygrid");
    made.set("string wrap", "black").set("bool cut", "true");
    set_cells(made, p);
    made.set("float density", std::move(values), &at);
    const Bounds box = medium_box(p);
    add_in_medium(std::move(made), at, box_matrix(box.min, box.max));
    return {texture, static_cast<float>(most)};
}

/// Writes one of the two grids of "rgbgrid", 1 everywhere in its box where it isn't given.
std::string Translator::colour_grid(Parameters& p, const char* name, const std::string& medium,
                                    float scale) {
    const bool given = p.given(name);
    const SourceLocation at = p.where(name);
    Numbers values = given ? p.numbers(name) : Numbers{1, 1, 1};
    for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
        const Rgb colour = surface_in(p.space(), Rgb(float(values[i]), float(values[i + 1]),
                                                     float(values[i + 2]))) *
                           scale;
        for (int c = 0; c < 3; ++c)
            values[i + std::size_t(c)] = double(std::max(colour[c], 0.0f));
    }
    std::string texture = fresh(medium + "/" + name);
    NewStatement made("Texture", at);
    made.name(texture).name("color").name("densitygrid");
    made.set("string wrap", given ? "black" : "clamp").set("bool cut", "true");
    if (given) set_cells(made, p);
    made.set("color density", std::move(values), &at);
    const Bounds box = medium_box(p);
    add_in_medium(std::move(made), at, box_matrix(box.min, box.max));
    return texture;
}

Translator::Density Translator::cloud(const Parameters& p, const std::string& medium) {
    const SourceLocation& at = p.where("type");
    const std::string noise = fresh(medium + "/noise"), box = fresh(medium + "/box");
    NewStatement made("Texture", at);
    made.name(noise).name("float").name("noisecloud");
    for (const auto& [name, fallback] :
         {std::pair("density", 1.0), {"wispiness", 1.0}, {"frequency", 5.0}})
        made.set(fmt::format("float {}", name).c_str(), p.number(name, fallback));
    add_in_medium(std::move(made), at, {});
    const Bounds around = medium_box(p);
    add_in_medium(std::move(NewStatement("Texture", at)
                                .name(box)
                                .name("float")
                                .name("densitygrid")
                                .set("float density", 1)
                                .set("string wrap", "clamp")
                                .set("bool cut", "true")),
                  at, box_matrix(around.min, around.max));
    const std::string texture = fresh(medium + "/density");
    add(NewStatement("Texture", at)
            .name(texture)
            .name("float")
            .name("scale")
            .set("texture tex1", noise)
            .set("texture tex2", box));
    return {texture, 1};
}

Translator::Density Translator::filed_density(const Parameters& p, const std::string& medium) {
    if (!p.given("filename")) p.fail("filename", "medium \"nanovdb\" needs a file");
    const SourceLocation& at = p.where("filename");
    const std::string texture = fresh(medium + "/density");
    add_in_medium(std::move(NewStatement("Texture", at)
                                .name(texture)
                                .name("float")
                                .name("densitygrid")
                                .set("string filename", p.text("filename", ""), &at)
                                .set("string gridname", p.text("gridname", "density"))),
                  at, {});
    return {texture, 1};
}

void Translator::medium_interface(Statement& statement) {
    state_.inside = take_name(statement, 0).text;
    state_.outside = statement.arguments.size() > 1 ? take_name(statement, 1).text : state_.inside;
    if (statement.arguments.size() > 2)
        throw InputError(statement.arguments[2].where, "MediumInterface takes two names at most");
}

}  // namespace lxs::pbrt
