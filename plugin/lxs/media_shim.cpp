// The host's media in the engine's terms.
#include "media_shim.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "convert.h"
#include "lxs/sdk/medium.h"
#include "lxs/sdk/rays.h"

namespace aips::shim {
namespace {

class MediaShim final : public Media {
  public:
    explicit MediaShim(const lxs::Scene& scene) : scene_(scene) {}

    bool scatters(const void* medium) const override {
        return medium && medium_of(medium).scatters();
    }
    const void* alone(const void* medium) const override {
        return mark_of(lxs::EnteredMedia().entered(media_of(medium).innermost()));
    }
    Rgb extinction(const void* medium) const override {
        return from(medium_of(medium).extinction());
    }
    Rgb scattering(const void* medium) const override {
        return from(medium_of(medium).scattering());
    }
    Rgb scattering_at(const void* medium, Vec3 position) const override {
        return from(medium_of(medium).scattering_at(to(position)));
    }
    Flight sample_flight(const void* medium, const Ray& ray, float segment, Rgb carried,
                         Vec2 u) const override {
        const lxs::Flight f = medium_of(medium).sample_flight(to(ray.origin), to(ray.direction),
                                                              segment, to(carried), to(u));
        return {f.distance, f.collides, from(f.weight)};
    }
    void transmittances(const void* medium, const Ray& ray, std::span<const float> distances,
                        float u, std::span<Rgb> shares) const override {
        const lxs::Medium& crossed = medium_of(medium);
        if (!crossed.varies()) return Media::transmittances(medium, ray, distances, u, shares);
        if (distances.empty()) return;
        std::vector<lxs::TransmittanceStep> steps;
        crossed.transmittance_steps(to(ray.origin), to(ray.direction),
                                    *std::ranges::max_element(distances), u, steps);
        for (std::size_t i = 0; i < distances.size(); ++i) {
            const auto beyond =
                std::ranges::upper_bound(steps, distances[i], {}, &lxs::TransmittanceStep::from);
            shares[i] = from(std::prev(beyond)->passed);
        }
    }
    Rgb phase(const void* medium, float cosine) const override {
        return from(medium_of(medium).phase(cosine));
    }
    void phases(const void* medium, std::span<const float> cosines,
                std::span<Rgb> values) const override {
        const lxs::Medium& turned_by = medium_of(medium);
        for (std::size_t i = 0; i < cosines.size(); ++i)
            values[i] = from(turned_by.phase(cosines[i]));
    }
    PhaseSample sample_phase(const void* medium, Vec3 direction, Rgb carried,
                             Vec2 u) const override {
        const auto s = medium_of(medium).sample_phase(to(direction), to(carried), to(u));
        return {from(s.direction), from(s.weight)};
    }
    Rgb visibility(const void* medium, Vec3 origin, const DirectSample& light,
                   float time) const override {
        return from(scene_.transmittance(
            lxs::shadow_ray_from_medium(to(origin), to(light), time, media_of(medium))));
    }

  private:
    /// That a ray with this mark, which is none of vacuum, travels in.
    const lxs::Medium& medium_of(const void* mark) const { return *scene_.medium(media_of(mark)); }

    const lxs::Scene& scene_;
};

}  // namespace

std::unique_ptr<Media> make_media_shim(const lxs::Scene& scene) {
    return std::make_unique<MediaShim>(scene);
}

}  // namespace aips::shim
