// Where light goes that a path has found: to its light group, and to its part of the image.
#pragma once

#include <cstdint>
#include <span>

#include "aips/core/base/image_part.h"
#include "aips/core/base/rgb.h"
#include "sample_filter/invalid_sample_filter.h"

namespace aips {

/// Sums of one part of the image.
struct LightTarget {
    std::span<Rgb> groups;  ///< [light group]
    Rgb* part = nullptr;    ///< of all groups together; null: not wanted

    /// False, and counted, if the value is refused.
    bool add(std::uint32_t group, const Rgb& value, Origin origin,
             InvalidSampleFilter& filter) const {
        if (!filter.add(groups[group], value, origin)) return false;
        if (part) *part += value;
        return true;
    }
};

/// Sums of an eye path.
struct LightSums {
    std::span<Rgb> groups;  ///< [light group]
    std::span<Rgb> parts;   ///< [ImagePart]; empty: not wanted

    LightTarget of(ImagePart part) const {
        return {groups, parts.empty() ? nullptr : &parts[static_cast<std::size_t>(part)]};
    }
};

}  // namespace aips
