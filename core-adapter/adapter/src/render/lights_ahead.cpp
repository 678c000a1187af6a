// Eye paths that are thrown away, in blocks that are joined in order.
#include "render/lights_ahead.h"

#include "eye/eye_path.h"
#include "ranks/shared_work.h"

namespace aips {
namespace {

constexpr std::uint32_t kPathsPerBlock = 1024;
constexpr std::uint64_t kAheadSequence = ~std::uint64_t{2};

struct Block {
    std::vector<LightSample> told;
    std::uint64_t rays = 0;
};

/// Of paths that are thrown away.
struct Scratch {
    InvalidSampleFilter& filter;
    Arena arena;
    std::vector<Rgb> radiance;
};

/// Path number `path` of `paths`, which are spread over the film.
void trace(const EyePassInput& in, float time, std::uint32_t path, std::uint32_t paths,
           Scratch& scratch, Block& block) {
    const std::uint64_t pixel = std::uint64_t{in.width} * in.height * path / paths;
    const std::uint64_t column = pixel % in.width, row = pixel / in.width;
    RandomStream random(in.settings.seed, 0, path, RandomDomain::LightsAhead);
    const Vec2 place = random.next2();
    const Vec2 film{float(column) + place.x, float(row) + place.y};
    const EyeNumbers numbers(in.settings.seed, kAheadSequence, path, 0);
    EyePathOutput output;
    output.radiance.groups = scratch.radiance;
    const EyePathResult result =
        trace_eye_path(in, in.camera.generate({film, random.next2()}, time), numbers, random,
                       scratch.filter, scratch.arena, output);
    block.rays += result.rays;
    if (result.light_sample.pdf > 0) block.told.push_back(result.light_sample);
}

}  // namespace

std::uint64_t learn_lights_ahead(const EyePassInput& pass, float time, DirectLight& lights) {
    if (!lights.learned() || lights.knows()) return 0;
    const EyePassInput input{.scene = pass.scene,
                             .camera = pass.camera,
                             .sampler = pass.sampler,
                             .direct_light = pass.direct_light,
                             .settings = pass.settings,
                             .width = pass.width,
                             .height = pass.height,
                             .keep_visible_points = false};
    // As many as a pass has, if lights are then chosen anew.
    const std::uint32_t paths = light_samples_ahead(pass.paths);
    std::vector<Block> blocks((paths - 1) / kPathsPerBlock + 1);
    InvalidSampleFilter of_nothing_seen(pass.scene);
    share_out(
        pass.ranks, std::uint32_t(blocks.size()), nullptr,
        [&](std::uint32_t b) {
            Scratch scratch{of_nothing_seen, Arena(), std::vector<Rgb>(pass.scene.light_groups())};
            const std::uint32_t last = std::min(paths, (b + 1) * kPathsPerBlock);
            for (std::uint32_t path = b * kPathsPerBlock; path < last; ++path)
                trace(input, time, path, paths, scratch, blocks[b]);
        },
        [&](std::uint32_t b, StateArchive& archive) {
            state_of(archive, blocks[b].told, blocks[b].rays);
        });
    std::vector<LightSample> told;
    std::uint64_t rays = 0;
    for (const Block& block : blocks) {
        told.insert(told.end(), block.told.begin(), block.told.end());
        rays += block.rays;
    }
    lights.learn(told, paths, 0);
    return rays;
}

}  // namespace aips
