// The declared parameters of the films.
#include "film_parameters.h"

#include <array>
#include <string>

#include "no_effect.h"

namespace lxs {
namespace {

using enum ParameterType;

constexpr std::array<std::string_view, 7> kToneMapKernels{
    "autolinear", "linear", "reinhard", "contrast", "maxwhite", "nonlinear", "falsecolors"};
constexpr std::array<std::string_view, 4> kClampMethods{"lum", "hue", "cut", "darken"};
constexpr std::array<std::string_view, 4> kChannels{"RGB", "RGBA", "Y", "YA"};
constexpr double kTiny = 1e-6;
constexpr double kHuge = 1e12;

constexpr ParameterDeclaration past(std::string_view name, ParameterType type,
                                    std::string_view default_text, std::string_view doc) {
    return {
        .name = name, .type = type, .default_text = default_text, .doc = doc, .no_effect = true};
}

constexpr ParameterDeclaration kPicture[] = {
    {"xresolution", Integer, "800", "Width of the whole image, pixels."},
    {"yresolution", Integer, "600", "Height of the whole image, pixels."},
    {.name = "cropwindow",
     .type = Float,
     .default_text = "0 1 0 1",
     .doc = "Rendered part x0 x1 y0 y1 of the image, as fractions from the upper left.",
     .minimum = 0,
     .maximum = 1,
     .array = true},
    {.name = "filename",
     .type = String,
     .default_text = "luxout",
     .doc = "Name of the output files; a suffix is dropped.",
     .older_name = "hdr_filename"},
    {.name = "writeinterval",
     .type = Integer,
     .default_text = "60",
     .doc = "Seconds between two writes of the image so far, the first after the first pass; 0: at "
            "the end alone.",
     .older_name = "hdr_writeinterval"},
    {"displayinterval", Integer, "12",
     "Seconds between two writes of the PNG alone, in place of a window; 0: with the EXR."},
    {"halttime", Integer, "-1", "Seconds after which the render ends; not positive: never."},
    {"haltspp", Integer, "-1", "Passes after which the render ends; not positive: never."},
    {"haltthreshold", Float, "-1",
     "Estimated error at which the render ends, the square root of relMSE; not positive: never. "
     "LuxRender: the share of pixels that still change visibly."},
    {.name = "tonemapkernel",
     .type = String,
     .default_text = "autolinear",
     .doc = "Tone mapping of the PNG.",
     .choices = kToneMapKernels,
     .older_name = "tonemapper"},
    {"gamma", Float, "2.2", "Gamma of the PNG.", 0.1, 10},
    {.name = "ldr_clamp_method",
     .type = String,
     .default_text = "cut",
     .doc = "What becomes of colours beyond the display's range: moved towards the grey of their "
            "luminance (lum) or of a third (hue), darkened (darken), or cut per channel.",
     .choices = kClampMethods},
    {"linear_sensitivity", Float, "50", "ISO speed of kernel linear.", 0, kHuge},
    {"linear_exposure", Float, "1", "Exposure time of kernel linear, seconds.", 0, kHuge},
    {"linear_fstop", Float, "2.8", "F-number of kernel linear.", kTiny, kHuge},
    {"linear_gamma", Float, "1", "Gamma that the exposure of kernel linear allows for.", 0, 10},
    {"reinhard_prescale", Float, "1",
     "What luminance is divided by before the curve of kernel reinhard.", kTiny, kHuge},
    {"reinhard_postscale", Float, "1", "Scale after the curve of kernel reinhard.", 0, kHuge},
    {"reinhard_burn", Float, "6", "Scaled luminance that becomes white in kernel reinhard.", kTiny,
     kHuge},
    {"contrast_ywa", Float, "1",
     "Luminance that the eyes before the display are adapted to, for kernel contrast, cd m^-2.", 0,
     kHuge},
    {.name = "layers",
     .type = String,
     .doc = "Layers that the EXR has beside the image: direct, indirect, caustics, albedo, normal, "
            "depth, objects, materials, bias; cryptomatte for objects and materials, all for every "
            "one.",
     .array = true},
    {"premultiplyalpha", Bool, "false",
     "An alpha channel: that of EXR and PNG. Lights at infinity are not seen behind it."},
    {.name = "write_exr_channels",
     .type = String,
     .default_text = "RGB",
     .doc = "With A: an alpha channel, as with premultiplyalpha.",
     .choices = kChannels},
    {.name = "write_png_channels",
     .type = String,
     .default_text = "RGB",
     .doc = "Likewise.",
     .choices = kChannels},
    {"write_exr_straightcolors", Bool, "false",
     "Beside an alpha channel, unless premultiplyalpha is given: colours are not multiplied by it, "
     "and show lights at infinity."},
    {"outlierrejection_k", Integer, "0",
     "Samples of a brightness that a pixel needs around it to show it in full; one alone is not "
     "shown. 0: all are. The EXR has all.",
     0, 1000},
    {"cameraresponse", String, "",
     "File of the response curves of a camera or film, as in Grossberg and Nayar's database, "
     "applied to the PNG after the kernel."},
};

/// Taken from any scene without a word: the picture is the same with or without them, or
/// warn_of_ignored_film_parameters speaks when their value matters.
constexpr ParameterDeclaration kAccepted[] = {
    {"write_exr", Bool, "false", "Ignored: the EXR is always written."},
    {"write_exr_halftype", Bool, "true", "Ignored: the EXR holds 32-bit floats."},
    {"write_exr_compressiontype", String, "PIZ (lossless)", "Ignored: always lossless (ZIP)."},
    {"write_exr_applyimaging", Bool, "true", "Ignored: the EXR holds raw radiance."},
    {"write_exr_gamutclamp", Bool, "true", "Ignored: the EXR holds raw radiance."},
    {"write_exr_ZBuf", Bool, "false", "Ignored: no depth channel is written."},
    {"write_exr_zbuf_normalizationtype", String, "None", "Ignored: no depth channel is written."},
    {"write_png", Bool, "true", "Ignored: the PNG is always written."},
    {"write_png_16bit", Bool, "false", "Ignored: the PNG has 8 bits per channel."},
    {"write_png_gamutclamp", Bool, "true", "Ignored: colours are clamped by ldr_clamp_method."},
    {"write_png_ZBuf", Bool, "false", "Ignored: no depth image is written."},
    {"write_png_zbuf_normalizationtype", String, "Min/Max", "Ignored: no depth image is written."},
    {"write_tga", Bool, "false", "Ignored: no TGA file is written."},
    {"write_tga_channels", String, "RGB", "Ignored: no TGA file is written."},
    {"write_tga_gamutclamp", Bool, "true", "Ignored: no TGA file is written."},
    {"write_tga_ZBuf", Bool, "false", "Ignored: no TGA file is written."},
    {"write_tga_zbuf_normalizationtype", String, "Min/Max", "Ignored: no TGA file is written."},
    {"write_resume_flm", Bool, "false", "Ignored: no FLM file is written."},
    {"restart_resume_flm", Bool, "false", "Ignored: no FLM file is read."},
    {"write_flm_direct", Bool, "false", "Ignored: no FLM file is written."},
    {"flmwriteinterval", Integer, "60", "Ignored: no FLM file is written."},
    {"tilecount", Integer, "0", "Ignored: the film isn't tiled."},
    {"convergencestep", Float, "32",
     "Ignored: the error is compared whenever the passes have grown by an eighth."},
    {"disable_noisemap_update", Bool, "false", "Ignored: there is no noise map."},
    {"usersamplingmap_filename", String, "", "Ignored: all pixels get as many samples."},
    {"reject_warmup", Integer, "64", "Ignored: outliers are told by all samples so far."},
    {"filterquality", Integer, "", "Ignored: the pixel filter's table has one size."},
    {"debug", Bool, "false", "Ignored."},
    {.name = "colorspace_red",
     .type = Float,
     .default_text = "0.63 0.34",
     .doc = "Chromaticity x y of the film's red.",
     .array = true},
    {.name = "colorspace_green",
     .type = Float,
     .default_text = "0.31 0.595",
     .doc = "Chromaticity x y of the film's green.",
     .array = true},
    {.name = "colorspace_blue",
     .type = Float,
     .default_text = "0.155 0.07",
     .doc = "Chromaticity x y of the film's blue.",
     .array = true},
    {.name = "colorspace_white",
     .type = Float,
     .default_text = "0.314275 0.329411",
     .doc = "Chromaticity x y of the film's white.",
     .array = true},
    {"false_method", String, "linear", "Ignored: there are no false colours."},
    {"false_colorscale", String, "std", "Ignored: there are no false colours."},
    {"false_max", Float, "0", "Ignored: there are no false colours."},
    {"false_min", Float, "0", "Ignored: there are no false colours."},
    {"bloom_enabled", Bool, "false", "Ignored: no lens effects."},
    {"bloom_radius", Float, "0.07", "Ignored: no lens effects."},
    {"bloom_weight", Float, "0.25", "Ignored: no lens effects."},
    {"vignetting_enabled", Bool, "false", "Ignored: no lens effects."},
    {"vignetting_scale", Float, "0.4", "Ignored: no lens effects."},
    {"abberation_enabled", Bool, "false", "Ignored: no lens effects."},
    {"abberation_amount", Float, "0.005", "Ignored: no lens effects."},
    {"glare_enabled", Bool, "false", "Ignored: no lens effects."},
    {"glare_amount", Float, "0.03", "Ignored: no lens effects."},
    {"glare_radius", Float, "0.03", "Ignored: no lens effects."},
    {"glare_blades", Integer, "3", "Ignored: no lens effects."},
    {"glare_threshold", Float, "0.5", "Ignored: no lens effects."},
    {"glarelashesfilename", String, "", "Ignored: no lens effects."},
    {"glarepupilfilename", String, "", "Ignored: no lens effects."},
    past("write_tonemapped_exr", Bool, "true",
         "Of LuxRender 0.x: the EXR always holds raw linear radiance."),
    past("write_untonemapped_exr", Bool, "false",
         "Of LuxRender 0.x: the EXR is always written so."),
    past("write_tonemapped_tga", Bool, "false", "Of LuxRender 0.x: no TGA file is written."),
    past("write_tonemapped_igi", Bool, "false", "Of LuxRender 0.x: no IGI file is written."),
    past("write_untonemapped_igi", Bool, "false", "Of LuxRender 0.x: no IGI file is written."),
};

constexpr ParameterDeclaration kMultiImage[] = {
    past("igi_filename", String, "", "No IGI file is written."),
    past("igi_writeinterval", Integer, "60", "No IGI file is written."),
    past("ldr_filename", String, "", "The PNG is named like the EXR."),
    past("ldr_writeinterval", Integer, "60", "The PNG is written with the EXR."),
    past("ldr_displayinterval", Integer, "12", "There is no window."),
    past("dither", Float, "0", "The PNG isn't dithered."),
};

struct IgnoredFlag {
    std::string_view name, consequence;
    bool neutral = false;  ///< changes nothing
};

constexpr IgnoredFlag kIgnoredFlags[] = {
    {"write_exr_halftype", "the EXR always holds 32-bit floats"},
    {"write_exr_applyimaging", "the EXR always holds raw linear radiance"},
    {"write_exr_ZBuf", "no depth channel is written"},
    {"write_png", "the PNG is always written", true},
    {"write_png_ZBuf", "no depth image is written"},
    {"write_png_gamutclamp", "colours are clamped by ldr_clamp_method", true},
    {"write_png_16bit", "the PNG has 8 bits per channel"},
    {"write_tga", "no TGA file is written"},
    {"write_resume_flm", "no FLM file is written"},
    {"restart_resume_flm", "no FLM file is read"},
    {"write_flm_direct", "no FLM file is written"},
    {"bloom_enabled", "no lens effects are applied"},
    {"vignetting_enabled", "no lens effects are applied"},
    {"abberation_enabled", "no lens effects are applied"},
    {"glare_enabled", "no lens effects are applied"},
};

struct IgnoredText {
    std::string_view name, neutral, consequence;
};

constexpr IgnoredText kIgnoredTexts[] = {
    {"usersamplingmap_filename", "", "all pixels get as many samples"},
};

}  // namespace

std::vector<ParameterDeclaration> film_parameters(std::string_view plugin) {
    std::vector<ParameterDeclaration> all(std::begin(kPicture), std::end(kPicture));
    all.insert(all.end(), std::begin(kAccepted), std::end(kAccepted));
    if (plugin == "multiimage") {
        all.insert(all.end(), std::begin(kMultiImage), std::end(kMultiImage));
    }
    return all;
}

void warn_of_ignored_film_parameters(const ParameterReader& reader) {
    for (const IgnoredFlag& flag : kIgnoredFlags) {
        if (reader.boolean(flag.name, flag.neutral) != flag.neutral)
            warn_of_no_effect(reader, flag.name, flag.consequence);
    }
    for (const IgnoredText& text : kIgnoredTexts) {
        if (reader.string(text.name, text.neutral) != text.neutral) {
            warn_of_no_effect(reader, text.name, text.consequence);
        }
    }
}

}  // namespace lxs
