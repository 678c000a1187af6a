// The published format of masks of objects and materials.
#include "cryptomatte.h"

#include <fmt/format.h>

#include <bit>
#include <set>

namespace lxs {
namespace {

std::uint32_t byte_at(std::string_view text, std::size_t i) {
    return static_cast<unsigned char>(text[i]);
}

std::uint32_t scrambled(std::uint32_t block) {
    return std::rotl(block * 0xcc9e2d51u, 15) * 0x1b873593u;
}

/// A text within a JSON string.
std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            out += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
        } else {
            out += c;
        }
    }
    return out;
}

std::string manifest(std::span<const std::string> names) {
    std::string json = "{";
    for (const std::string& name : std::set<std::string>(names.begin(), names.end())) {
        if (json.size() > 1) json += ',';
        json += fmt::format("\"{}\":\"{:08x}\"", escaped(name), cryptomatte_id(name));
    }
    return json + "}";
}

}  // namespace

std::uint32_t murmur_hash_3(std::string_view text) {
    std::uint32_t hash = 0;
    std::size_t i = 0;
    for (; i + 4 <= text.size(); i += 4) {
        hash ^= scrambled(byte_at(text, i) | byte_at(text, i + 1) << 8 |
                          byte_at(text, i + 2) << 16 | byte_at(text, i + 3) << 24);
        hash = std::rotl(hash, 13) * 5 + 0xe6546b64u;
    }
    std::uint32_t tail = 0;
    for (std::size_t k = text.size(); k > i; --k)
        tail = tail << 8 | byte_at(text, k - 1);
    if (i < text.size()) hash ^= scrambled(tail);
    hash ^= static_cast<std::uint32_t>(text.size());
    hash = (hash ^ hash >> 16) * 0x85ebca6bu;
    hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
    return hash ^ hash >> 16;
}

std::uint32_t cryptomatte_id(std::string_view name) {
    const std::uint32_t hash = murmur_hash_3(name);
    const std::uint32_t exponent = hash >> 23 & 255;
    return exponent == 0 || exponent == 255 ? hash ^ 1u << 23 : hash;
}

void add_cryptomatte_header(const std::string& layer, std::span<const std::string> names,
                            ImageMetadata& metadata) {
    const std::string key =
        "cryptomatte/" + fmt::format("{:08x}", murmur_hash_3(layer)).substr(0, 7) + "/";
    metadata[key + "name"] = layer;
    metadata[key + "hash"] = "MurmurHash3_32";
    metadata[key + "conversion"] = "uint32_to_float32";
    metadata[key + "manifest"] = manifest(names);
}

}  // namespace lxs
