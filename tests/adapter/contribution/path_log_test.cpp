// Protects the log that guides learn from: records agree with the paths' photons, one of so many
// paths is logged, and logging changes nothing.
#include "contribution/path_log.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "eye/light_choice.h"
#include "photons/photon_iteration.h"
#include "render_mock.h"
#include "run_on_threads.h"

namespace aips::path_log_test {
namespace {

struct Traced {
    PhotonStore store;
    PathLog log;
    PhotonCounts counts;
};

/// Traces `count` paths, all of whose surfaces take photons.
Traced trace(const mock::Scene& scene, std::uint32_t count, std::uint32_t log_one_of,
             std::uint32_t in_calls = 1) {
    Settings settings = mock::small_settings(31, count);
    settings.direct_light_sampling = false;
    const DiscreteDistribution lights = light_choice(scene);
    PhotonInput input{scene, settings, lights};
    input.log_one_of = log_one_of;
    input.log_vertices = true;
    InvalidSampleFilter filter(scene);
    PhotonTracer tracer;
    Traced result;
    for (std::uint32_t call = 0; call < in_calls; ++call) {
        const std::uint32_t paths = count / in_calls;
        result.counts += tracer.trace(input, 0, call * paths, paths, filter, result.store,
                                      log_one_of > 0 ? &result.log : nullptr);
    }
    return result;
}

/// A room with a shiny ball, a lamp and a point light.
mock::Scene box() {
    mock::Scene scene;
    mock::Surface wall, ball, lamp;
    scene.add_box({-1, -1, -1}, {1, 1, 1}, wall);
    ball.shape = mock::Ball{{0.35f, 0.3f, -0.6f}, 0.4f, false};
    ball.material.kind = mock::Material::Kind::LambertAndMirror;
    ball.material.specular = {0.3f, 0.3f, 0.3f};
    scene.add(ball);
    lamp.shape = mock::Quad{{-0.3f, -0.3f, 0.98f}, {0, 0.6f, 0}, {0.6f, 0, 0}};
    lamp.emitted = {10, 10, 10};
    scene.add(lamp);
    scene.add_point_light({0.5f, -0.5f, 0.5f}, {1, 2, 3});
    scene.finish();
    return scene;
}

std::span<const Photon> photons_of(const Traced& traced, const PathRecord& path) {
    return std::span(traced.log.photons).subspan(path.first_photon, path.photons);
}

std::span<const PathVertex> vertices_of(const Traced& traced, const PathRecord& path) {
    return std::span(traced.log.vertices).subspan(path.first_vertex, path.vertices);
}

bool same_bits(std::span<const Photon> a, std::span<const Photon> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

bool same_bits(const Traced& a, const Traced& b) {
    return same_bits(a.store.photons(), b.store.photons()) &&
           same_bits(a.log.photons, b.log.photons);
}

void expect_same(const std::vector<PathRecord>& a, const std::vector<PathRecord>& b) {
    const auto same = [](const PathRecord& x, const PathRecord& y) {
        return x.light == y.light && x.start == y.start && x.pdf == y.pdf && x.rays == y.rays &&
               x.first_vertex == y.first_vertex && x.vertices == y.vertices &&
               x.first_photon == y.first_photon && x.photons == y.photons;
    };
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end(), same));
}

/// Every surface met is a photon, and every vertex is at one: depths, places, sides and powers.
void expect_vertices_at_photons(std::span<const PathVertex> vertices,
                                std::span<const Photon> photons, std::uint32_t rays) {
    for (std::size_t i = 0; i < photons.size(); ++i)
        ASSERT_EQ(photons[i].depth, i + 1);
    // The path ends where it is absorbed, or leaves the scene, or at the lamp's black back.
    ASSERT_TRUE(vertices.size() == photons.size() || vertices.size() + 1 == photons.size());
    ASSERT_TRUE(rays == photons.size() || rays == photons.size() + 1);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const PathVertex& vertex = vertices[i];
        ASSERT_EQ(vertex.depth, i + 1);
        ASSERT_EQ(vertex.rays, i + 1);
        ASSERT_EQ(vertex.position, photons[i].position);
        ASSERT_GE(dot(vertex.normal, photons[i].direction), 0);
        ASSERT_FLOAT_EQ(abs_dot(vertex.normal, photons[i].normal), 1);
        // Left by a direction drawn from Lambert's lobe, unless by the mirror's or absorbed.
        if (vertices[i].pdf > 0) {
            ASSERT_EQ(vertices[i].pdf, vertices[i].plain_pdf);
            ASSERT_GT(dot(vertices[i].direction, vertices[i].normal), 0);
            if (i + 1 < photons.size()) {
                ASSERT_EQ(vertices[i].direction, -photons[i + 1].direction);
            }
        }
        const float survived = luminance(photons[i].power) / vertex.power;
        ASSERT_TRUE(survived > 0.0499f && survived < 1.0001f) << survived;
    }
}

TEST(PathLog, RecordsAgreeWithThePhotons) {
    const mock::Scene scene = box();
    constexpr std::uint32_t kPaths = 2000;
    const Traced traced = trace(scene, kPaths, 1, 2);  // a second call follows on the first
    ASSERT_EQ(traced.log.paths.size(), kPaths);
    ASSERT_GT(traced.store.photons().size(), kPaths);
    const DiscreteDistribution lights = light_choice(scene);
    std::uint64_t rays = 0, vertices = 0, next_photon = 0;
    for (std::uint32_t i = 0; i < kPaths; ++i) {
        const PathRecord& path = traced.log.paths[i];
        ASSERT_EQ(path.first_photon, next_photon);
        ASSERT_EQ(path.first_vertex, vertices);
        const auto photons = photons_of(traced, path);
        for (const Photon& photon : photons)
            ASSERT_EQ(photon.path, i);
        expect_vertices_at_photons(vertices_of(traced, path), photons, path.rays);
        rays += path.rays;
        vertices += path.vertices;
        next_photon += path.photons;
        // The start is that of the path: its emission lands where the path first landed.
        ASSERT_EQ(path.pdf, double(lights.pdf(path.light)));
        Emission emission;
        if (photons.empty()) continue;
        ASSERT_TRUE(scene.lights()[path.light]->emit(path.start, emission));
        EXPECT_EQ(photons[0].direction, -emission.ray.direction);
        EXPECT_EQ(photons[0].power, emission.power / float(path.pdf));
    }
    const auto left = std::count_if(traced.log.vertices.begin(), traced.log.vertices.end(),
                                    [](const PathVertex& vertex) { return vertex.pdf > 0; });
    EXPECT_GT(std::size_t(left), traced.log.vertices.size() / 4);
    EXPECT_EQ(rays, traced.counts.rays);
    EXPECT_EQ(vertices, traced.log.vertices.size());
    EXPECT_EQ(next_photon, traced.store.photons().size());
    EXPECT_TRUE(same_bits(traced.log.photons, traced.store.photons()));
}

/// Binomial: at 4 standard errors (p < 1e-4). What is logged is as when all are, and a fair sample.
TEST(PathLog, OneOfSoManyIsLogged) {
    const mock::Scene scene = box();
    constexpr std::uint32_t kPaths = 16384;
    const Traced all = trace(scene, kPaths, 1), some = trace(scene, kPaths, 4);
    const auto logged = double(some.log.paths.size());
    EXPECT_NEAR(logged, kPaths / 4.0, 4 * std::sqrt(kPaths * 0.25 * 0.75));
    std::size_t at = 0;
    PrimaryPoint mean{};
    for (const PathRecord& path : some.log.paths) {
        while (at < kPaths && (all.log.paths[at].start != path.start))
            ++at;
        ASSERT_LT(at, kPaths);
        const PathRecord& same = all.log.paths[at];
        ASSERT_TRUE(same_bits(photons_of(some, path), photons_of(all, same)));
        ASSERT_EQ(path.rays, same.rays);
        const auto vertices = vertices_of(some, path), expected = vertices_of(all, same);
        ASSERT_TRUE(std::equal(vertices.begin(), vertices.end(), expected.begin(), expected.end(),
                               [](const PathVertex& a, const PathVertex& b) {
                                   return a.position == b.position && a.power == b.power;
                               }));
        for (unsigned axis = 0; axis < 4; ++axis)
            mean[axis] += path.start[axis] / float(logged);
    }
    for (const float x : mean)
        EXPECT_NEAR(x, 0.5, 4 * std::sqrt(1 / 12.0 / logged));
}

TEST(PathLog, LoggingChangesNoPhoton) {
    const mock::Scene scene = box();
    const Traced plain = trace(scene, 3000, 0);
    EXPECT_TRUE(plain.log.paths.empty());
    ASSERT_GT(plain.store.photons().size(), 3000u);
    for (const std::uint32_t one_of : {1u, 4u}) {
        const Traced logged = trace(scene, 3000, one_of);
        EXPECT_TRUE(same_bits(plain.store.photons(), logged.store.photons()));
    }
}

TEST(PathLog, DoesNotDependOnThreads) {
    const mock::Scene scene = box();
    const auto traced_with = [&](unsigned threads) {
        return concurrency::run_on(threads, [&] { return trace(scene, 5000, 2); });
    };
    const Traced one = traced_with(1), four = traced_with(4);
    ASSERT_GT(one.log.paths.size(), 2000u);
    expect_same(one.log.paths, four.log.paths);
    EXPECT_EQ(one.log.vertices.size(), four.log.vertices.size());
    EXPECT_TRUE(same_bits(one, four));
}

}  // namespace
}  // namespace aips::path_log_test
