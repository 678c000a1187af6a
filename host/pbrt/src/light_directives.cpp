// Directives LightSource and AreaLightSource.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lxs/spectrum/rgb_spectra.h"
#include "translator.h"

namespace lxs::pbrt {
namespace {

constexpr double kPi = std::numbers::pi;

/// Lumens, of which the profile's own values say nothing; `scale` is a factor on them.
void set_power(NewStatement& made, double scale, double power) {
    if (power > 0) made.set("float gain", scale).set("float power", power).set("float efficacy", 1);
}

/// A point parameter as numbers.
Numbers coordinates(const Vec3& p) {
    return {p.x, p.y, p.z};
}

}  // namespace

void Translator::set_emission(NewStatement& made, const Parameters& p, std::string_view name,
                              double scale) {
    Rgb colour = spectra_.colour(p, name, ColourOf::Light, Rgb(1.0f));
    // The brightest channel is 1, so that no colour leaves the range of what is written.
    const float most = std::max(max_component(colour), 1e-30f);
    made.set("color L", illuminant_of_colour(colour / most), &p.where(name));
    made.set("float gain", std::max(scale * double(most), 0.0), &p.where("scale"));
}

void Translator::light_source(Statement& statement) {
    Parameters p = take(statement, "light");
    const SourceLocation& at = statement.where;
    const std::string& type = p.plugin();
    p.ignore("samples");
    p.ignore("nsamples");
    double scale = imaging_ratio_;
    // Version 3 gives a colour here.
    const Rgb factor = spectra_.colour(p, "scale", ColourOf::Surface, Rgb(1.0f));
    scale *= luminance(factor);
    const double power = p.number("power", -1), illuminance = p.number("illuminance", -1);
    NewStatement made("LightSource", at);
    if (type == "point") {
        made.name("point");
        set_emission(made, p, "I", scale * (power > 0 ? power / (4 * kPi) : 1));
    } else if (type == "spot") {
        made.name("spot");
        const double cone = p.number("coneangle", 30), delta = p.number("conedeltaangle", 5);
        const double end = std::cos(cone * kPi / 180), start = std::cos((cone - delta) * kPi / 180);
        const double flux = 2 * kPi * ((1 - start) + (start - end) / 2);
        set_emission(made, p, "I", scale * (power > 0 && flux > 0 ? power / flux : 1));
        made.set("float coneangle", cone, &p.where("coneangle"));
        made.set("float conedeltaangle", delta, &p.where("conedeltaangle"));
        if (!version_3_) made.set("string falloff", "smoothstep");
    } else if (type == "distant") {
        made.name("distant");
        // Ours gives L over a cone of 2 pi 2^-16 steradians.
        constexpr double kCone = 2 * kPi * 0x1p-16;
        set_emission(made, p, "L", scale * kCone * (illuminance > 0 ? illuminance : 1));
    } else if (type == "infinite") {
        made.name("infinite");
        infinite_light(made, p, scale, illuminance);
    } else if (type == "goniometric") {
        made.name("goniometric");
        set_emission(made, p, "I", scale);
        const bool latlong = p.given("mapname");  // version 3
        p.rename("mapname", "filename");
        const std::string file = p.text("filename", "");
        if (!file.empty()) {
            set_power(made, scale, power);
            made.set("string mapname", file, &p.where("filename"));
            made.set("string mapping", latlong ? "latlong" : "equalarea");
            made.set("bool plainvalues", "true");
            if (is_eight_bit(file)) made.set("string colorspace", "srgb");
        } else if (power > 0) {
            set_emission(made, p, "I", scale * power / (4 * kPi));
        }
    } else if (type == "projection") {
        made.name("projection");
        p.rename("mapname", "filename");
        if (!p.given("filename")) p.fail("filename", "light \"projection\" needs an image");
        set_emission(made, p, "I", scale);
        set_power(made, scale, power);
        const std::string file = p.text("filename", "");
        made.set("string mapname", file, &p.where("filename"));
        made.set("bool plainvalues", "true");
        if (is_eight_bit(file)) made.set("string colorspace", "srgb");
        made.set("float fov", p.number("fov", version_3_ ? 45 : 90), &p.where("fov"));
    } else {
        throw InputError(p.where(), unknown_name_message("light", type,
                                                         {"distant", "goniometric", "infinite",
                                                          "point", "projection", "spot"}));
    }
    const bool aimed = type == "spot" || type == "distant";
    const auto from = p.point("from"), to = p.point("to");
    if (from && type != "infinite") made.set("point from", coordinates(*from), &p.where("from"));
    if (to && aimed) made.set("point to", coordinates(*to), &p.where("to"));
    p.report_unused("light");
    // Lights are of the world, also those that stand in an object.
    is_put_off_ = in_object_;
    add("AttributeBegin", at);
    place(at, false, "light");
    // Our image's columns go along y, its rows along -x; pbrt's map of a goniometric light has its
    // pole along y.
    if (type == "projection")
        add(NewStatement("ConcatTransform", at)
                .list({0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}));
    if (type == "goniometric")
        add(NewStatement("ConcatTransform", at)
                .list({1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1}));
    if (!state_.outside.empty()) add(NewStatement("Exterior", at).name(state_.outside));
    add(std::move(made));
    add("AttributeEnd", at);
    is_put_off_ = false;
}

void Translator::infinite_light(NewStatement& made, Parameters& p, double scale,
                                double illuminance) {
    const bool latlong = p.given("mapname");  // version 3
    if (p.given("portal")) {
        p.ignore("portal");
        warn(p.where("portal"),
             "portals are not used: they only guide sampling; the light comes from all "
             "directions");
    }
    if (!latlong && !p.given("filename")) {
        set_emission(made, p, "L", scale * (illuminance > 0 ? illuminance / kPi : 1));
        return;
    }
    if (!latlong && p.given("L"))
        p.fail("L", "an infinite light takes either \"L\" or \"filename\"");
    // pbrt takes half of the solid angle that a texel has.
    if (illuminance > 0) made.set("float illuminance", 2 * illuminance, &p.where("illuminance"));
    p.rename("mapname", "filename");
    const std::string file = p.text("filename", "");
    if (latlong) {
        set_emission(made, p, "L", scale);
    } else {
        made.set("float gain", scale).set("string mapping", "equalarea");
    }
    made.set("string mapname", file, &p.where("filename"));
    made.set("bool plaincolors", "true");
    if (is_eight_bit(file)) made.set("string colorspace", "srgb");
}

void Translator::area_light_source(Statement& statement) {
    ParameterSet set = take_plugin(statement);
    if (set.plugin != "diffuse" && set.plugin != "area")
        throw InputError(set.where, unknown_name_message("area light", set.plugin, {"diffuse"}));
    const ParameterValues& more = defaults("light");
    set.values.insert(set.values.end(), more.begin(), more.end());
    state_.area_light = std::make_shared<const ParameterSet>(std::move(set));
    area_light_told_ = false;
}

Translator::Emission Translator::area_emission(const SourceLocation& where) {
    static const ParameterValues none;
    Parameters p(*state_.area_light, none, *state_.space, diagnostics_);
    for (const char* known : {"samples", "nsamples"})
        p.ignore(known);
    Emission emission{NewStatement("AreaLightSource", where), p.flag("twosided", false)};
    NewStatement& made = emission.statement;
    made.name("area");
    const Rgb factor = spectra_.colour(p, "scale", ColourOf::Surface, Rgb(1.0f));
    const double scale = imaging_ratio_ * double(luminance(factor));
    const double power = p.number("power", -1);
    const std::string file = p.text("filename", "");
    if (!file.empty()) {
        if (p.given("L")) p.fail("L", "an area light takes either \"L\" or \"filename\"");
        const std::string texture = fresh("area light/" + file);
        const bool eight_bit = is_eight_bit(file);
        NewStatement image("Texture", where);
        image.name(texture)
            .name("color")
            .name("imagemap")
            .set("string filename", file, &p.where("filename"));
        if (eight_bit)
            image.set("string colorspace", "srgb_texels");
        else
            image.set("float gamma", 1);
        add(std::move(image.set("bool plaincolors", "true")
                          .set("string wrap", "clamp")
                          .set("float vscale", -1)
                          .set("float vdelta", 1)));
        made.set("texture L", texture).set("float gain", scale);
    } else {
        set_emission(made, p, "L", scale);
    }
    // Of lights with a power our gain is a factor on it, as pbrt's scale is.
    if (power > 0) {
        const double y =
            file.empty() ? double(luminance(spectra_.colour(p, "L", ColourOf::Light, Rgb(1.0f))))
                         : 1;
        NewStatement rated("AreaLightSource", where);
        rated.name("area");
        if (file.empty())
            rated.set("color L",
                      illuminant_of_colour(spectra_.colour(p, "L", ColourOf::Light, Rgb(1.0f))));
        rated.set("float gain", scale * y);
        rated.set("float power", power).set("float efficacy", 1);
        if (file.empty())
            made = std::move(rated);
        else
            p.leave_out("power", "the image's values count");
    }
    if (power <= 0 || !file.empty()) made.set("float power", 0).set("float efficacy", 0);
    if (!std::exchange(area_light_told_, true)) p.report_unused("area light");
    return emission;
}

}  // namespace lxs::pbrt
