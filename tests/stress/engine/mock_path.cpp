// Path tracing (Kajiya 1986) with next-event estimation and Russian roulette.
#include "mock_path.h"

#include <tbb/parallel_for.h>

#include "aips/core/base/arena.h"
#include "aips/core/sampling/random.h"

namespace stress {
namespace {

using namespace aips;

constexpr int kDepthBeforeRoulette = 6, kMostSurfaces = 200;

class Path {
  public:
    Path(const Scene& scene, RandomStream& random, Arena& arena)
        : scene_(scene), random_(random), arena_(arena) {}

    Rgb radiance(Ray ray) {
        ray_ = ray;
        for (int depth = 0; depth < kMostSurfaces && step(depth); ++depth) {
        }
        return sum_;
    }

  private:
    bool step(int depth) {
        arena_.reset();
        SurfacePoint point;
        if (!scene_.intersect(ray_, point, arena_)) {
            for (const Light* light : scene_.lights()) {
                if (mirrored_) sum_ += throughput_ * light->escaped(ray_.direction);
            }
            return false;
        }
        if (mirrored_) sum_ += throughput_ * point.emitted;
        if (!point.bsdf) return false;
        ask_a_light(point);
        return bounce(point) && survives(depth);
    }

    void ask_a_light(const SurfacePoint& point) {
        const auto lights = scene_.lights();
        const auto count = static_cast<float>(lights.size());
        const auto chosen =
            std::min(lights.size() - 1, static_cast<std::size_t>(random_.next() * count));
        DirectSample sample;
        if (!lights[chosen]->sample_direct(point, random_.next2(), sample)) return;
        const Rgb f =
            point.bsdf->evaluate(-ray_.direction, sample.wi, Transport::Radiance, kNonSpecular);
        if (is_black(f)) return;
        sum_ += throughput_ * f * sample.radiance * scene_.visibility(point, sample, 0) *
                (abs_dot(sample.wi, point.shading_normal) * count / sample.pdf);
    }

    bool bounce(const SurfacePoint& point) {
        BsdfSample sample;
        const Vec2 u = random_.next2();
        if (!point.bsdf->sample(-ray_.direction, u, random_.next(), Transport::Radiance, kAllLobes,
                                sample)) {
            return false;
        }
        throughput_ *= sample.weight;
        mirrored_ = sample.lobe == kSpecular;
        ray_ = scene_.spawn(point, sample.wi, 0);
        return !is_black(throughput_);
    }

    bool survives(int depth) {
        if (depth < kDepthBeforeRoulette) return true;
        const float share = std::min(0.95f, max_component(throughput_));
        if (random_.next() >= share) return false;
        throughput_ *= 1 / share;
        return true;
    }

    const Scene& scene_;
    RandomStream& random_;
    Arena& arena_;
    Ray ray_;
    Rgb throughput_ = kWhite, sum_;
    bool mirrored_ = true;  // no shadow ray could have brought what the ray meets
};

}  // namespace

std::vector<double> path_traced(const Scene& scene, const mock::Camera& camera, std::uint32_t width,
                                std::uint32_t height, std::uint32_t samples, std::uint64_t seed) {
    std::vector<double> image(std::size_t(width) * height);
    tbb::parallel_for(std::size_t{0}, image.size(), [&](std::size_t pixel) {
        Arena arena;
        for (std::uint32_t s = 0; s < samples; ++s) {
            RandomStream random(seed, s, pixel, RandomDomain::Eye);
            const Vec2 u = random.next2();
            const std::size_t x = pixel % width, y = pixel / width;
            const Vec2 film{float(x) + u.x, float(y) + u.y};
            const Ray ray = camera.generate({film, {}}, 0).ray;
            image[pixel] += double(luminance(Path(scene, random, arena).radiance(ray))) / samples;
        }
    });
    return image;
}

}  // namespace stress
