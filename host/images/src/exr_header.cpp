// Walks over the attributes of OpenEXR headers (openexr.com, "OpenEXR File Layout").
#include "lxs/images/exr_header.h"

#include <OpenEXR/ImfVersion.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace lxs {
namespace {

/// Bytes of the values of a type.
constexpr std::pair<std::string_view, std::uint32_t> kSizes[] = {{"box2f", 16},
                                                                 {"box2i", 16},
                                                                 {"chromaticities", 32},
                                                                 {"compression", 1},
                                                                 {"deepImageState", 1},
                                                                 {"double", 8},
                                                                 {"envmap", 1},
                                                                 {"float", 4},
                                                                 {"int", 4},
                                                                 {"keycode", 28},
                                                                 {"lineOrder", 1},
                                                                 {"m33d", 72},
                                                                 {"m33f", 36},
                                                                 {"m44d", 128},
                                                                 {"m44f", 64},
                                                                 {"rational", 8},
                                                                 {"tiledesc", 9},
                                                                 {"timecode", 8},
                                                                 {"v2d", 16},
                                                                 {"v2f", 8},
                                                                 {"v2i", 8},
                                                                 {"v3d", 24},
                                                                 {"v3f", 12},
                                                                 {"v3i", 12}};

[[noreturn]] void fail_size() {
    throw std::runtime_error("a value of its header has another size than it says");
}

/// The bytes of a value, as numbers.
class Numbers {
  public:
    explicit Numbers(std::string_view bytes) : bytes_(bytes) {}

    std::size_t left() const { return bytes_.size() - at_; }
    void skip(std::size_t bytes) {
        if (bytes > left()) fail_size();
        at_ += bytes;
    }
    std::uint32_t next_unsigned() {
        skip(4);
        std::uint32_t number = 0;
        for (std::size_t i = 0; i < 4; ++i)
            number |= std::uint32_t{static_cast<unsigned char>(bytes_[at_ - 4 + i])} << (8 * i);
        return number;
    }
    std::int64_t next() { return static_cast<std::int32_t>(next_unsigned()); }
    /// Passes over a text up to its zero; returns its length.
    std::size_t text() {
        const std::size_t end = bytes_.find('\0', at_);
        if (end == std::string_view::npos) fail_size();
        const std::size_t length = end - at_;
        at_ = end + 1;
        return length;
    }

  private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

/// Lists of channels end with an empty name, and must do so where their size says.
std::int64_t channels_in(const std::string& bytes) {
    constexpr std::size_t kAfterName = 16;
    Numbers value(bytes);
    std::int64_t count = 0;
    for (; value.text() > 0; ++count)
        value.skip(kAfterName);
    if (value.left() > 0) fail_size();
    return count;
}

void check_preview(const std::string& bytes) {
    Numbers value(bytes);
    const std::uint64_t width = value.next_unsigned(), height = value.next_unsigned();
    if (width > value.left() || height > value.left() || width * height * 4 != value.left())
        fail_size();
}

void check_texts(const std::string& bytes) {
    Numbers value(bytes);
    while (value.left() > 0)
        value.skip(value.next_unsigned());
}

class HeaderWalk {
  public:
    HeaderWalk(Imf::IStream& file, std::uint64_t bytes) : file_(file), bytes_(bytes) {}

    std::vector<ExrClaim> run() {
        std::array<char, 8> start{};
        if (bytes_ < start.size()) throw std::runtime_error("it is no OpenEXR file");
        file_.read(start.data(), start.size());
        if (!Imf::isImfMagic(start.data())) throw std::runtime_error("it is no OpenEXR file");
        Numbers numbers(std::string_view(start.data(), start.size()));
        numbers.skip(4);
        const bool several = Imf::isMultiPart(static_cast<int>(numbers.next()));
        std::vector<ExrClaim> parts;
        do {
            ExrClaim claim;
            const bool empty = !part(claim);
            if (several && empty) break;
            parts.push_back(claim);
        } while (several);
        return parts;
    }

  private:
    /// Of a text in the file, without its zero.
    std::string text() {
        constexpr std::size_t kLongest = 255;
        std::string read;
        for (char c = next(); c != 0; c = next()) {
            if (read.size() == kLongest)
                throw std::runtime_error("a name in its header is too long");
            read += c;
        }
        return read;
    }
    char next() {
        if (file_.tellg() >= bytes_) throw std::runtime_error("the file ends too early");
        char c = 0;
        file_.read(&c, 1);
        return c;
    }

    /// Attributes (name, type, size, value) up to an empty name; false if that comes first.
    bool part(ExrClaim& claim) {
        bool any = false;
        for (std::string name = text(); !name.empty(); name = text()) {
            any = true;
            const std::string type = text();
            std::uint32_t size = 0;
            for (int shift = 0; shift < 32; shift += 8)
                size |= std::uint32_t{static_cast<unsigned char>(next())} << shift;
            const std::uint64_t begin = file_.tellg();
            if (size > bytes_ - begin) throw std::runtime_error("the file ends too early");
            attribute(name, type, size, claim);
            file_.seekg(begin + size);
        }
        return any;
    }
    /// The value that comes next.
    std::string value(std::uint32_t size) {
        if (size > std::numeric_limits<int>::max()) fail_size();
        std::string bytes(size, '\0');
        if (size > 0) file_.read(bytes.data(), static_cast<int>(size));
        return bytes;
    }

    void attribute(const std::string& name, const std::string& type, std::uint32_t size,
                   ExrClaim& claim) {
        const auto* const known =
            std::ranges::find(kSizes, type, &std::pair<std::string_view, std::uint32_t>::first);
        if (known != std::end(kSizes) && size != known->second) fail_size();
        if (type == "preview") check_preview(value(size));
        if (type == "stringvector") check_texts(value(size));
        if (type == "chlist") {
            const std::int64_t channels = channels_in(value(size));
            if (name == "channels") claim.channels = channels;
        }
        if (type == "box2i" && name == "dataWindow") {
            const std::string bytes = value(size);
            Numbers box(bytes);
            const std::int64_t x = box.next(), y = box.next();
            claim.width = box.next() - x + 1;
            claim.height = box.next() - y + 1;
        }
        if (type == "tiledesc" && name == "tiles") {
            const std::string bytes = value(size);
            Numbers tile(bytes);
            claim.tile_width = tile.next_unsigned();
            claim.tile_height = tile.next_unsigned();
        }
    }

    Imf::IStream& file_;
    std::uint64_t bytes_;
};

}  // namespace

std::vector<ExrClaim> exr_claims(Imf::IStream& file, std::uint64_t bytes) {
    return HeaderWalk(file, bytes).run();
}

}  // namespace lxs
