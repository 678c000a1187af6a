// The eye pass, in blocks of eye paths that are joined in order.
#include "eye/eye_pass.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "aips/core/base/cache_line.h"
#include "aips/core/sampling/low_discrepancy.h"
#include "base/assign_all.h"
#include "base/parallel_for.h"
#include "eye/eye_path.h"
#include "eye/footprints.h"
#include "ranks/foreign_bsdf.h"

namespace aips {
namespace {

/// Of the visible points of so many eye paths one tells what the photons of each light bring it.
constexpr std::uint32_t kTellingOneOf = 32;

constexpr std::uint32_t kEyePathsPerBlock = 1024;

/// What one block adds to the pass besides the per-path arrays.
struct alignas(kCacheLine) EyeBlock {
    std::vector<VisiblePoint> visible_points;
    std::vector<VolumeBeam> beams;
    std::vector<float> footprints;
    std::vector<LightSample> light_samples;
    std::vector<EmitterRest> emitter_rests;
    std::vector<Rgb> emitters;  // [light group]: of one eye path
    double beam_footprint_sum = 0;
    std::uint64_t rays = 0;
    LuminanceByLight light;
    LuminanceByLight emitter_light;  // behind specular surfaces: of one eye path
    std::uint64_t telling_paths = 0, cut_paths = 0;
    bool has_bsdf = false;  // one of the visible points
};

/// Whether an eye path's visible point tells lights apart. Chosen by a hash: no pattern of pixels
/// is favoured.
bool tells_lights(const Settings& settings, std::uint64_t serial) {
    if (!settings.transport_statistics) return false;
    const auto key = std::uint32_t(serial) ^ hash_bits(std::uint32_t(serial >> 32) + 1);
    return hash_bits(key ^ 0x5BD1E995u) % kTellingOneOf == 0;
}

EyePathOutput output_of(const EyePassInput& in, std::uint64_t pass, std::uint32_t path,
                        EyeImage& image, EyeBlock& block) {
    const std::size_t first = std::size_t(path) * image.groups;
    EyePathOutput output;
    output.film = image.positions[path];
    output.radiance.groups = std::span(image.radiance).subspan(first, image.groups);
    if (in.layers.parts)
        output.radiance.parts =
            std::span(image.parts).subspan(std::size_t(path) * kImageParts, kImageParts);
    if (in.emitters) {
        block.emitters.assign(image.groups, Rgb{});
        output.emitters = block.emitters;
    }
    if (in.shares) {
        output.continued = std::span(image.continued).subspan(first, image.groups);
        output.explores = in.shares->explores(pass, path);
        output.learns_gloss = in.shares->gloss && in.shares->learns_from(pass, path);
    }
    if (in.layers.surfaces) output.surface = &image.surfaces[path];
    return output;
}

/// Adds what the path met of emitters behind specular surfaces, by its share beside emitter paths.
void add_emitters(const EmitterImages& known, const EyeNumbers& numbers, std::uint32_t path,
                  const EyePathOutput& output, InvalidSampleFilter& filter, EyeImage& image,
                  EyeBlock& block) {
    const float luminance = luminance_over_groups(output.emitters, 0, image.groups);
    if (!(luminance > 0)) return;
    const auto share = float(known.eye_share(image.positions[path], numbers.choices()));
    for (std::size_t g = 0; g < image.groups; ++g)
        output.radiance.of(ImagePart::Direct)
            .add(std::uint32_t(g), output.emitters[g] * share, kPassageOrigin, filter);
    if (output.emitter_light) block.light.add(*output.emitter_light, double(share));
    if (share < 1) block.emitter_rests.push_back({path, (1 - share) * luminance});
}

void trace_block(const EyePassInput& in, std::uint64_t pass, float time, std::uint32_t first,
                 std::uint32_t last, InvalidSampleFilter& filter, EyeImage& image, Arena& arena,
                 EyeBlock& block) {
    const std::uint64_t pixels = std::uint64_t(in.width) * in.height;
    const std::uint64_t before =
        std::max(in.direct_light.passes_before(), in.shares ? in.shares->passes_before : 0);
    const std::uint32_t stride = paths_per_light_sample(in.paths);
    for (std::uint32_t i = first; i < last; ++i) {
        // Consecutive eye paths walk over the film again and again, whatever their number per pass.
        const std::uint64_t serial = pass * in.paths + i;
        const std::uint64_t pixel = serial % pixels;
        const CameraSample sample = in.sampler.camera_sample(
            serial / pixels, std::uint32_t(pixel % in.width), std::uint32_t(pixel / in.width));
        const EyeNumbers numbers(in.settings.seed, before, pixel,
                                 (serial - before * in.paths) / pixels);
        RandomStream random(in.settings.seed, pass, i, RandomDomain::Eye);
        image.positions[i] = sample.film;
        EyePathOutput output = output_of(in, pass, i, image, block);
        const bool tells = tells_lights(in.settings, serial);
        if (in.settings.transport_statistics) {
            output.light = &block.light;
            block.emitter_light.clear();
            output.emitter_light = in.emitters ? &block.emitter_light : &block.light;
        }
        block.telling_paths += tells;
        const EyePathResult result = trace_eye_path(in, in.camera.generate(sample, time), numbers,
                                                    random, filter, arena, output);
        if (in.emitters) add_emitters(*in.emitters, numbers, i, output, filter, image, block);
        block.rays += result.rays;
        block.cut_paths += result.cut;
        if (result.light_sample.pdf > 0 && (i + pass) % stride == 0)
            block.light_samples.push_back(result.light_sample);
        if (result.has_beam) {
            block.beams.push_back(result.beam);
            block.beams.back().sample = i;
            block.beam_footprint_sum += result.beam_footprint;
        }
        for (const PathPoint* at : {&result.before, &result.end}) {
            if (!at->usable) continue;
            block.visible_points.push_back(at->point);
            block.visible_points.back().sample = i;
            block.visible_points.back().tells_lights = tells;
            block.has_bsdf |= at->point.bsdf != nullptr;
            block.footprints.push_back(at->footprint);
        }
    }
}

/// Saves what a block left, from eye path `first` to below `last`, for another rank, or takes it
/// from one.
void state_of_block(StateArchive& archive, std::uint32_t first, std::uint32_t last, EyeImage& image,
                    EyeBlock& block) {
    const auto paths = [&]<class T>(std::vector<T>& values, std::size_t per_path) {
        if (values.empty()) return;
        plain(archive, std::span<T>(values).subspan(first * per_path, (last - first) * per_path));
    };
    paths(image.positions, 1);
    paths(image.radiance, image.groups);
    paths(image.parts, kImageParts);
    paths(image.continued, image.groups);
    paths(image.surfaces, 1);
    state_of(archive, block.visible_points, block.footprints, block.light_samples,
             block.emitter_rests, block.rays, block.telling_paths, block.cut_paths, block.light);
    archive.value(block.has_bsdf);
    if (!archive.restoring() || !block.has_bsdf) return;
    for (VisiblePoint& point : block.visible_points) {
        if (point.bsdf) point.bsdf = foreign_bsdf();
    }
}

/// Whose points are which, before blocks are joined.
void set_owners(Ranks* ranks, const SharedWork& work, const std::vector<EyeBlock>& blocks,
                PointOwners& owners) {
    owners = {};
    if (!ranks) return;
    owners.ranks = ranks;
    owners.begins.push_back(0);
    for (std::uint32_t rank = 0; rank < ranks->count(); ++rank) {
        std::size_t end = owners.begins.back();
        for (std::uint32_t b = work.first_of(rank); b < work.first_of(rank + 1); ++b)
            end += blocks[b].visible_points.size();
        owners.begins.push_back(end);
    }
    owners.any_bsdf =
        std::ranges::any_of(blocks, [](const EyeBlock& block) { return block.has_bsdf; });
}

/// Joins what the blocks hold in their order, and empties them. The memory of `joined` is kept:
/// most of it is overwritten where it lies. `most`: that a pass may hold.
template <class T>
void join(std::vector<EyeBlock>& blocks, std::vector<T> EyeBlock::*part, std::size_t most,
          std::vector<T>& joined) {
    std::vector<std::size_t> first(blocks.size() + 1, 0);
    for (std::size_t b = 0; b < blocks.size(); ++b)
        first[b + 1] = first[b] + (blocks[b].*part).size();
    reserve_with_room(joined, first.back(), most);
    joined.resize(first.back());
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
        std::vector<T> block = std::move(blocks[b].*part);
        std::ranges::move(block, joined.begin() + static_cast<std::ptrdiff_t>(first[b]));
    });
}

void join_blocks(std::vector<EyeBlock>& blocks, std::size_t most_points, EyeImage& image) {
    const std::size_t paths = image.positions.size();
    join(blocks, &EyeBlock::visible_points, most_points, image.visible_points);
    join(blocks, &EyeBlock::beams, paths, image.beams);
    join(blocks, &EyeBlock::footprints, most_points, image.footprints);
    join(blocks, &EyeBlock::light_samples, paths, image.light_samples);
    join(blocks, &EyeBlock::emitter_rests, paths, image.emitter_rests);
    image.beam_footprint_sum = 0;
    image.rays = image.telling_paths = image.cut_paths = 0;
    image.light.clear();
    for (const EyeBlock& block : blocks) {
        image.beam_footprint_sum += block.beam_footprint_sum;
        image.rays += block.rays;
        image.light.add(block.light);
        image.telling_paths += block.telling_paths;
        image.cut_paths += block.cut_paths;
    }
    image.footprint_sum = bounded_footprint_sum(image.footprints);
}

}  // namespace

std::size_t EyeImage::memory_bytes() const {
    std::size_t bytes =
        positions.capacity() * sizeof(Vec2) +
        (radiance.capacity() + parts.capacity() + continued.capacity()) * sizeof(Rgb) +
        visible_points.capacity() * sizeof(VisiblePoint) + footprints.capacity() * sizeof(float) +
        surfaces.capacity() * sizeof(SeenSurface) + light_samples.capacity() * sizeof(LightSample) +
        beams.capacity() * sizeof(VolumeBeam) + emitter_rests.capacity() * sizeof(EmitterRest);
    for (const Arena& arena : arenas)
        bytes += arena.bytes_reserved();
    return bytes;
}

void positions_of(std::span<const VisiblePoint> points, std::vector<Vec3>& positions) {
    positions.resize(points.size());
    for_all(points.size(), [&](std::size_t i) { positions[i] = points[i].position; });
}

std::vector<Vec3> positions_of_most_photons(std::span<const VisiblePoint> points,
                                            Settings& settings) {
    std::vector<Vec3> positions;
    for (const VisiblePoint& point : points) {
        if (!point.takes_gloss_alone()) positions.push_back(point.position);
    }
    if (positions.empty()) {
        positions_of(points, positions);
    } else {
        settings.caustics_on_gloss = false;
    }
    return positions;
}

void trace_eye_pass(const EyePassInput& in, std::uint64_t pass, float time,
                    InvalidSampleFilter& filter, EyeImage& image) {
    const std::uint32_t block_count =
        in.paths / kEyePathsPerBlock + (in.paths % kEyePathsPerBlock ? 1 : 0);
    image.groups = in.scene.light_groups();
    image.positions.resize(in.paths);
    assign_all(image.radiance, std::size_t(in.paths) * image.groups, Rgb{});
    assign_all(image.parts, in.layers.parts ? std::size_t(in.paths) * kImageParts : 0, Rgb{});
    assign_all(image.continued, in.shares ? image.radiance.size() : 0, Rgb{});
    assign_all(image.surfaces, in.layers.surfaces ? in.paths : 0, SeenSurface{});
    image.arenas.resize(block_count);
    if (in.keep_visible_points) image.visible_points.reserve(in.paths);
    std::vector<EyeBlock> blocks(block_count);
    const auto last_of = [&](std::uint32_t first) {
        return first + std::min(kEyePathsPerBlock, in.paths - first);
    };
    SharedWork work(in.ranks, block_count, &filter);
    tbb::parallel_for(work.first(), work.last(), [&](std::uint32_t b) {
        image.arenas[b].reset();
        const std::uint32_t first = b * kEyePathsPerBlock;
        trace_block(in, pass, time, first, last_of(first), filter, image, image.arenas[b],
                    blocks[b]);
    });
    work.exchange([&](std::uint32_t b, StateArchive& archive) {
        const std::uint32_t first = b * kEyePathsPerBlock;
        state_of_block(archive, first, last_of(first), image, blocks[b]);
    });
    set_owners(in.ranks, work, blocks, image.owners);
    join_blocks(blocks, most_visible_points(in.settings, in.paths), image);
}

}  // namespace aips
