// LuxRender's scene and film in plain numbers: what the two halves of this shim tell each other.
// LuxRender's headers need C++17 (with g++ 12) and the engine's C++20, so that no file includes
// both. This one is C++17 and includes neither.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace aips::luxrender {

/// A point or direction, or the values at a pass's three wavelengths, the longest first.
struct Triple {
    float v[3] = {0, 0, 0};
};

/// Kinds of lobes, bits as the engine's LobeMask has them.
inline constexpr unsigned kDiffuseLobe = 1, kGlossyLobe = 2, kSpecularLobe = 4;

struct ViewRay {
    Triple origin;
    Triple direction;  ///< unit
    float time = 0;
    const void* volume = nullptr;  ///< LuxRender's volume that the ray travels in
    int component = -1;            ///< the one wavelength that a dispersed path still has; -1: all
};

/// Where a ray meets a surface.
struct ViewHit {
    Triple position, geometric_normal, shading_normal;
    float distance = 0;
    float error = 0;  ///< bound of rounding in the position, by which rays that leave are moved
    Triple transmittance;                                 ///< of the volume passed
    Triple emitted;                                       ///< radiance towards the ray's origin
    int light = -1;                                       ///< of lights(), -1 for none
    const void *interior = nullptr, *exterior = nullptr;  ///< volumes on both sides
};

/// A direction drawn by a material.
struct ViewScattering {
    Triple wi;
    Triple weight;  ///< f |cos(wi, ns)| / pdf
    float pdf = 0;  ///< per steradian; 0 for specular lobes
    unsigned lobe = 0;
    bool straight = false;
    int component = -1;
};

/// A photon as it leaves a light.
struct ViewEmission {
    ViewRay ray;
    Triple power;  ///< emitted radiance * cosine / density
};

/// A direction to a light.
struct ViewDirect {
    Triple wi;
    float distance = 0;
    Triple radiance;  ///< for delta lights irradiance facing `wi`
    float pdf = 0;    ///< per steradian; 1 for delta lights
    bool delta = false;
    Triple end;  ///< the light's point
};

/// Which mean of the film a sample belongs to.
enum class FilmPart { Eye, Photons, Splats };

/// All const members may be called from many threads; a pass has the same wavelengths throughout.
class LuxView {
  public:
    virtual ~LuxView() = default;

    /// Sum of the standard observer's three functions, by which wavelengths are chosen.
    virtual float sensitivity(float nanometres) const = 0;
    /// Range of wavelengths that LuxRender renders, nanometres.
    virtual float shortest_wavelength() const = 0;
    virtual float longest_wavelength() const = 0;
    /// Sets the wavelengths of all that follows; between passes only. `per_density[k]` is one over
    /// the density with which wavelength k was drawn, nanometres, over the number of wavelengths.
    virtual void set_wavelengths(const Triple& nanometres, const Triple& per_density) = 0;

    virtual void bounds(Triple& lower, Triple& upper) const = 0;
    virtual unsigned light_groups() const = 0;

    /// Bytes at `place` for intersect(), with the alignment of any type.
    virtual std::size_t surface_bytes() const = 0;
    /// Nearest surface. What later calls need of it is kept at `place`, without destructor. Where
    /// there is none, `distance` is infinite and `transmittance` that of the volume.
    virtual bool intersect(const ViewRay& ray, void* place, ViewHit& hit) const = 0;
    /// The same for who needs place, geometric normal and distance alone; keeps nothing.
    virtual bool intersect_shape(const ViewRay& ray, ViewHit& hit) const = 0;
    /// Share of light that gets from one point to another.
    virtual Triple visibility(const Triple& from, const Triple& to, const void* volume,
                              float time) const = 0;

    virtual unsigned lobes(const void* surface) const = 0;
    /// f per steradian, without cosine; light comes along `to_light` and goes along `to_eye`.
    virtual Triple evaluate(const void* surface, const Triple& to_light, const Triple& to_eye,
                            unsigned lobes) const = 0;
    virtual float pdf(const void* surface, const Triple& wo, const Triple& wi,
                      unsigned lobes) const = 0;
    /// `from_eye`: wo goes to the eye, else to the light.
    virtual bool sample(const void* surface, const Triple& wo, const float u[3], bool from_eye,
                        unsigned lobes, ViewScattering& scattering) const = 0;

    virtual unsigned light_count() const = 0;
    virtual unsigned light_group(unsigned light) const = 0;
    virtual bool light_at_infinity(unsigned light) const = 0;
    virtual bool light_is_delta(unsigned light) const = 0;
    /// Draws a photon from three numbers for the place and three for the direction.
    virtual bool emit(unsigned light, const float place[3], const float direction[3],
                      ViewEmission& emission) const = 0;
    virtual bool sample_direct(unsigned light, const Triple& from, const float u[3],
                               ViewDirect& sample) const = 0;
    /// Density per steradian of sample_direct() for the light's point `at` with the normal given.
    virtual float pdf_direct(unsigned light, const Triple& from, const Triple& at,
                             const Triple& normal) const = 0;
    /// The same for a light at infinity along `wi`.
    virtual float pdf_escaping(unsigned light, const Triple& from, const Triple& wi) const = 0;
    virtual Triple escaped(unsigned light, const Triple& direction) const = 0;

    /// Position in pixels of the cropped film, lens in [0,1)^2.
    virtual ViewRay camera_ray(const float film[2], const float lens[2], float time) const = 0;
    virtual float shutter_open() const = 0;
    virtual float shutter_close() const = 0;

    virtual unsigned film_width() const = 0;
    virtual unsigned film_height() const = 0;
    virtual void add_sample(FilmPart part, const float position[2], const Triple& radiance,
                            unsigned group, double weight) = 0;
    /// After the samples of a pass.
    virtual void end_film_pass() = 0;

    virtual void info(const std::string& message) = 0;
    virtual void warning(const std::string& message) = 0;
};

}  // namespace aips::luxrender
