// The published format of masks of objects and materials: Friedman & Jones 2015, "Fully automatic
// ID mattes with support for motion blur and transparency"; the Cryptomatte specification, 1.2.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lxs/imaging/imaging.h"

namespace lxs {

/// MurmurHash3_x86_32 (Appleby) with seed 0.
std::uint32_t murmur_hash_3(std::string_view text);

/// The id of a name: its hash, with one bit turned over where the float of these bits would be
/// denormal, infinite or NaN ("uint32_to_float32").
std::uint32_t cryptomatte_id(std::string_view name);

/// Adds what the header of a file says of the layer `layer` ("CryptoObject"): the ids of `names`,
/// and how they are made.
void add_cryptomatte_header(const std::string& layer, std::span<const std::string> names,
                            ImageMetadata& metadata);

}  // namespace lxs
