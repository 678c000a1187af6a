// Whether an image shows anything, and if not, why.
#include "lxs/host/image_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory_resource>
#include <numbers>

#include "lxs/sdk/rays.h"
#include "lxs/sdk/warp.h"

namespace lxs {
namespace {

constexpr std::uint32_t kRaysPerAxis = 24;
constexpr std::size_t kMostLights = 16;  ///< that are looked for from one point
constexpr int kPointsPerLight = 4;

/// Runs `visit` with the nearest surface along a ray, if there is one.
template <class Visit>
bool meet(const Scene& scene, const Ray& ray, const Visit& visit) {
    std::pmr::monotonic_buffer_resource memory;
    SurfaceHit hit;
    if (!scene.intersect(ray, hit, memory)) return false;
    visit(hit);
    return true;
}

/// What rays through the image find.
class Survey {
  public:
    explicit Survey(const RenderSession& session)
        : scene_(*session.scene), time_(session.camera->shutter_open()) {
        const Film& film = *session.film;
        for (std::uint32_t j = 0; j < kRaysPerAxis; ++j) {
            for (std::uint32_t i = 0; i < kRaysPerAxis; ++i) {
                const Vec2 share(offset(i), offset(j));
                const Vec2 place(share.x * static_cast<float>(film.width()),
                                 share.y * static_cast<float>(film.height()));
                look(session.camera->generate({place, Vec2(0.5f)}, time_).ray);
            }
        }
        view_ /= static_cast<float>(kRaysPerAxis * kRaysPerAxis);
        origin_ /= static_cast<float>(kRaysPerAxis * kRaysPerAxis);
    }

    std::string reason() const {
        const auto& lights = scene_.lights();
        if (std::none_of(lights.begin(), lights.end(), [](auto* l) { return l->power() > 0; }))
            return "no light of the scene gives any light";
        if (met_ == 0) return nothing_in_view();
        if (reached_ > 0) {
            return "light reaches what the camera sees, but none came from there to the camera: "
                   "the "
                   "surfaces may be black, or the way takes more passes or bounces";
        }
        if (behind_specular_ > 0) {
            return "light comes by glass or mirrors alone, where shadow rays end; photons "
                   "(SurfaceIntegrator \"aips\") find such ways";
        }
        if (is_enclosed()) {
            return "the camera stands inside a closed object, which none of the lights shines into";
        }
        return fmt::format(
            "no light reaches what the camera sees: of {} straight ways from there "
            "to the lights none is free",
            tried_);
    }

  private:
    static float offset(std::uint32_t i) {
        return (static_cast<float>(i) + 0.5f) / static_cast<float>(kRaysPerAxis);
    }

    void look(const Ray& ray) {
        view_ += ray.direction;
        origin_ += ray.origin;
        meet(scene_, ray, [&](const SurfaceHit& hit) {
            ++met_;
            if (reached_ == 0) look_for_lights(hit, -ray.direction);
        });
    }

    void look_for_lights(const SurfaceHit& hit, const Vec3& wo) {
        const auto& lights = scene_.lights();
        for (std::size_t i = 0; i < std::min(lights.size(), kMostLights); ++i) {
            // Of many lights others are looked for from each point.
            const Light& light = *lights[(i + met_ * kMostLights) % lights.size()];
            for (int k = 0; k < kPointsPerLight; ++k)
                look_for(light, hit, wo, Vec2(k % 2 == 0 ? 0.25f : 0.75f, k < 2 ? 0.25f : 0.75f));
        }
    }

    void look_for(const Light& light, const SurfaceHit& hit, const Vec3& wo, const Vec2& u) {
        DirectSample sample;
        if (!light.sample_direct(hit.p, hit.ng, u, sample) || !(sample.pdf > 0)) return;
        ++tried_;
        if (is_black(sample.radiance) || !may_scatter(hit, wo, sample.wi)) return;
        const Ray ray = shadow_ray(hit, sample, time_);
        if (max_component(scene_.transmittance(ray)) > 0) {
            ++reached_;
        } else {
            meet(scene_, ray, [&](const SurfaceHit& obstacle) {
                if (obstacle.bsdf && (obstacle.bsdf->lobes() & kSpecular)) ++behind_specular_;
            });
        }
    }

    /// Whether light from `wi` can leave towards `wo`: on the same side it reaches what is seen,
    /// even if that is black.
    static bool may_scatter(const SurfaceHit& hit, const Vec3& wo, const Vec3& wi) {
        if (wo.dot(hit.ng) * wi.dot(hit.ng) > 0) return true;
        if (!hit.bsdf) return false;
        return (hit.bsdf->lobes() & kSpecular) != 0 ||
               !is_black(hit.bsdf->evaluate(wo, wi, Transport::Radiance, kAllLobes));
    }

    std::string nothing_in_view() const {
        constexpr const char* kPlain = "the camera sees no surface";
        const Bounds bounds = scene_.bounds();
        if (bounds.isEmpty()) return fmt::format("{}: the scene has none", kPlain);
        const Vec3 to_scene = bounds.center() - origin_;
        const double cosine = to_scene.normalized().dot(view_.normalized());
        const double degrees = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
        return fmt::format(
            "{}: it looks {:.0f} degrees past the middle of the scene, at a distance "
            "of {:.3g}",
            kPlain, degrees, to_scene.length());
    }

    /// Whether surfaces are met all around the camera.
    bool is_enclosed() const {
        constexpr int kDirections = 256;
        for (int i = 0; i < kDirections; ++i) {
            Ray ray;
            ray.origin = origin_;
            ray.direction = direction_on_sphere(i, kDirections);
            ray.time = time_;
            if (!meet(scene_, ray, [](const SurfaceHit&) {})) return false;
        }
        return true;
    }

    const Scene& scene_;
    float time_;
    Vec3 view_{0.0f}, origin_{0.0f};       ///< means over the rays
    std::size_t met_ = 0;                  ///< rays that meet a surface
    std::size_t tried_ = 0, reached_ = 0;  ///< ways from there to lights, and those that are free
    std::size_t behind_specular_ = 0;      ///< of the ways, those that end at glass or a mirror
};

ImageVerdict::Appearance appearance_of(std::span<const std::uint8_t> bytes) {
    using enum ImageVerdict::Appearance;
    const auto all = [&](std::uint8_t value) {
        return std::all_of(bytes.begin(), bytes.end(), [=](auto byte) { return byte == value; });
    };
    return all(0) ? Black : all(255) ? White : Varied;
}

std::string reason_of_darkness(const RenderSession& session) {
    try {
        return Survey(session).reason();
    } catch (const std::exception& error) {  // the image is written, whatever its surfaces do now
        return fmt::format("not found out: {}", error.what());
    }
}

std::string reason_of_exposure(const FileFilm& film, const std::vector<Rgb>& image) {
    std::vector<float> values;
    std::transform(image.begin(), image.end(), std::back_inserter(values),
                   [](const Rgb& c) { return luminance(c); });
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return fmt::format("the exposure: luminances from {:.3g} to {:.3g}, under tonemapkernel \"{}\"",
                       *least, *most, film.tone_map_kernel());
}

}  // namespace

std::string_view ImageVerdict::name() const {
    switch (appearance) {
        case Appearance::Black:
            return "black";
        case Appearance::White:
            return "white";
        case Appearance::Varied:
            break;
    }
    return "varied";
}

ImageVerdict judge_image(const RenderSession& session) {
    ImageVerdict verdict{appearance_of(session.film->tone_mapped()), {}};
    if (verdict.appearance == ImageVerdict::Appearance::Varied) return verdict;
    const std::vector<Rgb> image = session.film->image();
    const bool dark =
        std::all_of(image.begin(), image.end(), [](const Rgb& c) { return is_black(c); });
    verdict.reason = dark ? reason_of_darkness(session) : reason_of_exposure(*session.film, image);
    return verdict;
}

}  // namespace lxs
