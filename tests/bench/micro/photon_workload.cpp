// Records rays and photons of unguided photons.
#include "photon_workload.h"

#include <tbb/task_arena.h>

#include <algorithm>

#include "eye/light_choice.h"
#include "lxs/language/asset_finder.h"
#include "lxs/language/read_scene.h"
#include "lxs/tracing/trace_scene.h"
#include "photons/photon_iteration.h"
#include "scene_shim.h"

namespace aips::bench {
namespace {

/// A scene that keeps the rays asked of it; for one thread.
class RecordingScene final : public Scene {
  public:
    RecordingScene(const Scene& scene, std::vector<Ray>& rays) : scene_(scene), rays_(rays) {}

    bool intersect(const Ray& ray, SurfacePoint& point,
                   std::pmr::memory_resource& memory) const override {
        rays_.push_back(ray);
        return scene_.intersect(ray, point, memory);
    }
    Ray spawn(const SurfacePoint& point, Vec3 direction, float time) const override {
        return scene_.spawn(point, direction, time);
    }
    Rgb visibility(const SurfacePoint& point, const DirectSample& light,
                   float time) const override {
        return scene_.visibility(point, light, time);
    }
    std::span<const Light* const> lights() const override { return scene_.lights(); }
    std::span<const std::string> material_names() const override { return scene_.material_names(); }
    std::uint32_t light_groups() const override { return scene_.light_groups(); }
    Bounds bounds() const override { return scene_.bounds(); }
    SceneFacts facts() const override { return scene_.facts(); }

  private:
    const Scene& scene_;
    std::vector<Ray>& rays_;
};

/// Warnings of a scene of ours would be a bug, which the tests of scenes find.
class NoDiagnostics final : public lxs::Diagnostics {
  public:
    void warning(const lxs::SourceLocation&, const std::string&) override {}
    void unknown_parameter(const lxs::SourceLocation&, const std::string&) override {}
};

void read(PhotonWorkload& work) {
    NoDiagnostics diagnostics;
    lxs::Registry registry;
    lxs::register_shapes(registry);
    lxs::register_shading(registry);
    lxs::SceneContents contents = lxs::read_scene(SCENES "/cornell-box.lxs", registry, diagnostics);
    for (const lxs::Primitive& primitive : contents.primitives)
        work.geometry.push_back(primitive.geometry);
    lxs::AssetFinder finder(contents.directory);
    const auto resolve = [&](const std::string& name, const lxs::SourceLocation& where) {
        return finder.find(name, where, diagnostics);
    };
    work.host_scene = lxs::make_trace_scene(std::move(contents), resolve, diagnostics);
    work.scene = std::make_unique<shim::SceneShim>(*work.host_scene);
}

PhotonWorkload recorded() {
    PhotonWorkload work;
    read(work);
    work.paths = 200000;
    const RecordingScene scene(*work.scene, work.rays);
    const Settings settings;
    const DiscreteDistribution lights = light_choice(scene);
    InvalidSampleFilter filter(scene);
    PhotonStore store;
    tbb::task_arena(1).execute([&] {
        PhotonTracer().trace({scene, settings, lights}, 0, 0, work.paths, filter, store);
    });
    work.photons.assign(store.photons().begin(), store.photons().end());
    return work;
}

}  // namespace

const PhotonWorkload& photon_workload() {
    static const PhotonWorkload work = recorded();
    return work;
}

std::span<const Photon> photons_of_paths(std::uint32_t first, std::uint32_t count) {
    const std::vector<Photon>& all = photon_workload().photons;
    const auto before = [](const Photon& photon, std::uint32_t path) { return photon.path < path; };
    const auto begin = std::lower_bound(all.begin(), all.end(), first, before);
    return {begin, std::lower_bound(begin, all.end(), first + count, before)};
}

}  // namespace aips::bench
