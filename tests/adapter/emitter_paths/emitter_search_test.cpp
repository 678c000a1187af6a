// Protects the search for images of lamps: what it finds is where eye paths meet the lamp, as large
// as the lamp's image is, in a mirror and through glass.
#include "emitter_paths/emitter_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "aips/core/sampling/sampling.h"
#include "emitter_paths/specular_chain.h"
#include "eye/eye_path.h"
#include "lamp_room.h"

namespace aips::emitter_search_test {
namespace {

constexpr std::uint32_t kSize = 16;

/// A pass over the room, and what it is traced with.
struct Room {
    mock::View view = mock::lamp_room(kSize);
    mock::Sampler sampler{3};
    DirectLight direct{view.scene, false};
    Settings settings = mock::small_settings(3, 100);
    EmitterImages known{kSize, kSize, 1};
    InvalidSampleFilter filter{view.scene};
    Arena arena;
    EyePassInput input{view.scene, view.camera,  sampler, direct,  settings, kSize,
                       kSize,      kSize* kSize, true,    nullptr, &known};

    std::vector<EmitterImage> search(std::uint32_t times) {
        std::vector<EmitterImage> images;
        for (std::uint32_t i = 0; i < times; ++i)
            search_emitters(input, {0, i, 0}, filter, arena, images);
        return images;
    }
    /// Luminance of lamps that a path meets there.
    double lamps_at(Vec2 film, const EyeNumbers& numbers) {
        RandomStream random(5, 0, 0, RandomDomain::Emitter);
        std::vector<Rgb> lamps(1);
        trace_emitter_path(input, view.camera.generate({film, {0.5f, 0.5f}}, 0), numbers, random,
                           filter, arena, lamps);
        return double(luminance(lamps[0]));
    }
};

TEST(EmitterSearch, FindsWhatEyePathsMeet) {
    Room room;
    const auto images = room.search(4000);
    EXPECT_GT(images.size(), 20u);
    for (const EmitterImage& image : images) {
        EXPECT_GT(image.luminance, 0);
        EXPECT_LT(image.area(), 0.5);
    }
    room.known.add(images);
    room.known.begin_pass(1);
    EXPECT_GE(room.known.all().size(), 2u) << "one in the mirror, one in the glass";
    EXPECT_LT(room.known.all().size(), images.size() / 2) << "most were found again and again";
}

TEST(EmitterSearch, ImagesAreAsLargeAsTheyAreSeen) {
    Room room;
    auto images = room.search(4000);
    ASSERT_FALSE(images.empty());
    room.known.add(images);
    room.known.begin_pass(1);
    const auto largest = std::ranges::max_element(images, {}, &EmitterImage::area);
    // By chance, in a square that is far wider.
    const double half = 4 * std::sqrt(largest->area());
    constexpr int kPaths = 200000;
    RandomStream random(11, 0, 0, RandomDomain::Guide);
    int met = 0, within = 0;
    for (int i = 0; i < kPaths; ++i) {
        const Vec2 at{largest->centre.x + float(half) * (2 * random.next() - 1),
                      largest->centre.y + float(half) * (2 * random.next() - 1)};
        const EyeNumbers numbers(5, 0, std::uint64_t(i), 0);
        if (!(room.lamps_at(at, numbers) > 0)) continue;
        ++met;
        within += room.known.eye_share(at, numbers.choices()) < 1;
    }
    ASSERT_GT(met, 200);
    EXPECT_GT(within, 0.95 * met) << "images hold the lamp";
    const double seen_area = 4 * half * half * met / kPaths;
    EXPECT_GT(seen_area, 0.3 * largest->area()) << "and not much else";
}

TEST(ChainTracer, RecallsAsItFollows) {
    Room room;
    ChainTracer tracer(room.input, 0, room.filter, room.arena);
    RandomStream random(7, 0, 0, RandomDomain::Guide);
    int chains = 0;
    for (int i = 0; i < 2000 && chains < 50; ++i) {
        const Vec2 at{kSize * random.next(), kSize * random.next()};
        ChainVertices vertices, again;
        SpecularChain chain = tracer.explore(at, random, vertices);
        if (chain.length == 0) continue;
        ++chains;
        SpecularChain recalled = chain;
        for (SpecularChain::Link& link : recalled.links)
            link.first *= 0.5f;
        const auto before = tracer.rays();
        ASSERT_EQ(tracer.follow(chain, chain.length, at, again), chain.length);
        const auto followed = tracer.rays() - before;
        tracer.recall(recalled, chain.length, vertices);
        EXPECT_EQ(tracer.rays() - before, 2 * followed);
        for (unsigned k = 0; k < chain.length; ++k) {
            EXPECT_EQ(recalled.links[k].first, chain.links[k].first);
            EXPECT_EQ(again[k].point.position, vertices[k].point.position);
            EXPECT_EQ(again[k].direction, vertices[k].direction);
        }
    }
    EXPECT_EQ(chains, 50);
}

}  // namespace
}  // namespace aips::emitter_search_test
