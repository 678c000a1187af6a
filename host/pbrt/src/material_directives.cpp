// Directives Material, MakeNamedMaterial and NamedMaterial.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "lxs/spectrum/reflectance_colour.h"
#include "translator.h"

namespace lxs::pbrt {
namespace {

/// Least roughness of our facets; what is smoother looks like it.
constexpr double kLeastRoughness = 0.006;

const std::vector<std::string>& known_materials() {
    static const std::vector<std::string> known{
        "coatedconductor",     "coateddiffuse", "conductor", "dielectric", "diffuse",
        "diffusetransmission", "hair",          "interface", "measured",   "mix",
        "subsurface",          "thindielectric"};
    return known;
}

/// GGX' alpha of a roughness that is to be remapped.
double remapped(double roughness, bool version_3) {
    if (!version_3) return std::sqrt(std::max(roughness, 0.0));
    const double x = std::log(std::max(roughness, 1e-3));
    return 1.62142 + x * (0.819955 + x * (0.1734 + x * (0.0171201 + x * 0.000640711)));
}

/// Diffuse reflectance of a medium under a dielectric, by Jensen et al. 2001, equation 15.
double diffusion_albedo(double absorption, double reduced_scattering, double eta) {
    const double extinction = absorption + reduced_scattering;
    if (!(extinction > 0)) return 0;
    const double albedo = reduced_scattering / extinction;
    const double f = -1.440 / (eta * eta) + 0.710 / eta + 0.668 + 0.0636 * eta;
    const double a = (1 + f) / (1 - f), root = std::sqrt(3 * (1 - albedo));
    return albedo / 2 * (1 + std::exp(-4.0 / 3 * a * root)) * std::exp(-root);
}

}  // namespace

void Translator::material(Statement& statement) {
    Parameters p = take(statement, "material");
    const std::string file = std::filesystem::path(statement.where.file->name).filename().string();
    const std::string name = fresh(fmt::format(
        "{} ({}:{})", p.plugin().empty() ? "interface" : p.plugin(), file, statement.where.line));
    state_.material = write_material(name, p);
}

void Translator::make_named_material(Statement& statement) {
    const Name name = take_name(statement, 0);
    ParameterSet set = take_parameters(statement, 1, name);
    Parameters typed(set, defaults("material"), *state_.space, diagnostics_);
    if (!typed.given("type"))
        throw InputError(name.where, "MakeNamedMaterial needs \"string type\"");
    set.plugin = typed.text("type", "");
    set.where = typed.where("type");
    Parameters p(std::move(set), defaults("material"), *state_.space, diagnostics_);
    p.ignore("type");
    named_materials_.insert_or_assign(name.text, write_material(name.text, p));
}

void Translator::named_material(Statement& statement) {
    const Name name = take_only_name(statement);
    const auto found = named_materials_.find(name.text);
    if (found == named_materials_.end()) {
        std::vector<std::string> known;
        for (const auto& entry : named_materials_)
            known.push_back(entry.first);
        throw IgnoredStatement(name.where, unknown_name_message("material", name.text, known));
    }
    state_.material = found->second;
}

const MaterialUse& Translator::default_material(const SourceLocation& where) {
    if (!default_material_) {
        default_material_ = MaterialUse{"default", false};
        add(NewStatement("MakeNamedMaterial", where)
                .name("default")
                .set("string type", "matte")
                .set("color Kd", Rgb(0.5f)));
    }
    return *default_material_;
}

Translator::Roughness Translator::roughness(Parameters& p, const std::string& prefix,
                                            double fallback) {
    const bool remap = p.flag("remaproughness", true);
    Roughness result;
    const auto read = [&](const char* axis, std::optional<double>& number, std::string& texture) {
        const std::string own = prefix + axis, both = prefix + "roughness";
        const std::string& name = p.given(own) ? own : both;
        if (const auto named = p.texture(name)) {
            const auto constant = float_constants_.find(named->text);
            if (constant != float_constants_.end()) {
                number = remap ? remapped(constant->second, version_3_) : constant->second;
                return;
            }
            texture = float_texture(named->text);
            if (!remap) return;
            const auto image = float_images_.find(named->text);
            const std::string root = named->text + "/root";
            if (image == float_images_.end()) {
                warn(p.where(name), "a roughness that is not an image or a number is not remapped");
            } else {
                if (float_roots_.insert(root).second) write_root(image->second, root);
                texture = root;
            }
            return;
        }
        const double value = p.number(name, fallback);
        number = std::clamp(remap ? remapped(value, version_3_ && value > 0) : value, 0.0, 1.0);
    };
    read("uroughness", result.u, result.u_texture);
    read("vroughness", result.v, result.v_texture);
    p.ignore(prefix + "roughness");
    return result;
}

void Translator::write_root(const Statement& image, const std::string& name) {
    Statement root = image;
    root.arguments[0].values = Strings{name};
    // A root of the value: half of the exponent, and of the gain's logarithm.
    for (std::size_t i = 3; i + 1 < root.arguments.size(); i += 2) {
        Argument& value = root.arguments[i + 1];
        const std::string head = std::get<Strings>(root.arguments[i].values).front();
        if (head == "float gamma") value.values = Numbers{std::get<Numbers>(value.values)[0] / 2};
        if (head == "float gain")
            value.values = Numbers{std::sqrt(std::get<Numbers>(value.values)[0])};
        // sRGB's curve is nearly an exponent of 2.2.
        if (head == "string colorspace" &&
            std::get<Strings>(value.values).front() == "srgb_texels") {
            root.arguments[i].values = Strings{"float gamma"};
            value.values = Numbers{1.1};
        }
    }
    add(std::move(root));
}

void Translator::set_roughness(NewStatement& made, const Roughness& r, double least) const {
    const auto set = [&](const char* number, const char* texture,
                         const std::optional<double>& value, const std::string& named) {
        if (value)
            made.set(number, std::max(*value, least));
        else
            made.set(texture, named);
    };
    set("float uroughness", "texture uroughness", r.u, r.u_texture);
    set("float vroughness", "texture vroughness", r.v, r.v_texture);
}

void Translator::set_facets(NewStatement& made, const Roughness& rough) const {
    set_roughness(made, rough, kLeastRoughness);
    made.set("string distribution", "ggx");
}

void Translator::set_look(NewStatement& made, const char* target, const Parameters& p,
                          std::string_view name, const Rgb& fallback, double factor) {
    if (const auto texture = p.texture(name)) {
        std::string named = texture->text;
        if (factor != 1) {
            const std::string scaled = fresh(named + "/scaled");
            NewStatement times("Texture", p.where(name));
            times.name(scaled).name("color").name("scale").set("texture tex1", named);
            add(std::move(times.set("color tex2", Rgb(static_cast<float>(factor)))));
            named = scaled;
        }
        made.set(fmt::format("texture {}", target).c_str(), named, &p.where(name));
        return;
    }
    const Rgb colour =
        spectra_.colour(p, name, ColourOf::Surface, fallback) * static_cast<float>(factor);
    made.set(fmt::format("color {}", target).c_str(),
             reflectance_of_colour(
                 Rgb(std::min(colour.x, 1.0f), std::min(colour.y, 1.0f), std::min(colour.z, 1.0f))),
             &p.where(name));
}

namespace {

NewStatement begun(const std::string& name, const char* type, const SourceLocation& where) {
    NewStatement made("MakeNamedMaterial", where);
    made.name(name).set("string type", type);
    return made;
}

}  // namespace

double Translator::index_of(const Parameters& p, std::string_view name) {
    const ParameterValue* const value = p.value(name);
    if (value == nullptr) return 1.5;
    if (value->type == "texture") {
        const auto constant = float_constants_.find(p.text(name, ""));
        if (constant != float_constants_.end()) return constant->second;
        warn(value->where, "a texture of an index is not rendered: 1.5 is used");
        return 1.5;
    }
    if (value->type == "float") return p.number(name, 1.5);
    const Rgb rgb = spectra_.colour(p, name, ColourOf::Surface, Rgb(1.5f));
    return (double(rgb.x) + double(rgb.y) + double(rgb.z)) / 3;
}

double Translator::coat_thickness(Parameters& p) {
    if (p.given("albedo") &&
        (p.texture("albedo") ||
         !is_black(spectra_.colour(p, "albedo", ColourOf::Surface, Rgb(0.0f)))))
        p.leave_out("albedo", "the coat is clear");
    for (const char* of_samples : {"albedo", "g", "nsamples"})
        p.ignore(of_samples);
    double thickness = 0.01;
    if (const auto texture = p.texture("thickness")) {
        const auto constant = float_constants_.find(texture->text);
        if (constant == float_constants_.end())
            p.leave_out("thickness", "0.01 is used");
        else
            thickness = constant->second;
    } else {
        thickness = p.number("thickness", thickness);
    }
    return std::max(thickness, 0.0);
}

NewStatement Translator::coated_diffuse(const std::string& name, Parameters& p) {
    const Roughness rough = roughness(p, "", version_3_words_ ? 0.1 : 0);
    NewStatement made = begun(name, "coateddiffuse", p.where());
    set_look(made, "Kd", p, "reflectance", Rgb(0.5f));
    made.set("float index", std::max(index_of(p, "eta"), 1.0), &p.where("eta"));
    made.set("float thickness", coat_thickness(p), &p.where("thickness"));
    made.set("integer maxdepth", std::max(p.integer("maxdepth", 10), 2), &p.where("maxdepth"));
    set_roughness(made, rough, kLeastRoughness);
    return made;
}

NewStatement Translator::conductor(const std::string& name, Parameters& p,
                                   const std::string& prefix, double outside) {
    const Roughness rough = roughness(p, prefix, version_3_words_ ? 0.01 : 0);
    const std::string eta = prefix + "eta", k = prefix + "k";
    const bool by_reflectance = p.given("reflectance");
    if (by_reflectance && (p.given(eta) || p.given(k)))
        p.fail("reflectance", "a conductor takes either \"reflectance\" or \"eta\" and \"k\"");
    const auto spectrum_name = [&](const std::string& of) -> std::string {
        const ParameterValue* const value = p.value(of);
        if (value == nullptr) return of == eta ? "metal-Cu-eta" : "metal-Cu-k";
        const auto* texts = std::get_if<Strings>(&value->values);
        return value->type == "spectrum" && texts != nullptr && !texts->empty() ? texts->front()
                                                                                : "";
    };
    const auto preset = metal_preset(spectrum_name(eta)), other = metal_preset(spectrum_name(k));
    const std::string fresnel = fresh(name + "/fresnel");
    NewStatement constants("Texture", p.where());
    constants.name(fresnel).name("fresnel");
    const auto by = static_cast<float>(outside);
    if (by_reflectance) {
        constants.name("fresnelcolor");
        if (const auto named = p.texture("reflectance")) {
            if (outside != 1)
                warn(p.where("reflectance"),
                     "a texture of a coated metal's reflectance is that of the metal in air");
            constants.set("texture Kr", named->text, &p.where("reflectance"));
        } else {
            // As pbrt: of index 1, with the extinction that reflects so much at normal incidence.
            Rgb extinction = spectra_.colour(p, "reflectance", ColourOf::Surface, Rgb(1.0f));
            for (int c = 0; c < 3; ++c) {
                const float r = std::clamp(extinction[c], 0.0f, 0.9999f);
                extinction[c] = 2 * std::sqrt(r / (1 - r));
            }
            constants.set("color n", Rgb(1.0f) / by)
                .set("color k", extinction / by, &p.where("reflectance"));
        }
    } else if (preset && preset == other && outside == 1) {
        constants.name("preset").set("string name", *preset);
    } else {
        if (p.texture(eta) || p.texture(k))
            p.fail(eta, "a texture of a metal's index is not rendered");
        constants.name("fresnelcolor")
            .set("color n",
                 spectra_.colour(p, eta, ColourOf::Surface, Rgb(0.200f, 0.924f, 1.102f)) / by)
            .set("color k",
                 spectra_.colour(p, k, ColourOf::Surface, Rgb(3.913f, 2.453f, 2.142f)) / by);
    }
    add(std::move(constants));
    NewStatement made = begun(name, rough.smooth() ? "mirror" : "metal2", p.where());
    made.set("texture fresnel", fresnel);
    if (!rough.smooth()) set_facets(made, rough);
    return made;
}

NewStatement Translator::coated_conductor(const std::string& name, Parameters& p) {
    const double index = std::max(index_of(p, "interface.eta"), 1.0);
    const std::string metal = fresh(name + "/conductor"), coat = fresh(name + "/interface"),
                      both = fresh(name + "/coated");
    add(conductor(metal, p, "conductor.", index));
    const Roughness rough = roughness(p, "interface.", 0);
    NewStatement interface = begun(coat, rough.smooth() ? "glass" : "roughglass", p.where());
    interface.set("float index", index, &p.where("interface.eta"));
    if (!rough.smooth()) set_facets(interface, rough);
    add(std::move(interface));
    add(std::move(begun(both, "layered", p.where())
                      .set("string namedmaterial1", coat)
                      .set("string namedmaterial2", metal)
                      .set("float thickness", coat_thickness(p), &p.where("thickness"))));
    p.ignore("maxdepth");
    // Either side is coated.
    return std::move(begun(name, "doubleside", p.where()).set("string frontnamedmaterial", both));
}

NewStatement Translator::dielectric(const std::string& name, Parameters& p) {
    p.rename("index", "eta");
    const Roughness rough = roughness(p, "", 0);
    const std::string glass = p.value("eta") != nullptr && p.value("eta")->type == "spectrum" &&
                                      std::holds_alternative<Strings>(p.value("eta")->values)
                                  ? p.text("eta", "")
                                  : "";
    NewStatement made = begun(name, rough.smooth() ? "glass" : "roughglass", p.where());
    if (const auto known = glass_by_name(glass)) {
        made.set("float index", known->cauchy_a()).set("float cauchyb", known->cauchy_b());
        if (!rough.smooth()) made.set("bool dispersion", "true");
    } else {
        made.set("float index", index_of(p, "eta"), &p.where("eta"));
    }
    if (p.given("Kr")) set_look(made, "Kr", p, "Kr", Rgb(1.0f));
    if (p.given("Kt")) set_look(made, "Kt", p, "Kt", Rgb(1.0f));
    if (!rough.smooth()) set_facets(made, rough);
    return made;
}

NewStatement Translator::mix(const std::string& name, Parameters& p) {
    Strings materials = p.texts("materials");
    if (p.given("namedmaterial1") || p.given("namedmaterial2")) {  // version 3, the other way round
        materials = {p.text("namedmaterial2", ""), p.text("namedmaterial1", "")};
        version_3_words_ = true;
    }
    if (materials.size() != 2)
        p.fail("materials", "mix takes two names: \"string materials\" [\"a\" \"b\"]");
    NewStatement made = begun(name, "mix", p.where());
    for (std::size_t i = 0; i < 2; ++i) {
        const auto found = named_materials_.find(materials[i]);
        if (found == named_materials_.end())
            p.fail("materials", unknown_name("material", materials[i]));
        made.set(i == 0 ? "string namedmaterial1" : "string namedmaterial2", found->second.name,
                 &p.where("materials"));
    }
    if (const auto texture = p.texture("amount")) {
        made.set("texture amount", float_texture(texture->text), &p.where("amount"));
    } else {
        const Rgb amount = spectra_.colour(p, "amount", ColourOf::Surface, Rgb(0.5f));
        made.set("float amount",
                 std::clamp((double(amount.x) + double(amount.y) + double(amount.z)) / 3, 0.0, 1.0),
                 &p.where("amount"));
    }
    return made;
}

NewStatement Translator::hair(const std::string& name, Parameters& p) {
    // Absorption of the two pigments per unit of concentration, for R, G and B (d'Eon et al. 2011).
    const Rgb eumelanin(0.419f, 0.697f, 1.37f), pheomelanin(0.187f, 0.4f, 1.05f);
    constexpr float kDepth =
        0.8f;  // of the absorption's root that darkens diffuse light like a fibre
    const bool by_colour = p.given("reflectance") || p.given("color");
    p.rename("color", "reflectance");
    Rgb colour(0.0f);
    if (!by_colour) {
        const bool by_pigments = p.given("eumelanin") || p.given("pheomelanin");
        Rgb absorption =
            eumelanin * static_cast<float>(p.number("eumelanin", by_pigments ? 0 : 1.3)) +
            pheomelanin * static_cast<float>(p.number("pheomelanin", 0));
        if (p.given("sigma_a"))
            absorption = spectra_.colour(p, "sigma_a", ColourOf::Surface, absorption);
        for (int c = 0; c < 3; ++c)
            colour[c] = std::exp(-kDepth * std::sqrt(std::max(absorption[c], 0.0f)));
    }
    for (const char* known : {"eta", "beta_m", "beta_n", "alpha"})
        p.ignore(known);
    tell_once(p.where(),
              "material \"hair\" is not rendered: glossy fibres that let half of their light "
              "through are used");
    NewStatement made = begun(name, "glossytranslucent", p.where());
    set_look(made, "Kd", p, "reflectance", colour, 0.5);
    set_look(made, "Kt", p, "reflectance", colour, 0.5);
    made.set("color Ks", Rgb(0.046f)).set("float uroughness", 0.3).set("float vroughness", 0.3);
    return made;
}

NewStatement Translator::subsurface(const std::string& name, Parameters& p) {
    const double eta = p.given("eta") ? std::max(index_of(p, "eta"), 1.0) : 1.33;
    const Roughness rough = roughness(p, "", 0);
    const auto coefficient = [&](const char* of, const Rgb& usual) {
        return p.texture(of) ? usual : spectra_.colour(p, of, ColourOf::Surface, usual);
    };
    Rgb albedo(0.5f);
    if (!p.given("reflectance")) {
        const Rgb a = coefficient("sigma_a", Rgb(0.0011f, 0.0024f, 0.014f));
        const Rgb s = coefficient("sigma_s", Rgb(2.55f, 3.21f, 3.77f));
        const double g = std::clamp(p.number("g", 0), -0.999, 0.999);
        for (int c = 0; c < 3; ++c)
            albedo[c] = static_cast<float>(diffusion_albedo(a[c], double(s[c]) * (1 - g), eta));
    }
    for (const char* known : {"mfp", "name", "scale", "g", "sigma_a", "sigma_s"})
        p.ignore(known);
    tell_once(p.where(),
              "material \"subsurface\" is not rendered: a glossy surface of the colour that "
              "diffusion gives is used");
    NewStatement made = begun(name, "glossy", p.where());
    set_look(made, "Kd", p, "reflectance", albedo);
    made.set("color Ks", Rgb(1.0f)).set("float index", eta);
    made.set("bool conserving", "true").set("string fresnel", "dielectric");
    set_roughness(made, rough, kLeastRoughness);
    return made;
}

void Translator::upgrade_material(Parameters& p, std::string& type) {
    static const std::map<std::string, std::string> new_names{
        {"disney", "diffuse"},          {"fourier", "measured"},
        {"glass", "dielectric"},        {"kdsubsurface", "subsurface"},
        {"matte", "diffuse"},           {"metal", "conductor"},
        {"none", "interface"},          {"plastic", "coateddiffuse"},
        {"substrate", "coateddiffuse"}, {"translucent", "diffusetransmission"},
        {"uber", "coateddiffuse"},      {"", "interface"}};
    p.rename("bumpmap", "displacement");
    const auto found = new_names.find(type);
    version_3_words_ = found != new_names.end() && !type.empty();
    if (found == new_names.end()) return;
    if (type == "disney") p.rename("color", "reflectance");
    if (type == "matte" || type == "plastic" || type == "substrate" || type == "uber" ||
        type == "kdsubsurface")
        p.rename("Kd", "reflectance");
    if (type == "plastic" || type == "uber" || type == "substrate") {
        p.rename("index", "eta");
        const bool black = p.given("Ks") && !p.texture("Ks") &&
                           is_black(spectra_.colour(p, "Ks", ColourOf::Surface, Rgb(1.0f)));
        p.ignore("Ks");
        if (black) {
            type = "diffuse";
            for (const char* known :
                 {"eta", "roughness", "uroughness", "vroughness", "remaproughness"})
                p.ignore(known);
            return;
        }
        for (const char* other : {"Kr", "Kt"}) {
            if (!p.given(other)) continue;
            const bool none = !p.texture(other) &&
                              is_black(spectra_.colour(p, other, ColourOf::Surface, Rgb(0.0f)));
            if (!none) p.leave_out(other, "the rest of the material is");
        }
    }
    if (type == "disney")
        for (const char* known : {"anisotropic", "clearcoat", "clearcoatgloss", "difftrans", "eta",
                                  "flatness", "metallic", "roughness", "scatterdistance", "sheen",
                                  "sheentint", "spectrans", "speculartint", "thin"})
            p.ignore(known);
    if (type == "disney" || type == "fourier" || type == "translucent")
        tell_once(p.where(), fmt::format("material \"{}\" of version 3 is read as \"{}\"", type,
                                         found->second));
    type = found->second;
}

MaterialUse Translator::write_material(const std::string& name, Parameters& p) {
    std::string type = p.plugin();
    const bool is_translucent = type == "translucent";
    if (type == "mirror") {  // version 3
        NewStatement made = begun(name, "mirror", p.where());
        p.rename("bumpmap", "displacement");
        set_look(made, "Kr", p, "Kr", Rgb(0.9f));
        set_bump(made, name, p);
        p.report_unused("material");
        add(std::move(made));
        return {name, false};
    }
    upgrade_material(p, type);
    const std::vector<std::string>& known = known_materials();
    if (std::find(known.begin(), known.end(), type) == known.end()) {
        diagnostics_.fallback(p.where(), unknown_name_message("material", type, known),
                              "a grey of 0.5 is used");
        p.rest();
        type = "unknown";
    }
    NewStatement made("", p.where());
    if (type == "diffuse") {
        made = begun(name, "matte", p.where());
        set_look(made, "Kd", p, "reflectance", Rgb(0.5f));
        if (const auto sigma = p.texture("sigma"))
            made.set("texture sigma", float_texture(sigma->text));
        else if (p.given("sigma"))
            made.set("float sigma", p.number("sigma", 0));
    } else if (type == "coateddiffuse") {
        made = coated_diffuse(name, p);
    } else if (type == "conductor") {
        made = conductor(name, p, "", 1);
    } else if (type == "coatedconductor") {
        made = coated_conductor(name, p);
    } else if (type == "dielectric") {
        made = dielectric(name, p);
    } else if (type == "thindielectric") {
        made = begun(name, "glass", p.where());
        made.set("float index", index_of(p, "eta"), &p.where("eta"))
            .set("bool architectural", "true")
            .set("bool pane", "true");
        for (const char* ignored : {"roughness", "remaproughness"})
            p.ignore(ignored);
    } else if (type == "diffusetransmission") {
        made = begun(name, "mattetranslucent", p.where());
        if (is_translucent) {  // shares of Kd
            const Rgb reflect = spectra_.colour(p, "reflect", ColourOf::Surface, Rgb(0.5f));
            const Rgb transmit = spectra_.colour(p, "transmit", ColourOf::Surface, Rgb(0.5f));
            set_look(made, "Kr", p, "Kd", Rgb(0.25f), luminance(reflect));
            set_look(made, "Kt", p, "Kd", Rgb(0.25f), luminance(transmit));
            for (const char* ignored : {"Ks", "roughness", "remaproughness"})
                p.ignore(ignored);
        } else {
            const double scale = p.number("scale", 1);
            set_look(made, "Kr", p, "reflectance", Rgb(0.25f), scale);
            set_look(made, "Kt", p, "transmittance", Rgb(0.25f), scale);
        }
    } else if (type == "mix") {
        made = mix(name, p);
    } else if (type == "hair") {
        made = hair(name, p);
    } else if (type == "subsurface") {
        made = subsurface(name, p);
    } else if (type == "unknown") {
        made = begun(name, "matte", p.where());
        made.set("color Kd", Rgb(0.5f));
    } else if (type == "measured") {
        for (const char* ignored : {"filename", "bsdffile"})
            p.ignore(ignored);
        tell_once(p.where(), "material \"measured\" is not rendered: a grey of 0.5 is used");
        made = begun(name, "matte", p.where());
        made.set("color Kd", Rgb(0.5f));
    } else {
        made = begun(name, "null", p.where());
    }
    if (type != "interface") set_bump(made, name, p);
    cut_by_opacity(made, name, p);
    p.report_unused("material");
    add(std::move(made));
    return {name, type == "interface"};
}

const std::string& Translator::nothing(const SourceLocation& where) {
    if (nothing_.empty()) {
        nothing_ = fresh("nothing");
        add(NewStatement("MakeNamedMaterial", where).name(nothing_).set("string type", "null"));
    }
    return nothing_;
}

void Translator::cut_by_opacity(NewStatement& made, const std::string& name, Parameters& p) {
    if (!p.given("opacity")) return;
    const SourceLocation& at = p.where("opacity");
    std::string texture;
    double opacity = 1;
    if (const auto named = p.texture("opacity")) {
        texture = float_texture(named->text);
    } else {
        const Rgb colour = spectra_.colour(p, "opacity", ColourOf::Surface, Rgb(1.0f));
        opacity = (double(colour.x) + double(colour.y) + double(colour.z)) / 3;
        if (opacity >= 1) return;
    }
    const std::string whole = fresh(name + "/opaque");
    Statement renamed = made.take();
    renamed.arguments[0].values = Strings{whole};
    add(std::move(renamed));
    made = begun(name, "mix", at);
    made.set("string namedmaterial1", nothing(at)).set("string namedmaterial2", whole);
    if (texture.empty()) {
        made.set("float amount", std::clamp(opacity, 0.0, 1.0));
    } else {
        made.set("texture amount", texture);
    }
}

void Translator::set_bump(NewStatement& made, const std::string& name, Parameters& p) {
    if (const auto height = p.texture("displacement")) {
        made.set("texture bumpmap", float_texture(height->text), &p.where("displacement"));
    } else if (p.given("normalmap")) {
        const std::string map = fresh(name + "/normals");
        const SourceLocation& at = p.where("normalmap");
        add(NewStatement("Texture", at)
                .name(map)
                .name("float")
                .name("normalmap")
                .set("string filename", p.text("normalmap", ""), &at)
                .set("float gamma", 1)
                .set("float vscale", -1)
                .set("float vdelta", 1));
        made.set("texture bumpmap", map, &at);
    }
    p.ignore("normalmap");
    p.ignore("displacement");
}

}  // namespace lxs::pbrt
