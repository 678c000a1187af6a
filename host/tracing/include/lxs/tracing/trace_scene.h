// Builds the traceable scene: geometry in Embree, lights, media.
#pragma once

#include <memory>

#include "lxs/lights/lights.h"
#include "lxs/scene/contents.h"
#include "lxs/sdk/refusal.h"
#include "lxs/sdk/scene.h"
#include "lxs/sdk/state_archive.h"
#include "lxs/spectrum/wavelengths.h"

namespace lxs {

/// The scene with what the host alone may ask of it.
class TraceScene : public Scene {
  public:
    /// From now on colours mean values at these wavelengths, not R, G and B. To be called before
    /// lights() is used the first time, and only while nobody traces.
    virtual void set_wavelengths(const Wavelengths& wavelengths) = 0;
    /// Values of textures so far that were not finite, or negative colours, and were replaced: by
    /// the material or the light whose texture it is.
    virtual RefusalList refused_values() const = 0;
    /// Saves or restores their counts, which are all that passes leave in a scene. Throws
    /// StateError if what is restored is of another scene.
    virtual void state(StateArchive& archive) = 0;
};

/// Takes over the contents and builds acceleration structures and lights. The build is
/// deterministic: the same contents give the same hits, ties included, for any number of threads.
std::unique_ptr<TraceScene> make_trace_scene(SceneContents contents, const AssetResolver& resolve,
                                             Diagnostics& diagnostics);

}  // namespace lxs
