// Which media a ray is in: those that it has entered and not left.
//
// Reference: Schmidt & Budge 2002, "Simple nested dielectrics in ray traced images" (the interior
// list; here the medium entered last fills the space, and no priorities are given).
#pragma once

#include <cstdint>

namespace lxs {

/// A medium of a scene, by number from 1.
using MediumNumber = std::uint16_t;
/// No medium: vacuum, or a side of a surface for which none is declared.
inline constexpr MediumNumber kNoMedium = 0;

/// The media that a ray has entered and not left, in order. It travels in the last of them. A ray
/// that has entered none may travel in one that is assumed: open surfaces let rays come where a
/// medium is declared without crossing what bounds it, and each such segment is in what the surface
/// at its end declares, or else the one at its start. A value of 64 bits, so that hosts of other
/// interfaces can hand it through as a mark.
class EnteredMedia {
  public:
    static constexpr MediumNumber kLargestNumber = (1 << 12) - 1;
    static constexpr int kMost = 5;  ///< of more, those entered first are forgotten

    constexpr EnteredMedia() = default;
    static constexpr EnteredMedia from_bits(std::uint64_t bits) {
        EnteredMedia media;
        media.bits_ = bits;
        return media;
    }
    constexpr std::uint64_t bits() const { return bits_; }
    static constexpr EnteredMedia assumed(MediumNumber medium) {
        return from_bits(kAssumed | medium);
    }
    constexpr bool is_assumed() const { return (bits_ & kAssumed) != 0; }
    /// Without what is assumed.
    constexpr EnteredMedia known() const { return is_assumed() ? EnteredMedia() : *this; }

    /// What the ray travels in; kNoMedium for none.
    constexpr MediumNumber innermost() const {
        return static_cast<MediumNumber>(bits_ & kLargestNumber);
    }
    constexpr bool contains(MediumNumber medium) const { return place_of(medium) < kMost; }
    constexpr EnteredMedia entered(MediumNumber medium) const {
        return from_bits((bits_ << kBits | medium) & kUsed);
    }
    /// Without the medium, or, if it was entered several times, without its last entry.
    constexpr EnteredMedia left(MediumNumber medium) const {
        const int place = place_of(medium);
        if (place == kMost) return *this;
        const std::uint64_t within = bits_ & ((std::uint64_t{1} << place * kBits) - 1);
        return from_bits((bits_ >> (place + 1) * kBits << place * kBits) | within);
    }
    /// What the ray travels in on its way to a surface that declares the medium `near` on the side
    /// that it comes to.
    constexpr EnteredMedia up_to(MediumNumber near) const {
        return near != kNoMedium && known() == EnteredMedia() ? assumed(near) : *this;
    }
    /// Back from that side.
    constexpr EnteredMedia back_from(MediumNumber near) const { return known().up_to(near); }
    /// Beyond a surface that declares the medium `near` on the side that the ray comes from and
    /// `far` on the other. A surface that declares none, or the same on both sides, separates
    /// nothing. A side for which none is declared is in what the ray was in before.
    constexpr EnteredMedia beyond(MediumNumber near, MediumNumber far) const {
        const EnteredMedia before = known();
        if (near == far && (near == kNoMedium || before.contains(near))) return before;
        const EnteredMedia outside = near == kNoMedium ? before : before.left(near);
        return far == kNoMedium ? outside : outside.entered(far);
    }

    friend constexpr bool operator==(const EnteredMedia&, const EnteredMedia&) = default;

  private:
    static constexpr int kBits = 12;
    static constexpr std::uint64_t kUsed = (std::uint64_t{1} << kMost * kBits) - 1;
    static constexpr std::uint64_t kAssumed = kUsed + 1;

    constexpr int place_of(MediumNumber medium) const {
        for (int place = 0; place < kMost; ++place) {
            if ((bits_ >> place * kBits & kLargestNumber) == medium) return place;
        }
        return kMost;
    }

    std::uint64_t bits_ = 0;
};

}  // namespace lxs
