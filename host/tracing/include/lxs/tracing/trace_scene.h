// Builds the traceable scene: geometry in Embree, lights, media.
#pragma once

#include <memory>

#include "lxs/lights/lights.h"
#include "lxs/scene/contents.h"
#include "lxs/sdk/invalid_samples.h"
#include "lxs/sdk/scene.h"
#include "lxs/sdk/state_archive.h"
#include "lxs/spectrum/spectral_fidelity.h"
#include "lxs/spectrum/wavelength_density.h"

namespace lxs {

/// What colours that are given as spectra ask of a render.
struct SpectralNeed {
    bool given = false;       ///< there are any
    Misrepresentation worst;  ///< by RGB, of a lamp on a surface or through a medium

    bool misrepresented() const { return worst.difference > kTolerated; }
};

/// The scene with what the host alone may ask of it.
class TraceScene : public Scene {
  public:
    /// From now on colours mean values at these wavelengths, not R, G and B. To be called before
    /// lights() is used the first time, and only while nobody traces.
    virtual void set_wavelengths(const Wavelengths& wavelengths) = 0;
    virtual const SpectralNeed& spectral_need() const = 0;
    /// What the wavelengths of passes are to be drawn from.
    virtual WavelengthDensity wavelength_density() const = 0;
    /// Values of textures so far that were not finite, or negative colours, and were replaced: by
    /// the material or the light whose texture it is.
    virtual InvalidSampleList refused_values() const = 0;
    /// Where each light stands in the scene's text, by its index in lights().
    virtual std::span<const SourceLocation> light_places() const = 0;
    /// In what the camera stands: the Exterior at WorldEnd, and the bodies around it.
    virtual const EnteredMedia& camera_media() const = 0;
    /// What an author may want to know of the scene's media, each with its place: where lights and
    /// camera stand, and declarations that do not fit or are missing.
    virtual std::vector<std::string> media_notes() const = 0;
    /// Saves or restores their counts, which are all that passes leave in a scene. Throws
    /// StateError if what is restored is of another scene.
    virtual void state(StateArchive& archive) = 0;
};

/// Takes over the contents and builds acceleration structures and lights. The build is
/// deterministic: the same contents give the same hits, ties included, for any number of threads.
std::unique_ptr<TraceScene> make_trace_scene(SceneContents contents, const AssetResolver& resolve,
                                             Diagnostics& diagnostics);

}  // namespace lxs
