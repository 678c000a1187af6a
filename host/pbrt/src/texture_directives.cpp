// Directive Texture.
#include <fmt/format.h>

#include <algorithm>

#include "lxs/spectrum/reflectance_colour.h"
#include "translator.h"

namespace lxs::pbrt {
namespace {

const char* type_of(bool is_float) {
    return is_float ? "float" : "color";
}

}  // namespace

bool is_eight_bit(const std::string& file) {
    const std::size_t dot = file.find_last_of('.');
    if (dot == std::string::npos) return false;
    std::string end = file.substr(dot + 1);
    std::transform(end.begin(), end.end(), end.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return end == "png" || end == "tga" || end == "jpg" || end == "jpeg" || end == "bmp" ||
           end == "gif";
}

void Translator::texture(Statement& statement) {
    const Name name = take_name(statement, 0);
    const Name type = take_name(statement, 1);
    const Name plugin = take_name(statement, 2);
    const bool is_float = type.text == "float";
    if (!is_float && type.text != "spectrum" && type.text != "color") {
        throw InputError(type.where,
                         unknown_name_message("type of texture", type.text, {"float", "spectrum"}));
    }
    Parameters p(take_parameters(statement, 3, plugin), defaults("texture"), *state_.space,
                 diagnostics_);
    add("TransformBegin", plugin.where);
    place(plugin.where, false, "texture");
    // The scope ends whatever the texture holds.
    try {
        write_texture(name, is_float, p);
    } catch (const InputError&) {
        add("TransformEnd", plugin.where);
        throw;
    }
    add("TransformEnd", plugin.where);
    p.report_unused("texture");
}

void Translator::set_term(NewStatement& made, const char* target, const Parameters& p,
                          std::string_view name, bool is_float, double fallback) {
    if (const auto texture = p.texture(name)) {
        made.set(fmt::format("texture {}", target).c_str(),
                 is_float ? float_texture(texture->text) : texture->text, &p.where(name));
    } else if (is_float) {
        made.set(fmt::format("float {}", target).c_str(), p.number(name, fallback), &p.where(name));
    } else {
        const Rgb colour =
            spectra_.colour(p, name, ColourOf::Surface, Rgb(static_cast<float>(fallback)));
        made.set(fmt::format("color {}", target).c_str(), reflectance_of_colour(colour),
                 &p.where(name));
    }
}

std::string Translator::float_texture(const std::string& name) {
    const auto image = colour_images_.find(name);
    if (float_textures_.contains(name) || image == colour_images_.end()) return name;
    std::string grey = name + "/grey";
    if (!float_textures_.insert(grey).second) return grey;
    Statement made = image->second;
    made.arguments[0].values = Strings{grey};
    made.arguments[1].values = Strings{"float"};
    for (std::size_t i = 3; i + 1 < made.arguments.size(); i += 2) {
        if (std::get<Strings>(made.arguments[i].values).front() != "bool plaincolors") continue;
        made.arguments.erase(made.arguments.begin() + static_cast<std::ptrdiff_t>(i),
                             made.arguments.begin() + static_cast<std::ptrdiff_t>(i) + 2);
        break;
    }
    add(std::move(made));
    return grey;
}

void Translator::set_mapping(NewStatement& made, Parameters& p, bool of_image) {
    const std::string mapping = p.text("mapping", "uv");
    static const std::vector<std::string> known_mappings{"uv", "spherical", "cylindrical",
                                                         "planar"};
    if (std::find(known_mappings.begin(), known_mappings.end(), mapping) == known_mappings.end())
        p.fail("mapping", unknown_name_message("mapping", mapping, known_mappings));
    const double su = p.number("uscale", 1), sv = p.number("vscale", 1);
    const double du = p.number("udelta", 0), dv = p.number("vdelta", 0);
    // Along u pbrt's spherical mapping has the polar angle.
    made.set("string mapping", mapping == "spherical" ? "polar" : mapping, &p.where("mapping"));
    if (mapping == "cylindrical") made.set("float turnstart", 0.5);
    if (mapping == "planar") {
        // Along the vectors in the texture's space, which ours measures in the world's.
        Vec3 v1 = p.point("v1").value_or(Vec3(1, 0, 0)), v2 = p.point("v2").value_or(Vec3(0, 1, 0));
        const Matrix to_texture = version_3_ ? Matrix() : state_.transforms[0].inverse();
        const auto in_world = [&](const Vec3& v) {
            Numbers row;
            for (int i = 0; i < 3; ++i)
                row.push_back(to_texture[i][0] * double(v.x) + to_texture[i][1] * double(v.y) +
                              to_texture[i][2] * double(v.z));
            return row;
        };
        const auto shift = [&](const Vec3& v) {
            return to_texture[3][0] * double(v.x) + to_texture[3][1] * double(v.y) +
                   to_texture[3][2] * double(v.z);
        };
        const double s = du + shift(v1), t = dv + shift(v2);
        Numbers along_t = in_world(v2);
        if (of_image)
            for (double& x : along_t)
                x = -x;
        made.set("vector v1", in_world(v1)).set("vector v2", along_t);
        made.set("float udelta", s).set("float vdelta", of_image ? 1 - t : t);
        return;
    }
    made.set("float uscale", su, &p.where("uscale")).set("float udelta", du, &p.where("udelta"));
    // The image's rows go down where v goes up.
    made.set("float vscale", of_image ? -sv : sv, &p.where("vscale"));
    made.set("float vdelta", of_image ? 1 - dv : dv, &p.where("vdelta"));
}

void Translator::image_texture(NewStatement& made, Parameters& p, bool is_float) {
    const std::string file = p.text("filename", "");
    if (file.empty()) p.fail("filename", "imagemap needs a file: \"string filename\" \"...\"");
    made.set("string filename", file, &p.where("filename"));
    std::string encoding = p.text("encoding", is_eight_bit(file) ? "sRGB" : "linear");
    if (p.given("gamma"))  // version 3: a bool, or the exponent before that
        encoding = p.flag("gamma", true) ? "sRGB" : "linear";
    double gamma = 1;
    if (encoding == "sRGB") {
        made.set("string colorspace", "srgb_texels");
    } else {
        if (encoding.starts_with("gamma "))
            gamma = std::atof(encoding.c_str() + 6);
        else if (encoding != "linear")
            p.fail("encoding",
                   unknown_name_message("encoding", encoding, {"sRGB", "linear", "gamma 2.2"}));
        made.set("float gamma", gamma, &p.where("encoding"));
        if (gamma != 1) made.set("string colorspace", "gamma_texels");
    }
    double gain = 1;
    if (const auto texture = p.texture("scale"))
        throw InputError(texture->where, "\"scale\" of an imagemap takes a number");
    gain = p.number("scale", 1);
    made.set("float gain", gain, &p.where("scale"));
    made.set("string wrap",
             p.text("wrap", "repeat") == "octahedralsphere" ? "clamp" : p.text("wrap", "repeat"),
             &p.where("wrap"));
    const std::string filter = p.text("filter", "bilinear");
    made.set("string filtertype", filter == "point" ? "nearest" : "bilinear");
    for (const char* known : {"maxanisotropy", "trilinear"})
        p.ignore(known);
    if (!is_float) made.set("bool plaincolors", "true");
    set_mapping(made, p, true);
}

Strings Translator::along_normal(const Vec3& direction) const {
    Imath::V3d world;
    state_.transforms[0].multDirMatrix(Imath::V3d(direction), world);
    world.normalize();
    return {"normal", fmt::format("vector dot_product r0 {} {} {}", world.x, world.y, world.z),
            "math absolute r1 0 0"};
}

void Translator::write_texture(const Name& name, bool is_float, Parameters& p) {
    const std::string type = p.plugin();
    const SourceLocation& at = p.where();
    if (is_float) float_textures_.insert(name.text);
    NewStatement made("Texture", at);
    const auto begin = [&](const std::string& of, bool as_float, const char* plugin) {
        made = NewStatement("Texture", at);
        made.name(of).name(type_of(as_float)).name(plugin);
    };
    // A pattern of numbers in our language; colours come from a mix by it.
    const auto pattern = [&](const char* plugin) {
        std::string of = is_float ? name.text : fresh(name.text + "/pattern");
        begin(of, true, plugin);
        return of;
    };
    const auto mix_by = [&](const std::string& amount, const char* first, double first_fallback,
                            const char* second, double second_fallback) {
        begin(name.text, false, "mix");
        made.set("texture amount", amount);
        set_term(made, "tex1", p, first, false, first_fallback);
        set_term(made, "tex2", p, second, false, second_fallback);
        add(std::move(made));
    };
    if (type == "imagemap") {
        begin(name.text, is_float, "imagemap");
        image_texture(made, p, is_float);
        if (!p.flag("invert", false)) {
            Statement image = made.take();
            (is_float ? float_images_ : colour_images_).insert_or_assign(name.text, image);
            add(std::move(image));
            return;
        }
        const std::string upright = fresh(name.text + "/not inverted");
        begin(upright, is_float, "imagemap");
        image_texture(made, p, is_float);
        add(std::move(made));
        NewStatement inverted("Texture", at);
        inverted.name(name.text).name(type_of(is_float)).name("subtract");
        inverted.set(is_float ? "float tex1" : "color tex1",
                     is_float ? Numbers{1} : Numbers{1, 1, 1});
        add(std::move(inverted.set("texture tex2", upright)));
    } else if (type == "constant") {
        begin(name.text, is_float, "constant");
        if (is_float) {
            const double value = p.number("value", 1);
            float_constants_[name.text] = value;
            made.set("float value", value, &p.where("value"));
        } else {
            const Rgb value = spectra_.colour(p, "value", ColourOf::Surface, Rgb(1.0f));
            made.set("color value", reflectance_of_colour(value), &p.where("value"));
        }
        add(std::move(made));
    } else if (type == "scale") {
        begin(name.text, is_float, "scale");
        p.rename("tex1", "tex");
        p.rename("tex2", "scale");
        set_term(made, "tex1", p, "tex", is_float, 1);
        const auto factor = p.texture("scale");
        if (factor && !is_float && p.value("scale") != nullptr && !version_3_) {
            // A number's texture as a factor of a colour.
            const std::string grey = fresh(name.text + "/factor");
            NewStatement lifted("Texture", at);
            lifted.name(grey).name("color").name("mix").set("texture amount", factor->text);
            add(std::move(lifted.set("color tex1", Rgb(0.0f)).set("color tex2", Rgb(1.0f))));
            made.set("texture tex2", grey);
        } else {
            set_term(made, "tex2", p, "scale", is_float, 1);
        }
        add(std::move(made));
    } else if (type == "mix" || type == "directionmix") {
        std::string share;
        if (type == "directionmix") {
            share = fresh(name.text + "/share");
            begin(share, true, "nodes");
            made.set_list("string program", along_normal(p.point("dir").value_or(Vec3(0, 1, 0))));
            add(std::move(made));
        }
        begin(name.text, is_float, "mix");
        set_term(made, "tex1", p, "tex1", is_float, 0);
        set_term(made, "tex2", p, "tex2", is_float, 1);
        if (share.empty())
            set_term(made, "amount", p, "amount", true, 0.5);
        else
            made.set("texture amount", share);
        add(std::move(made));
    } else if (type == "checkerboard") {
        const std::string of = pattern("checkerboard");
        const int dimension = p.integer("dimension", 2);
        p.ignore("aamode");
        made.set("integer dimension", dimension);
        if (dimension == 2) set_mapping(made, p, false);
        if (is_float) {
            set_term(made, "tex1", p, "tex1", true, 1);
            set_term(made, "tex2", p, "tex2", true, 0);
            add(std::move(made));
        } else {
            add(std::move(made.set("float tex1", 0).set("float tex2", 1)));
            mix_by(of, "tex1", 1, "tex2", 0);
        }
    } else if (type == "dots") {
        const std::string of = pattern("dots");
        set_mapping(made, p, false);
        // Dots show "outside" in pbrt, whose constructor takes both the other way round; as ours
        // do.
        if (is_float) {
            set_term(made, "outside", p, "outside", true, 0);
            set_term(made, "inside", p, "inside", true, 1);
            add(std::move(made));
        } else {
            add(std::move(made.set("float outside", 0).set("float inside", 1)));
            mix_by(of, "outside", 0, "inside", 1);
        }
    } else if (type == "fbm" || type == "wrinkled" || type == "windy") {
        const std::string of = pattern(type.c_str());
        if (type != "windy")
            made.set("integer octaves", p.integer("octaves", 8))
                .set("float roughness", p.number("roughness", 0.5));
        add(std::move(made));
        if (!is_float) mix_by(of, "", 0, "", 1);
    } else if (type == "marble") {
        begin(name.text, false, "marble");
        if (is_float) throw InputError(at, "texture \"marble\" is a spectrum");
        made.set("integer octaves", p.integer("octaves", 8))
            .set("float roughness", p.number("roughness", 0.5))
            .set("float scale", p.number("scale", 1))
            .set("float variation", p.number("variation", 0.2));
        add(std::move(made));
    } else if (type == "bilerp") {
        begin(name.text, is_float, "bilerp");
        for (const char* corner : {"v00", "v01", "v10", "v11"})
            set_term(made, corner, p, corner, is_float, corner[2] == '1' ? 1 : 0);
        set_mapping(made, p, false);
        add(std::move(made));
    } else if (type == "ptex") {
        for (const char* known : {"filename", "encoding", "scale", "gamma"})
            p.ignore(known);
        warn(at, "texture \"ptex\" is not rendered: a grey of 0.5 is used");
        begin(name.text, is_float, "constant");
        made.set(is_float ? "float value" : "color value",
                 is_float ? Numbers{0.5} : Numbers{0.5, 0.5, 0.5});
        add(std::move(made));
    } else {
        throw InputError(at,
                         unknown_name_message(
                             "texture", type,
                             {"bilerp", "checkerboard", "constant", "directionmix", "dots", "fbm",
                              "imagemap", "marble", "mix", "ptex", "scale", "windy", "wrinkled"}));
    }
}

}  // namespace lxs::pbrt
