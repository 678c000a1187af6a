// Camera, sampler, pixel filter and film, made from a scene's option statements.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lxs/imaging/error_estimate.h"
#include "lxs/imaging/file_layers.h"
#include "lxs/scene/contents.h"
#include "lxs/sdk/camera.h"
#include "lxs/sdk/film.h"
#include "lxs/sdk/invalid_samples.h"
#include "lxs/sdk/parameters.h"
#include "lxs/sdk/scene.h"
#include "lxs/sdk/state_archive.h"
#include "lxs/spectrum/wavelengths.h"

namespace lxs {

/// A layer beside the image: values of its channels, pixel by pixel, row by row.
struct HeldLayer {
    std::uint32_t channels = 1;
    std::vector<float> values = {};
};

/// What the film keeps beyond the interface that integrators see.
class FileFilm : public Film {
  public:
    /// File name of the Film statement without suffix ("filename"), default "luxout".
    virtual std::string base_name() const = 0;
    virtual double halt_time_seconds() const = 0;         ///< "halttime", 0: none
    virtual std::uint64_t halt_passes() const = 0;        ///< "haltspp", 0: none
    virtual double write_interval_seconds() const = 0;    ///< "writeinterval", 0: none
    virtual double display_interval_seconds() const = 0;  ///< "displayinterval", 0: none
    virtual double halt_error() const = 0;                ///< "haltthreshold", 0: none

    /// Whether the film estimates its own error: what passes bring from now on is watched for it,
    /// to be asked for before the first pass or state(). The image keeps its bits. It takes 24
    /// bytes a pixel, 60 with photons.
    virtual void estimate_errors(bool wanted) = 0;
    /// Whether the film keeps what its image can be denoised from: halves of its passes and layers
    /// that guide. To be asked for before the first pass or state(), and before an integrator asks
    /// for layers_wanted(). The image keeps its bits. It takes 152 bytes a pixel beside those of
    /// three layers, 120 without photons.
    virtual void keep_for_denoising(bool wanted) = 0;
    /// Whoever runs passes says when one has ended, if errors are to be estimated or the
    /// image denoised.
    virtual void end_pass() = 0;
    /// The error of the image so far; nothing before the third pass, or if it isn't estimated.
    /// Takes some 0.1 us a pixel.
    virtual std::optional<ErrorEstimate> error() const = 0;
    virtual std::uint64_t refused_samples() const = 0;  ///< over all layers
    /// The same by light group and layer.
    virtual InvalidSampleList invalid_samples() const = 0;
    virtual std::size_t memory_bytes() const = 0;

    /// Saves or restores everything that passes have left in the film. Throws StateError if what is
    /// restored is of another film.
    virtual void state(StateArchive& archive) = 0;

    /// From now on passes hold values at these wavelengths; images stay linear RGB.
    virtual void set_wavelengths(const Wavelengths& wavelengths) = 0;
    /// Names that SeenSurface tells objects and materials by; before the first pass.
    virtual void set_names(std::span<const std::string> objects,
                           std::span<const std::string> materials) = 0;
    /// Whether the camera is not to see lights at infinity, as the film has an alpha channel in
    /// their place.
    virtual bool hides_background() const = 0;
    /// From now on the PNG is brighter by this many stops (factors of 2), whatever the kernel.
    virtual void set_exposure(double stops) = 0;
    /// The mean image over passes and light groups: width * height, row by row, linear radiance.
    virtual std::vector<Rgb> image() const = 0;
    /// Likewise, denoised (see denoise.h); empty if that wasn't asked for, or before the fourth
    /// pass. Takes some 15 us of processor time a pixel.
    virtual std::vector<Rgb> denoised() const = 0;
    /// The image as it is to be displayed: where the filter's negative lobes have made a ring
    /// beside what is bright, what its central lobe alone shows.
    virtual std::vector<Rgb> shown() const = 0;
    /// Share of the light that is left out of it as outliers; nothing if none are to be.
    virtual std::optional<double> outliers_left_out() const = 0;
    /// That as the PNG has it: 8 bits of red, green and blue per pixel.
    virtual std::vector<std::uint8_t> tone_mapped() const = 0;
    virtual std::string_view tone_map_kernel() const = 0;  ///< as the Film statement names it
    /// Names of the layers that it has so far beside the image, as the EXR names them: of light
    /// groups, of the integrator, of its own error. Those for compositing are in the file alone.
    virtual std::vector<std::string> held_layers() const = 0;
    /// One of these as the EXR has it, groups before they are fitted to the image's rounding; no
    /// values if there is none of this name.
    virtual HeldLayer held_layer(std::string_view name) const = 0;
    /// What its EXR holds: linear radiance; each light group (if more than one) and each extra
    /// layer as a named layer, and `denoised` if there is such an image.
    virtual FileLayers file_layers(const ImageMetadata& metadata,
                                   std::span<const Rgb> denoised = {}) const = 0;
    /// Writes that (see file_layers.h).
    void write_exr(const std::string& path, const ImageMetadata& metadata,
                   std::span<const Rgb> denoised = {}) const;
    /// Writes the tonemapped 8-bit sRGB image of what is shown, or of `denoised` if there is one,
    /// likewise without rings; written beside and renamed likewise.
    virtual void write_png(const std::string& path, std::span<const Rgb> denoised = {}) const = 0;
};

/// Path of the file that a scene names; throws InputError if there is none.
using FileResolver = std::function<std::string(const std::string& name, const SourceLocation&)>;

/// Film, with the pixel filter inside, from the "Film" and "PixelFilter" statements. Without a
/// resolver no file is read.
std::unique_ptr<FileFilm> make_film(const SceneContents& contents, Diagnostics& diagnostics,
                                    const FileResolver& resolve = {});

/// What a scene's camera has beyond the interface that integrators see.
class SceneCamera : public Camera {
  public:
    /// Depth at which the image is sharp, scene units.
    virtual double focal_distance() const = 0;
    /// Autofocus, if the statement asks for it: to the depth where the ray through the middle of
    /// the whole image meets the scene, if it does. To be called before rendering.
    virtual void focus(const Scene& scene) = 0;
    /// What it stands in from now on; vacuum before.
    virtual void set_media(const EnteredMedia& media) = 0;
    /// Whether rays depend on where on the lens they start.
    virtual bool has_lens() const = 0;
};

/// Camera from the "Camera" statement; needs the film's full resolution and crop window.
std::unique_ptr<SceneCamera> make_camera(const SceneContents& contents, const Film& film,
                                         Diagnostics& diagnostics);

/// What camera samples say of the lens: a place that is drawn, or its middle, for a camera that has
/// none.
enum class LensUse : std::uint8_t { Drawn, None };

/// Parameters that are a sampler's own ("metropolis": of its chains); empty for all others.
std::span<const ParameterDeclaration> sampler_parameters(std::string_view sampler);

/// Declared parameters of an option plugin: "Camera", "Film", "PixelFilter" or "Sampler", and a
/// name that LuxRender knows; for docs and messages.
std::vector<ParameterDeclaration> option_parameters(const std::string& statement,
                                                    const std::string& plugin);

/// Camera samples: Owen-scrambled (0,2)-sequences over the passes, per pixel; checks "Sampler".
/// With `runs_metropolis` it passes on the settings of Sampler "metropolis", else it warns that
/// there are no Markov chains.
std::unique_ptr<Sampler> make_sampler(const SceneContents& contents, std::uint64_t seed,
                                      Diagnostics& diagnostics, bool runs_metropolis = false,
                                      LensUse lens = LensUse::Drawn);

}  // namespace lxs
