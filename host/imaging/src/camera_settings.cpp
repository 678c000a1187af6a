// What the Camera statement asks for.
#include "camera_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "no_effect.h"
#include "option_choice.h"

namespace lxs {
namespace {

using enum ParameterType;

constexpr std::array<std::string_view, 2> kShutterDistributions{"uniform", "gaussian"};
constexpr std::array<std::string_view, 5> kLensDistributions{
    "uniform", "exponential", "inverse exponential", "gaussian", "inverse gaussian"};

constexpr ParameterDeclaration kCommon[] = {
    {"shutteropen", Float, "0", "Time at which the shutter opens."},
    {"shutterclose", Float, "1", "Time at which the shutter closes."},
    {.name = "shutterdistribution",
     .type = String,
     .default_text = "uniform",
     .doc = "Ignored: times are uniform.",
     .choices = kShutterDistributions},
    {"hither", Float, "", "Depth at which rays start, scene units; at the lens if not given.", 0},
    {"yon", Float, "1e30", "Depth at which rays end, scene units.", 0},
    {.name = "screenwindow",
     .type = Float,
     .default_text = "",
     .doc = "Visible part x0 x1 y0 y1 of the screen; by default -1 to 1 along the shorter axis.",
     .array = true},
    {"frameaspectratio", Float, "", "Width by height of the screen; by default the image's.", 1e-6,
     1e6},
};

constexpr ParameterDeclaration kLens[] = {
    {"lensradius", Float, "0", "Radius of the lens, scene units; 0: a pinhole.", 0},
    {"focaldistance", Float, "1e30", "Depth at which the image is sharp, scene units."},
    {"autofocus", Bool, "false",
     "Sharp where the ray through the middle of the image meets the scene; focaldistance counts if "
     "it meets nothing."},
};

constexpr ParameterDeclaration kPerspective[] = {
    {"fov", Float, "90", "Angle of view along the shorter axis, degrees."},
    {"blades", Integer, "0",
     "Corners of the aperture, a regular polygon within the lens radius; below 3: round."},
    {"power", Integer, "3", "Ignored, as distribution is: the aperture is uniform."},
    {.name = "distribution",
     .type = String,
     .default_text = "uniform",
     .doc = "Ignored: the aperture is uniform.",
     .choices = kLensDistributions},
};

constexpr std::array<std::string_view, 2> kSphereMappings{"equirectangular", "equalarea"};
constexpr ParameterDeclaration kEnvironment[] = {
    {.name = "mapping",
     .type = String,
     .default_text = "equirectangular",
     .doc = "Longitude and latitude with forward in the middle; or (not LuxRender's) an equal-area "
            "octahedral square, +y in the middle and forward in the middle of its lower edge.",
     .choices = kSphereMappings},
};

std::vector<ParameterDeclaration> declarations(Projection projection) {
    std::vector<ParameterDeclaration> all(std::begin(kCommon), std::end(kCommon));
    if (projection == Projection::Environment) {
        all.insert(all.end(), std::begin(kEnvironment), std::end(kEnvironment));
    } else {
        all.insert(all.end(), std::begin(kLens), std::end(kLens));
    }
    if (projection == Projection::Perspective) {
        all.insert(all.end(), std::begin(kPerspective), std::end(kPerspective));
    }
    return all;
}

Projection projection_of(const std::string& plugin) {
    if (plugin == "orthographic") return Projection::Orthographic;
    if (plugin == "environment") return Projection::Environment;
    return Projection::Perspective;
}

Matrix camera_to_world(const OptionStatement& statement, const Matrix& transform) {
    try {
        return transform.inverse(true);
    } catch (const std::exception&) {
        throw InputError(statement.parameters.where,
                         "the camera's transform is singular: it has no inverse");
    }
}

std::array<double, 4> read_screen(const ParameterReader& reader, const FilmFrame& frame) {
    if (reader.given("screenwindow")) {
        const auto values = reader.numbers("screenwindow");
        const bool four = values.size() == 4;
        if (four && (values[0] == values[1] || values[2] == values[3]))
            reader.fail("screenwindow", "screenwindow is empty");
        if (four) return {values[0], values[1], values[2], values[3]};
        reader.diagnostics().fallback(
            reader.where("screenwindow"),
            fmt::format("screenwindow takes 4 numbers, found {}", values.size()),
            "its default is used");
    }
    const double image_aspect = static_cast<double>(frame.x_resolution) / frame.y_resolution;
    const double aspect = reader.number("frameaspectratio", image_aspect);
    if (aspect > 1) return {-aspect, aspect, -1, 1};
    return {-1, 1, -1 / aspect, 1 / aspect};
}

void read_depths(const ParameterReader& reader, CameraSettings& settings) {
    settings.hither = reader.number("hither", settings.hither);
    settings.yon = reader.number("yon", settings.yon);
    if (settings.yon <= settings.hither) {
        reader.fail("yon", fmt::format("yon is {}, but must be beyond hither, {}", settings.yon,
                                       settings.hither));
    }
}

void read_shutter(const ParameterReader& reader, CameraSettings& settings) {
    settings.shutter_open = static_cast<float>(reader.number("shutteropen", 0));
    settings.shutter_close = static_cast<float>(reader.number("shutterclose", 1));
    if (settings.shutter_close < settings.shutter_open) {
        reader.diagnostics().warning(reader.where("shutterclose"),
                                     "the shutter closes before it opens; the times are swapped");
        std::swap(settings.shutter_open, settings.shutter_close);
    }
    if (reader.string("shutterdistribution", "uniform") != "uniform") {
        warn_of_no_effect(reader, "shutterdistribution", "times are uniform");
    }
}

void read_lens(const ParameterReader& reader, CameraSettings& settings) {
    settings.lens_radius = reader.number("lensradius", 0);
    settings.autofocus = settings.lens_radius > 0 && reader.boolean("autofocus", false);
    const double distance = reader.number("focaldistance", settings.focal_distance);
    if (distance > 0) {
        settings.focal_distance = distance;
    } else if (settings.lens_radius > 0 && !settings.autofocus) {  // else it says nothing
        reader.fail("focaldistance",
                    fmt::format("focaldistance is {}, but must be positive", distance));
    }
}

void read_perspective(const ParameterReader& reader, CameraSettings& settings) {
    settings.fov = reader.number("fov", settings.fov);
    if (!(settings.fov > 0 && settings.fov < 180)) {
        reader.fail("fov",
                    fmt::format("fov is {}, but must lie between 0 and 180 degrees", settings.fov));
    }
    if (settings.lens_radius == 0) return;
    constexpr std::int64_t kMostBlades = 1000;
    settings.blades =
        static_cast<int>(std::clamp<std::int64_t>(reader.integer("blades", 0), 0, kMostBlades));
    if (reader.string("distribution", "uniform") != "uniform") {
        warn_of_no_effect(reader, "distribution", "the aperture is uniform");
    }
}

}  // namespace

std::vector<ParameterDeclaration> camera_parameters(const std::string& plugin) {
    return declarations(projection_of(plugin));
}

CameraSettings read_camera_settings(const SceneContents& contents, const FilmFrame& frame,
                                    Diagnostics& diagnostics) {
    const OptionChoice choice = choose_option(contents, "Camera", "perspective",
                                              {"environment", "orthographic", "perspective"});
    if (!choice.given) {
        diagnostics.warning(contents.end,
                            "the scene has no Camera statement; using LuxRender's default: a "
                            "perspective camera with fov 90 at the origin, looking along +z");
    }
    CameraSettings settings;
    settings.projection = projection_of(choice.statement.parameters.plugin);
    settings.to_world = camera_to_world(choice.statement, choice.statement.transform);
    for (const MotionKey& key : choice.statement.motion)
        settings.motion.push_back({key.time, camera_to_world(choice.statement, key.matrix)});
    const std::vector<ParameterDeclaration> declared = declarations(settings.projection);
    const ParameterReader reader(choice.statement.parameters, declared, diagnostics);
    settings.screen = read_screen(reader, frame);
    read_depths(reader, settings);
    read_shutter(reader, settings);
    if (settings.projection != Projection::Environment)
        read_lens(reader, settings);
    else if (reader.string("mapping", "equirectangular") == "equalarea")
        settings.mapping = SphereMapping::EqualArea;
    if (settings.projection == Projection::Perspective) read_perspective(reader, settings);
    return settings;
}

}  // namespace lxs
