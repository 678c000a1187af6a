// Directives before WorldBegin: camera, film, filter, integrator.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lxs/spectrum/rgb_spectra.h"
#include "translator.h"

namespace lxs::pbrt {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// The number before "mm" in the name of a lens file, as in "wide.22mm.dat"; 50 if there is none.
double focal_length_of(const std::string& file) {
    const std::size_t end = file.find("mm");
    std::size_t begin = end;
    if (end == std::string::npos) return 50;
    while (begin > 0 && (std::isdigit(static_cast<unsigned char>(file[begin - 1])) != 0 ||
                         file[begin - 1] == '.'))
        --begin;
    const double length = std::atof(file.c_str() + begin + (file[begin] == '.' ? 1 : 0));
    return length > 1 && length < 10000 ? length : 50;
}

}  // namespace

void Translator::camera(Statement& statement) {
    camera_transforms_ = state_.transforms;
    coordinate_systems_["camera"] = {state_.transforms[0].inverse(),
                                     state_.transforms[1].inverse()};
    camera_medium_ = state_.outside;
    keep_option(statement);
}

void Translator::keep_option(Statement& statement) {
    const std::string word =
        statement.name == "SurfaceIntegrator" ? std::string("Integrator") : statement.name;
    if (options_.contains(word))
        warn(statement.where, word + " is given twice: the last one counts");
    take_name(statement, 0);
    options_.insert_or_assign(word, std::move(statement));
}

Parameters Translator::option_parameters(const char* directive, const char* plugin,
                                         const SourceLocation& where) {
    const auto found = options_.find(directive);
    static const ParameterValues none;
    if (found != options_.end())
        return Parameters(take_plugin(found->second), none, *state_.space, diagnostics_);
    ParameterSet set;
    set.plugin = plugin;
    set.where = where;
    return Parameters(std::move(set), none, *state_.space, diagnostics_);
}

void Translator::write_options(const SourceLocation& where) {
    Options options{
        option_parameters("Film", "rgb", where), option_parameters("Camera", "perspective", where),
        option_parameters("PixelFilter", "", where), option_parameters("Sampler", "zsobol", where),
        option_parameters("Integrator", "volpath", where)};
    options_.clear();
    version_3_ |= options.film.plugin() == "image";
    // Each is told of by itself: a scene with three mistakes has three messages.
    executor_.guard([&] { write_film(options); });
    executor_.guard([&] { write_camera(options); });
    executor_.guard([&] { write_filter(options.filter); });
    executor_.guard([&] { write_integrator(options.integrator); });
}

void Translator::write_film(Options& options) {
    Parameters& film = options.film;
    static const std::vector<std::string> known_names{"rgb", "gbuffer", "spectral", "image"};
    if (std::find(known_names.begin(), known_names.end(), film.plugin()) == known_names.end())
        throw InputError(film.where(), unknown_name_message("film", film.plugin(), known_names));
    if (film.plugin() == "gbuffer" || film.plugin() == "spectral") {
        warn(film.where(), fmt::format("Film \"{}\" is written as \"rgb\"; --set film.layers=all "
                                       "adds albedo, normals and more",
                                       film.plugin()));
        for (const char* known : {"coordinatesystem", "nbuckets", "lambdamin", "lambdamax"})
            film.ignore(known);
    }
    // Exposure: the shutter's time by ISO / 100.
    const double open = options.camera.number("shutteropen", 0);
    const double close = options.camera.number("shutterclose", 1);
    const double seconds = film.number("exposuretime", version_3_ ? 1 : std::abs(close - open));
    imaging_ratio_ = version_3_ ? film.number("scale", 1) : seconds * film.number("iso", 100) / 100;
    if (!(imaging_ratio_ > 0))
        film.fail("iso", "the imaging ratio, exposure time by ISO / 100, must be above 0");
    const std::string sensor = film.text("sensor", "cie1931");
    if (sensor != "cie1931")
        warn(film.where("sensor"),
             fmt::format("sensor {} is not rendered: \"cie1931\" is used", in_quotes(sensor)));
    if (film.given("whitebalance"))
        film.leave_out("whitebalance", "white is that of the colour space");
    film.leave_out("maxcomponentvalue", "no value is cut off");
    film.leave_out("maxsampleluminance", "no value is cut off");
    film.ignore("savefp16");

    NewStatement made("Film", film.where());
    made.name("fleximage");
    const int width = film.integer("xresolution", version_3_ ? 640 : 1280);
    const int height = film.integer("yresolution", version_3_ ? 480 : 720);
    made.set("integer xresolution", width, &film.where("xresolution"));
    made.set("integer yresolution", height, &film.where("yresolution"));
    made.set("string filename", film.text("filename", "pbrt.exr"), &film.where("filename"));
    if (film.given("pixelbounds") && width > 0 && height > 0) {
        const Numbers bounds = film.numbers("pixelbounds");
        if (bounds.size() != 4) film.fail("pixelbounds", "pixelbounds takes four numbers");
        const auto share = [](double pixel, int of) { return std::clamp(pixel / of, 0.0, 1.0); };
        made.set("float cropwindow", Numbers{share(bounds[0], width), share(bounds[1], width),
                                             share(bounds[2], height), share(bounds[3], height)});
        film.ignore("cropwindow");
    } else if (film.given("cropwindow")) {
        made.set("float cropwindow", film.numbers("cropwindow"), &film.where("cropwindow"));
    }
    const auto chromaticity = [](const std::array<double, 2>& c) { return Numbers{c[0], c[1]}; };
    made.set("float colorspace_red", chromaticity(kSceneRed));
    made.set("float colorspace_green", chromaticity(kSceneGreen));
    made.set("float colorspace_blue", chromaticity(kSceneBlue));
    made.set("float colorspace_white", chromaticity(kSceneWhite));
    if (&film.space() != &srgb())
        warn(film.where(), "the image is written in sRGB's linear RGB, whatever the colour space");
    // A pixel of radiance 1 is white in the PNG.
    constexpr double kUnitSensitivity = 255 / (118 * 0.065);
    made.set("string tonemapkernel", "linear")
        .set("float linear_sensitivity", kUnitSensitivity)
        .set("float linear_exposure", 1)
        .set("float linear_fstop", 1)
        .set("float linear_gamma", 1);
    const Parameters& sampler = options.sampler;
    int passes = sampler.integer("pixelsamples", 16);
    if (sampler.plugin() == "stratified")
        passes = std::max(1, sampler.integer("xsamples", 4)) *
                 std::max(1, sampler.integer("ysamples", 4));
    for (const char* known : {"seed", "randomization", "jitter", "dimensions", "samplepixelcenter",
                              "sampleatpixelcenter"})
        sampler.ignore(known);
    sampler.report_unused("Sampler");
    if (const Parameters& integrator = options.integrator; integrator.plugin() == "sppm")
        passes = integrator.integer("iterations", integrator.integer("numiterations", 64));
    made.set("integer haltspp", std::max(passes, 1));
    film.report_unused("Film");
    add(std::move(made));
}

void Translator::write_camera(Options& options) {
    Parameters& camera = options.camera;
    const SourceLocation& at = camera.where();
    static const std::vector<std::string> known_names{"perspective", "orthographic", "spherical",
                                                      "environment", "realistic"};
    const std::string& type = camera.plugin();
    if (std::find(known_names.begin(), known_names.end(), type) == known_names.end())
        throw InputError(at, unknown_name_message("camera", type, known_names));
    const bool round = type == "spherical" || type == "environment";
    static const std::vector<std::string> mappings{"equalarea", "equirectangular"};
    const std::string mapping = type == "spherical" ? camera.text("mapping", "equalarea") : "";
    if (type == "spherical" &&
        std::find(mappings.begin(), mappings.end(), mapping) == mappings.end())
        camera.fail("mapping", unknown_name_message("mapping", mapping, mappings));
    const bool equal_area = mapping == "equalarea";
    if (round && !equal_area) {
        // Our panorama has its middle, pbrt's a quarter along z, and goes the other way around.
        const Matrix turned(0, 0, -1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1);
        for (Matrix& transform : camera_transforms_)
            transform = transform * turned;
    }
    std::swap(state_.transforms, camera_transforms_);
    add("TransformBegin", at);
    place(at, true, "camera");
    std::swap(state_.transforms, camera_transforms_);
    NewStatement made("Camera", at);
    made.name(round ? "environment" : type == "realistic" ? "perspective" : type);
    made.set("float shutteropen", camera.number("shutteropen", 0));
    made.set("float shutterclose", camera.number("shutterclose", 1));
    for (const char* name : {"screenwindow", "frameaspectratio"}) {
        if (!camera.given(name)) continue;
        const SourceLocation place_of = camera.where(name);
        made.set(fmt::format("float {}", name).c_str(), camera.numbers(name), &place_of);
    }
    if (type == "perspective" || type == "orthographic") {
        made.set("float lensradius", camera.number("lensradius", 0), &camera.where("lensradius"));
        made.set("float focaldistance", camera.number("focaldistance", 1e6),
                 &camera.where("focaldistance"));
    }
    if (type == "perspective") {
        const double fov =
            camera.given("halffov") ? 2 * camera.number("halffov", 45) : camera.number("fov", 90);
        made.set("float fov", fov, &camera.where("fov"));
    }
    if (equal_area) made.set("string mapping", mapping, &camera.where("mapping"));
    if (type == "realistic") {
        const double focal = focal_length_of(camera.text("lensfile", ""));
        const double width = options.film.integer("xresolution", 1280);
        const double height = options.film.integer("yresolution", 720);
        const double shorter = options.film.number("diagonal", 35) * std::min(width, height) /
                               std::max(std::hypot(width, height), 1.0);
        warn(at,
             fmt::format("camera \"realistic\" is not rendered: \"perspective\" with a thin lens "
                         "of {:g} mm is used",
                         focal));
        made.set("float fov", 2 * std::atan(shorter / (2 * focal)) * kDegrees);
        made.set("float lensradius", camera.number("aperturediameter", 1) / 2000);
        made.set("float focaldistance",
                 camera.number("focusdistance", camera.number("focaldistance", 10)));
        for (const char* known : {"aperture", "simpleweighting", "scale", "dispersionfactor"})
            camera.ignore(known);
    }
    camera.report_unused("Camera");
    add(std::move(made));
    add("TransformEnd", at);
}

void Translator::write_filter(Parameters& filter) {
    const std::string type = !filter.plugin().empty() ? filter.plugin()
                             : version_3_             ? "box"
                                                      : "gaussian";
    static const std::vector<std::string> known_names{"box", "gaussian", "mitchell", "sinc",
                                                      "triangle"};
    if (std::find(known_names.begin(), known_names.end(), type) == known_names.end())
        throw InputError(filter.where(), unknown_name_message("filter", type, known_names));
    filter.rename("xwidth", "xradius");
    filter.rename("ywidth", "yradius");
    const double radius = type == "box"        ? 0.5
                          : type == "gaussian" ? version_3_ ? 2 : 1.5
                          : type == "sinc"     ? 4
                                               : 2;
    NewStatement made("PixelFilter", filter.where());
    made.name(type);
    made.set("float xwidth", filter.number("xradius", radius), &filter.where("xradius"));
    made.set("float ywidth", filter.number("yradius", radius), &filter.where("yradius"));
    if (type == "gaussian") {
        const double sigma = filter.number("sigma", 0.5);
        if (!(sigma > 0)) filter.fail("sigma", "\"sigma\" must be above 0");
        made.set("float alpha", filter.number("alpha", 1 / (2 * sigma * sigma)));
    }
    if (type == "mitchell")
        made.set("float B", filter.number("B", 1.0 / 3))
            .set("float C", filter.number("C", 1.0 / 3));
    if (type == "sinc") made.set("float tau", filter.number("tau", 3));
    filter.report_unused("PixelFilter");
    add(std::move(made));
}

void Translator::write_integrator(Parameters& integrator) {
    const std::string& type = integrator.plugin();
    const SourceLocation& at = integrator.where();
    static const std::vector<std::string> ours{"path", "aips", "sppm", "ppm", "exphotonmap"};
    static const std::vector<std::string> paths_instead{
        "ambientocclusion", "ao",     "bdpt",       "directlighting", "function",
        "lightpath",        "mlt",    "randomwalk", "simplepath",     "simplevolpath",
        "volpath",          "whitted"};
    const bool by_path =
        std::find(paths_instead.begin(), paths_instead.end(), type) != paths_instead.end();
    if (!by_path && std::find(ours.begin(), ours.end(), type) == ours.end()) {
        std::vector<std::string> known = ours;
        known.insert(known.end(), paths_instead.begin(), paths_instead.end());
        throw InputError(at, unknown_name_message("integrator", type, known));
    }
    const std::string used = by_path ? "path" : type;
    if (by_path && type != "volpath") {
        diagnostics_.fallback(
            at, fmt::format("Integrator \"{}\" is not rendered", type),
            "\"path\" is used instead; \"aips\" (--integrator aips) shoots photons too");
    }
    add(NewStatement("Renderer", at).name(used == "path" ? "sampler" : "sppm"));
    NewStatement made("SurfaceIntegrator", at);
    made.name(used);
    const double depth = integrator.integer("maxdepth", 5);
    const SourceLocation& depth_at = integrator.where("maxdepth");
    if (type == "sppm") {
        made.set("integer maxeyedepth", depth, &depth_at)
            .set("integer maxphotondepth", depth, &depth_at);
        if (integrator.given("photonsperiteration"))
            made.set("integer photonperpass", integrator.integer("photonsperiteration", 0));
        if (integrator.given("radius"))
            made.set("float startradius", integrator.number("radius", 1));
        for (const char* known : {"seed", "imagewritefrequency", "iterations", "numiterations"})
            integrator.ignore(known);
    } else {
        made.set("integer maxdepth", depth, &depth_at);
    }
    for (const char* known :
         {"lightsampler", "regularize", "rrthreshold", "strategy", "pixelbounds"})
        integrator.ignore(known);
    // Our integrators take their own parameters; those of pbrt's others change nothing here.
    for (const ParameterValue* value : integrator.rest())
        if (!by_path) made.set(*value);
    add(std::move(made));
    add(NewStatement("VolumeIntegrator", at).name("multi"));
}

}  // namespace lxs::pbrt
