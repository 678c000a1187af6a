// Emitter paths and searches, in blocks that are joined in order.
#include "emitter_paths/emitter_pass.h"

#include <algorithm>
#include <span>

#include "base/parallel_for.h"
#include "emitter_paths/emitter_search.h"
#include "eye/eye_path.h"
#include "ranks/shared_work.h"

namespace aips {
namespace {

constexpr std::uint32_t kEmitterPathsPerBlock = 32;
/// Numbers of emitter paths at surfaces: a sequence that no other paths have.
constexpr std::uint64_t kEmitterSequence = ~std::uint64_t{0};

/// Saves a block for another rank, or takes it from one.
void state_of_block(StateArchive& archive, EmitterSplats& block) {
    state_of(archive, block.positions, block.radiance, block.rays, block.light);
}

void state_of_block(StateArchive& archive, EmitterFindings& block) {
    state_of(archive, block.images, block.rays);
}

/// Calls `work(block, index, arena)` for each of `count` indices, on this rank or another.
template <class Block, class Work>
std::vector<Block> in_blocks(const EyePassInput& in, std::uint32_t count,
                             InvalidSampleFilter& filter, const Work& work) {
    std::vector<Block> blocks(count / kEmitterPathsPerBlock +
                              (count % kEmitterPathsPerBlock ? 1 : 0));
    const auto trace_block = [&](std::uint32_t b) {
        Arena arena;
        const std::uint32_t first = b * kEmitterPathsPerBlock;
        const std::uint32_t last = first + std::min(kEmitterPathsPerBlock, count - first);
        for (std::uint32_t i = first; i < last; ++i) {
            const auto mark = arena.mark();
            work(blocks[b], i, arena);
            arena.rewind(mark);
        }
    };
    share_out(in.ranks, std::uint32_t(blocks.size()), &filter, trace_block,
              [&](std::uint32_t b, StateArchive& archive) { state_of_block(archive, blocks[b]); });
    return blocks;
}

bool on_film(const EyePassInput& in, Vec2 at) {
    return at.x >= 0 && at.y >= 0 && at.x < float(in.width) && at.y < float(in.height);
}

/// A path that misses the film, or its image by rounding, shows nothing.
void trace(const EyePassInput& in, std::uint64_t pass, float time, std::uint32_t path,
           InvalidSampleFilter& filter, Arena& arena, EmitterSplats& splats) {
    const EmitterDraw draw = in.emitters->draw(in.settings.seed, pass, path);
    if (!on_film(in, draw.film)) return;
    const double share = in.emitters->eye_share(draw.film, draw.choices);
    if (!(share < 1)) return;
    RandomStream random(in.settings.seed, pass, path, RandomDomain::Emitter);
    const CameraRay ray = in.camera.generate({draw.film, random.next2()}, time);
    const EyeNumbers numbers(in.settings.seed, kEmitterSequence, path, pass);
    const std::size_t groups = in.scene.light_groups(), first = splats.radiance.size();
    splats.radiance.resize(first + groups);
    const std::span<Rgb> emitters = std::span(splats.radiance).subspan(first);
    LuminanceByLight light;
    splats.rays +=
        trace_emitter_path(in, ray, numbers.with(draw.choices), random, filter, arena, emitters,
                           in.settings.transport_statistics ? &light : nullptr);
    if (!(luminance_over_groups(emitters, 0, std::uint32_t(groups)) > 0)) {
        splats.radiance.resize(first);
        return;
    }
    const double eye_paths_per_pixel = in.paths / (double(in.width) * in.height);
    for (Rgb& radiance : emitters)
        radiance *= float(share / eye_paths_per_pixel);
    splats.light.add(light, share / eye_paths_per_pixel);
    splats.positions.push_back(draw.film);
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

void trace_emitter_paths(const EyePassInput& in, std::uint64_t pass, float time,
                         InvalidSampleFilter& filter, EmitterSplats& splats) {
    splats.positions.clear();
    splats.radiance.clear();
    splats.rays = 0;
    splats.light.clear();
    splats.paths = in.emitters->paths();
    const auto blocks = in_blocks<EmitterSplats>(
        in, in.emitters->paths(), filter, [&](EmitterSplats& block, std::uint32_t i, Arena& arena) {
            trace(in, pass, time, i, filter, arena, block);
        });
    for (const EmitterSplats& block : blocks) {
        append(splats.positions, block.positions);
        append(splats.radiance, block.radiance);
        splats.rays += block.rays;
        splats.light.add(block.light);
    }
}

EmitterFindings search_emitters(const EyePassInput& in, std::uint64_t round, std::uint32_t count,
                                float time, InvalidSampleFilter& filter) {
    const auto blocks = in_blocks<EmitterFindings>(
        in, count, filter, [&](EmitterFindings& block, std::uint32_t i, Arena& arena) {
            block.rays += search_emitters(in, {round, i, time}, filter, arena, block.images);
        });
    EmitterFindings all;
    for (const EmitterFindings& block : blocks) {
        append(all.images, block.images);
        all.rays += block.rays;
    }
    return all;
}

}  // namespace aips
