// The numbers that an eye path is drawn with: stratified over the paths of its pixel.
//
// At each vertex a path takes the coordinates of one point of an Owen-scrambled Sobol' sequence,
// whose number counts the paths of the pixel. Each vertex has a scramble of its own and goes
// through the points in an order of its own, so that vertices are independent of one another
// ("padding", Burley 2020, section 5). Which light, where on it, and what happens at glass are then
// stratified over passes, not only within them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "aips/core/base/vector.h"
#include "aips/core/sampling/low_discrepancy.h"

namespace aips {

/// Coordinates in [0, 1) of one scrambled point, uniform over seeds.
class PointNumbers {
  public:
    PointNumbers(std::uint32_t seed, std::uint64_t index)
        : epoch_seed_(sobol_epoch_seed(index, seed)), index_(std::uint32_t(index)) {}

  protected:
    float at(unsigned dimension) const {
        return sobol_owen_in_epoch(index_, dimension, epoch_seed_);
    }

  private:
    std::uint32_t epoch_seed_, index_;
};

/// For one vertex of an eye path.
class VertexNumbers : public PointNumbers {
  public:
    using PointNumbers::PointNumbers;

    Vec2 light() const { return {at(0), at(1)}; }
    float light_choice() const { return at(2); }
    float lobe() const { return at(3); }
    Vec2 direction() const { return {at(4), at(5)}; }
    float end() const { return at(6); }
};

/// For the way to a vertex, where it leads through a medium.
class SegmentNumbers : public PointNumbers {
  public:
    using PointNumbers::PointNumbers;

    float distance() const { return at(0); }
    Vec2 light() const { return {at(1), at(2)}; }
    float light_choice() const { return at(3); }
    float collisions() const { return at(4); }
};

/// Choices at the specular surfaces that a path meets before any other, in [0, 1): the numbers that
/// tell, beside its film position, which emitters such a path meets.
using SpecularChoices = std::array<float, 4>;

/// Numbers of one path.
class EyeNumbers {
  public:
    /// Path number `index` of pixel `pixel`. Sequences of different `sequence` share nothing.
    EyeNumbers(std::uint64_t seed, std::uint64_t sequence, std::uint64_t pixel, std::uint64_t index)
        : seed_(mixed(mixed(mixed(0x6579u, seed), sequence), pixel)), index_(index) {}

    /// `depth`: the vertex's number along the path.
    VertexNumbers vertex(std::uint32_t depth) const { return at<VertexNumbers>(depth); }
    /// Of the way to vertex number `depth`.
    SegmentNumbers segment(std::uint32_t depth) const {
        return at<SegmentNumbers>(kSegments + depth);
    }

    /// Choice number `i`, uniform over seeds as all others.
    float choice(std::size_t i) const {
        return drawn_ ? (*drawn_)[i] : vertex(kChoices + std::uint32_t(i)).lobe();
    }
    /// All of them.
    SpecularChoices choices() const {
        SpecularChoices all;
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = choice(i);
        return all;
    }
    /// The same path with choices that were drawn elsewhere.
    EyeNumbers with(const SpecularChoices& drawn) const {
        EyeNumbers numbers(*this);
        numbers.drawn_ = drawn;
        return numbers;
    }

  private:
    // Beyond all vertices that a path may have.
    static constexpr std::uint32_t kSegments = 1u << 30, kChoices = 1u << 31;

    template <class Numbers>
    Numbers at(std::uint32_t place) const {
        const std::uint32_t seed = hash_bits(seed_ + place * 0x9E3779B9u);
        return {hash_bits(seed), shuffled(index_, seed)};
    }

    /// A permutation of each 2^16 indices that maps aligned blocks of 2^k to such blocks, so that
    /// what is stratified in one order is so in any: the low bits as a nested uniform scramble.
    static constexpr std::uint64_t shuffled(std::uint64_t index, std::uint32_t seed) {
        const std::uint32_t reversed = reverse_bits(std::uint32_t(index)) >> 16;
        const std::uint32_t low = laine_karras_permutation(reversed, seed) << 16;
        return (index & ~std::uint64_t{0xFFFF}) | reverse_bits(low);
    }

    static constexpr std::uint32_t mixed(std::uint32_t seed, std::uint64_t with) {
        return hash_bits(hash_bits(seed ^ std::uint32_t(with)) + std::uint32_t(with >> 32));
    }

    std::uint32_t seed_;
    std::uint64_t index_;
    std::optional<SpecularChoices> drawn_;
};

}  // namespace aips
