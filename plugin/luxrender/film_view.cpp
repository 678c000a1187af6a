// LuxRender's film and log in plain numbers.
//
// Three buffers add up to the image: what eye paths see and what photons bring are means of their
// samples by weight, each for itself, and splats a mean over passes.
#include "context.h"
#include "error.h"
#include "scene_view.h"

namespace aips::luxrender {

void SceneView::add_sample(FilmPart part, const float position[2], const Triple& radiance,
                           unsigned group, double weight) {
    luxrays::SWCSpectrum values(0.f);
    // LuxRender's colour is a sum over wavelengths at even distances.
    constexpr float kPerDistance = WAVELENGTH_SAMPLES / (WAVELENGTH_END - WAVELENGTH_START);
    for (unsigned k = 0; k < 3; ++k)
        values.c[k] = radiance.v[k] * per_density_.v[k] * kPerDistance;
    const unsigned buffer = part == FilmPart::Eye       ? buffers_.eye
                            : part == FilmPart::Photons ? buffers_.photons
                                                        : buffers_.splats;
    lux::Contribution contribution(
        position[0] + float(film_.GetXPixelStart()), position[1] + float(film_.GetYPixelStart()),
        luxrays::XYZColor(wavelengths_, values), 1.f, 0.f, float(weight), buffer, group);
    film_.AddSample(&contribution);
}

void SceneView::end_film_pass() {
    film_.AddSampleCount(double(film_width()) * film_height());
}

void SceneView::info(const std::string& message) {
    LOG(LUX_DEBUG, LUX_NOERROR) << "aips: " << message;
}

void SceneView::warning(const std::string& message) {
    LOG(LUX_WARNING, LUX_NOERROR) << "aips: " << message;
}

}  // namespace aips::luxrender
