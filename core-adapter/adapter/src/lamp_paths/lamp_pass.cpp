// Lamp paths and searches, in blocks that are joined in order.
#include "lamp_paths/lamp_pass.h"

#include <algorithm>
#include <span>

#include "base/parallel_for.h"
#include "eye/eye_path.h"
#include "lamp_paths/lamp_search.h"
#include "ranks/shared_work.h"

namespace aips {
namespace {

constexpr std::uint32_t kLampPathsPerBlock = 32;
/// Numbers of lamp paths at surfaces: a sequence that no other paths have.
constexpr std::uint64_t kLampSequence = ~std::uint64_t{0};

/// Saves a block for another rank, or takes it from one.
void state_of_block(StateArchive& archive, LampSplats& block) {
    state_of(archive, block.positions, block.radiance, block.rays, block.light);
}

void state_of_block(StateArchive& archive, LampFindings& block) {
    state_of(archive, block.images, block.rays);
}

/// Calls `work(block, index, arena)` for each of `count` indices, on this rank or another.
template <class Block, class Work>
std::vector<Block> in_blocks(const EyePassInput& in, std::uint32_t count, Refusals& refusals,
                             const Work& work) {
    std::vector<Block> blocks(count / kLampPathsPerBlock + (count % kLampPathsPerBlock ? 1 : 0));
    const auto trace_block = [&](std::uint32_t b) {
        Arena arena;
        const std::uint32_t first = b * kLampPathsPerBlock;
        const std::uint32_t last = first + std::min(kLampPathsPerBlock, count - first);
        for (std::uint32_t i = first; i < last; ++i) {
            const auto mark = arena.mark();
            work(blocks[b], i, arena);
            arena.rewind(mark);
        }
    };
    share_out(in.ranks, std::uint32_t(blocks.size()), &refusals, trace_block,
              [&](std::uint32_t b, StateArchive& archive) { state_of_block(archive, blocks[b]); });
    return blocks;
}

bool on_film(const EyePassInput& in, Vec2 at) {
    return at.x >= 0 && at.y >= 0 && at.x < float(in.width) && at.y < float(in.height);
}

/// A path that misses the film, or its image by rounding, shows nothing.
void trace(const EyePassInput& in, std::uint64_t pass, float time, std::uint32_t path,
           Refusals& refusals, Arena& arena, LampSplats& splats) {
    const LampDraw draw = in.lamps->draw(in.settings.seed, pass, path);
    if (!on_film(in, draw.film)) return;
    const double share = in.lamps->eye_share(draw.film, draw.choices);
    if (!(share < 1)) return;
    RandomStream random(in.settings.seed, pass, path, RandomDomain::Lamp);
    const CameraRay ray = in.camera.generate({draw.film, random.next2()}, time);
    const EyeNumbers numbers(in.settings.seed, kLampSequence, path, pass);
    const std::size_t groups = in.scene.light_groups(), first = splats.radiance.size();
    splats.radiance.resize(first + groups);
    const std::span<Rgb> lamps = std::span(splats.radiance).subspan(first);
    LuminanceByLight light;
    splats.rays += trace_lamp_path(in, ray, numbers.with(draw.choices), random, refusals, arena,
                                   lamps, in.settings.account ? &light : nullptr);
    if (!(luminance_over_groups(lamps, 0, std::uint32_t(groups)) > 0)) {
        splats.radiance.resize(first);
        return;
    }
    const double eye_paths_per_pixel = in.paths / (double(in.width) * in.height);
    for (Rgb& radiance : lamps)
        radiance *= float(share / eye_paths_per_pixel);
    splats.light.add(light, share / eye_paths_per_pixel);
    splats.positions.push_back(draw.film);
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

void trace_lamp_paths(const EyePassInput& in, std::uint64_t pass, float time, Refusals& refusals,
                      LampSplats& splats) {
    splats.positions.clear();
    splats.radiance.clear();
    splats.rays = 0;
    splats.light.clear();
    splats.paths = in.lamps->paths();
    const auto blocks = in_blocks<LampSplats>(
        in, in.lamps->paths(), refusals, [&](LampSplats& block, std::uint32_t i, Arena& arena) {
            trace(in, pass, time, i, refusals, arena, block);
        });
    for (const LampSplats& block : blocks) {
        append(splats.positions, block.positions);
        append(splats.radiance, block.radiance);
        splats.rays += block.rays;
        splats.light.add(block.light);
    }
}

LampFindings search_lamps(const EyePassInput& in, std::uint64_t round, std::uint32_t count,
                          float time, Refusals& refusals) {
    const auto blocks = in_blocks<LampFindings>(
        in, count, refusals, [&](LampFindings& block, std::uint32_t i, Arena& arena) {
            block.rays += search_lamps(in, {round, i, time}, refusals, arena, block.images);
        });
    LampFindings all;
    for (const LampFindings& block : blocks) {
        append(all.images, block.images);
        all.rays += block.rays;
    }
    return all;
}

}  // namespace aips
