// Learning where visible paths start, and drawing from it.
#include "guides/adaptive/chain_starts.h"

#include <array>

#include "eye/light_choice.h"

namespace aips {
namespace {

EmissionGuideSettings guide_settings() {
    EmissionGuideSettings settings;
    settings.plain_share = kPlainChainStarts;
    return settings;
}

/// The first 32 bits of u in [0, 1). No leaf has a side below 2^-31: the point stays in its own.
Coordinate coordinate_of(double u) {
    return static_cast<Coordinate>(u * 0x1p32);
}

/// Uniform among those that choose the light, whose probabilities are multiples of 2^-24.
Coordinate coordinate_of(const DiscreteDistribution& choice, LightIndex light, std::uint32_t bits) {
    const auto first = static_cast<std::uint64_t>(double(choice.before(light)) * 0x1p32);
    const auto count = static_cast<std::uint64_t>(double(choice.pdf(light)) * 0x1p32);
    return static_cast<Coordinate>(first + (count * bits >> 32));
}

}  // namespace

ChainStarts::ChainStarts(const Scene& scene, const Settings& settings,
                         const DiscreteDistribution& light_choice)
    : scene_(scene),
      settings_(settings),
      light_choice_(light_choice),
      guide_(scene.lights().size(), light_choice, guide_settings()) {}

std::uint64_t ChainStarts::begin_pass(std::uint64_t pass, float time, const EyeImage& image) {
    return seeds_.search(scene_, settings_, light_choice_, pass, time, image, paths_, guide_);
}

EmissionStart ChainStarts::draw(RandomStream& random, std::vector<Coordinate>& coordinates) const {
    std::array<std::uint32_t, kStartCoordinates> bits;
    for (std::uint32_t& b : bits)
        b = random.next_uint();
    const EmissionStart start = guide_.sample(random.next(), primary_point(bits));
    coordinates.clear();
    for (const double u : start.point)
        coordinates.push_back(coordinate_of(u));
    coordinates.push_back(coordinate_of(light_choice_, start.light, random.next_uint()));
    return start;
}

EmissionStart ChainStarts::at(std::span<const Coordinate> coordinates) const {
    EmissionStart start;
    start.point = primary_point({coordinates[0], coordinates[1], coordinates[2], coordinates[3]});
    // Where there is one light no coordinate chooses it.
    if (scene_.lights().size() > 1) {
        const float u = to_unit_float(coordinates[kStartCoordinates]);
        start.light = static_cast<LightIndex>(light_choice_.sample(u).index);
    }
    return start;
}

std::uint32_t ChainStarts::learn_one_of() const {
    return paths_ < kEagerPaths ? 1 : kLateOneOf;
}

void ChainStarts::add(const EmissionStart& start, bool visible, double cost) {
    ++added_;
    const double w = weight(start);
    guide_.add({start, visible ? w * w : 0, cost});
}

void ChainStarts::add_visible(const EmissionStart& start, double share, double cost) {
    guide_.add_part(start, share * double(added_), cost);
}

void ChainStarts::end_pass() {
    guide_.update(double(added_));
    paths_ += added_;
    added_ = 0;
}

void ChainStarts::state(StateArchive& archive) {
    guide_.state(archive);
    seeds_.state(archive);
    archive.value(paths_);
}

void ChainStarts::begin_anew() {
    guide_.begin_anew(kRememberedPaths);
    seeds_ = {};
    paths_ = 0;
}

std::size_t ChainStarts::memory_bound_bytes(const Scene& scene, std::size_t eye_paths) {
    return EmissionGuide::memory_bound_bytes(light_choice(scene), guide_settings()) +
           SeedSearch::memory_bound_bytes(eye_paths);
}

}  // namespace aips
