// Limits of images, and headers of the formats that must be known before their readers are asked.
#include "image_claim.h"

#include <OpenEXR/ImfStdIO.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "lxs/images/exr_header.h"

namespace lxs {
namespace {

/// Of a colour table with opacity, one bit a pixel, in bytes of which zlib makes one of 1032
/// (zlib.net, "Maximum Compression Factor").
constexpr std::int64_t kMostValuesPerByte = std::int64_t{4} * 8 * 1032;
constexpr std::int64_t kAlwaysBelieved = std::int64_t{4} * 4096 * 4096;

/// Reads numbers of either byte order from a file, which ends with std::runtime_error.
class HeaderBytes {
  public:
    explicit HeaderBytes(const std::string& path) : file_(path, std::ios::binary) {}

    /// The first bytes, fewer if the file is shorter.
    std::string start(std::size_t bytes) {
        std::string read(bytes, '\0');
        file_.read(read.data(), static_cast<std::streamsize>(bytes));
        read.resize(static_cast<std::size_t>(file_.gcount()));
        file_.clear();
        return read;
    }
    HeaderBytes& at(std::uint64_t place) {
        file_.seekg(static_cast<std::streamoff>(place));
        return *this;
    }
    std::uint64_t place() { return static_cast<std::uint64_t>(file_.tellg()); }
    std::uint64_t big(int bytes) {
        std::uint64_t number = 0;
        for (int i = 0; i < bytes; ++i)
            number = number << 8 | byte();
        return number;
    }
    std::uint64_t little(int bytes) {
        std::uint64_t number = 0;
        for (int i = 0; i < bytes; ++i)
            number |= byte() << (8 * i);
        return number;
    }

  private:
    std::uint64_t byte() {
        char c = 0;
        if (!file_.get(c)) throw std::runtime_error("the file ends within its header");
        return static_cast<unsigned char>(c);
    }

    std::ifstream file_;
};

ImageClaim flat(std::uint64_t width, std::uint64_t height, std::uint64_t channels) {
    ImageClaim claim;
    claim.width = static_cast<std::int64_t>(width);
    claim.height = static_cast<std::int64_t>(height);
    claim.channels = static_cast<std::int64_t>(channels);
    return claim;
}

ImageClaim gif_claim(HeaderBytes& file) {
    file.at(6);
    const std::uint64_t width = file.little(2), height = file.little(2);
    return flat(width, height, 4);
}

ImageClaim bmp_claim(HeaderBytes& file) {
    constexpr std::uint64_t kOldHeader = 12;  // of OS/2
    const int bytes = file.at(14).little(4) == kOldHeader ? 2 : 4;
    const std::uint64_t width = file.little(bytes);
    const auto height = static_cast<std::int32_t>(file.little(bytes));  // below 0: the top first
    return flat(width, static_cast<std::uint64_t>(std::abs(std::int64_t{height})), 4);
}

ImageClaim sgi_claim(HeaderBytes& file) {
    constexpr std::uint64_t kTables = 8;  // bytes for each row of each channel
    file.at(6);
    const std::uint64_t width = file.big(2), height = file.big(2);
    return flat(std::max(width, kTables), height, file.big(2));
}

/// Throws for pixels at which OpenImageIO's reader never ends, or divides by zero: of 0 bits in a
/// channel, of other than whole bytes, with colours that are multiplied by the opacity.
ImageClaim dds_claim(HeaderBytes& file) {
    constexpr std::uint64_t kOpacity = 1, kOpacityAlone = 2, kCompressed = 4, kLuminance = 0x20000;
    const std::uint64_t height = file.at(12).little(4), width = file.little(4);
    const std::uint64_t kind = file.at(80).little(4), compression = file.big(4);
    const std::uint64_t bits = file.little(4);
    const std::uint64_t red = file.little(4), green = file.little(4), blue = file.little(4);
    const std::uint64_t opacity = file.little(4);
    bool read = true;
    if ((kind & kCompressed) != 0) {
        read = compression != 0x44585432 && compression != 0x44585434;  // "DXT2", "DXT4"
    } else {
        read = bits % 8 == 0 && bits >= 8 && bits <= 32;
        if ((kind & kLuminance) != 0) {
            read &= red != 0 && ((kind & kOpacity) == 0 || opacity != 0);
        } else if ((kind & kOpacityAlone) != 0) {
            read &= opacity != 0 && (kind & kOpacity) == 0;
        } else {
            read &= red != 0 && green != 0 && blue != 0 && ((kind & kOpacity) == 0 || opacity != 0);
        }
    }
    if (!read) throw std::runtime_error("it is of a kind of DDS that is not read");
    return flat(width, height, 4);
}

/// Of the canvas, or of the only picture (developers.google.com/speed/webp, container).
ImageClaim webp_claim(HeaderBytes& file) {
    constexpr std::uint64_t kSide = 0x3FFF;  // bits of a side
    const std::uint64_t kind = file.at(12).big(4);
    if (kind == 0x56503858) {  // "VP8X"
        const std::uint64_t width = file.at(24).little(3), height = file.little(3);
        return flat(width + 1, height + 1, 4);
    }
    if (kind == 0x5650384C) {  // "VP8L"
        const std::uint64_t sides = file.at(21).little(4);
        return flat((sides & kSide) + 1, (sides >> 14 & kSide) + 1, 4);
    }
    const std::uint64_t width = file.at(26).little(2), height = file.little(2);
    return flat(width & kSide, height & kSide, 4);
}

/// Of the frame header, which is looked for from marker to marker (ITU T.81, annex B).
ImageClaim jpeg_claim(HeaderBytes& file) {
    constexpr std::uint64_t kFirstMarker = 2;
    constexpr int kMostGarbage = 1 << 16;  // bytes between markers, which readers pass over
    int garbage = 0;
    for (std::uint64_t place = kFirstMarker; garbage < kMostGarbage;) {
        const std::uint64_t marker = file.at(place).big(2), code = marker & 0xFF;
        if (marker >> 8 != 0xFF || code == 0xFF) {
            ++place;
            ++garbage;
            continue;
        }
        place += 2;
        if (code <= 0x01 || (code >= 0xD0 && code <= 0xD8)) continue;  // these stand alone
        if (code == 0xD9 || code == 0xDA) break;                       // what follows is no header
        const std::uint64_t length = file.big(2);
        const bool frame =
            code >= 0xC0 && code <= 0xCF && code != 0xC4 && code != 0xC8 && code != 0xCC;
        if (frame) {
            file.big(1);  // bits of a sample
            const std::uint64_t height = file.big(2), width = file.big(2);
            return flat(width, height, file.big(1));
        }
        place += length;
    }
    throw std::runtime_error("its header has no size");
}

/// Where the codestream begins in a file of boxes (ITU T.800, annex I).
std::uint64_t codestream_place(HeaderBytes& file) {
    constexpr std::uint64_t kCodestream = 0x6A703263;  // "jp2c"
    for (std::uint64_t place = 0;;) {
        std::uint64_t length = file.at(place).big(4), head = 8;
        const bool found = file.big(4) == kCodestream;
        if (length == 1) {
            length = file.big(8);
            head = 16;
        }
        if (found) return place + head;
        if (length < head || length > std::numeric_limits<std::uint32_t>::max())
            throw std::runtime_error("its header has no size");
        place += length;
    }
}

/// Of the codestream's marker SIZ, which is its first (ITU T.800, annex A).
ImageClaim jpeg_2000_claim(HeaderBytes& file, std::uint64_t codestream) {
    if (file.at(codestream).big(4) != 0xFF4FFF51)
        throw std::runtime_error("its header has no size");
    file.at(codestream + 8);
    const std::uint64_t right = file.big(4), bottom = file.big(4);
    const std::uint64_t left = file.big(4), top = file.big(4);
    if (right <= left || bottom <= top) return flat(0, 0, 0);
    return flat(right - left, bottom - top, file.at(codestream + 40).big(2));
}

void check_exr(const std::string& path, std::uint64_t bytes) {
    Imf::StdIFStream file(path.c_str());
    for (const ExrClaim& part : exr_claims(file, bytes)) {
        ImageClaim claim;
        claim.width = part.width;
        claim.height = part.height;
        claim.channels = part.channels;
        claim.tile_width = part.tile_width;
        claim.tile_height = part.tile_height;
        check_claim(claim, bytes);
    }
}

/// `side` filled up with tiles.
std::int64_t filled(std::int64_t side, std::int64_t tile) {
    return tile > 0 ? (side + tile - 1) / tile * tile : side;
}

}  // namespace

void check_claim(const ImageClaim& claim, std::uint64_t file_bytes) {
    const bool tiled = claim.tile_width != 0 || claim.tile_height != 0;
    if (claim.width < 1 || claim.height < 1 || claim.channels < 1 || claim.layers < 1 ||
        (tiled && (claim.tile_width < 1 || claim.tile_height < 1 || claim.tile_layers < 1)))
        throw std::runtime_error("it holds no pixels");
    if (claim.layers > 1 || (tiled && claim.tile_layers > 1)) {
        throw std::runtime_error(fmt::format("it is no flat image, but has {} layers",
                                             std::max(claim.layers, claim.tile_layers)));
    }
    const std::int64_t side =
        std::max({claim.width, claim.height, claim.tile_width, claim.tile_height});
    if (side > kLargestSide) {
        throw std::runtime_error(
            fmt::format("it or its tiles have a side of {} pixels, more than "
                        "{}",
                        side, kLargestSide));
    }
    if (claim.channels > kMostChannels) {
        throw std::runtime_error(
            fmt::format("it has {} channels, more than {}", claim.channels, kMostChannels));
    }
    const std::int64_t values = filled(claim.width, claim.tile_width) *
                                filled(claim.height, claim.tile_height) * claim.channels;
    if (values <= kAlwaysBelieved ||
        static_cast<std::uint64_t>(values / kMostValuesPerByte) <= file_bytes)
        return;
    std::string text = fmt::format("it claims {} x {} pixels", claim.width, claim.height);
    if (claim.channels > 1) text += fmt::format(" of {} channels", claim.channels);
    if (claim.tile_width > 0)
        text += fmt::format(" in tiles of {} x {}", claim.tile_width, claim.tile_height);
    throw std::runtime_error(
        fmt::format("{}, which a file of {} bytes can't hold", text, file_bytes));
}

void check_header(const std::string& path, std::uint64_t file_bytes) {
    using namespace std::string_view_literals;
    static constexpr std::array kBitmaps{"BM"sv, "BA"sv, "CI"sv, "CP"sv, "PT"sv};
    HeaderBytes file(path);
    const std::string start = file.start(12);
    const auto holds = [&](std::string_view mark, std::size_t at) {
        return start.size() >= at + mark.size() && start.compare(at, mark.size(), mark) == 0;
    };
    std::optional<ImageClaim> claim;
    if (start.starts_with("\x76\x2F\x31\x01"sv)) {
        check_exr(path, file_bytes);
    } else if (start.starts_with("DDS ")) {
        claim = dds_claim(file);
    } else if (start.starts_with("GIF")) {
        claim = gif_claim(file);
    } else if (std::ranges::find(kBitmaps, start.substr(0, 2)) != kBitmaps.end()) {
        claim = bmp_claim(file);
    } else if (start.starts_with("\x01\xDA"sv)) {
        claim = sgi_claim(file);
    } else if (start.starts_with("\xFF\xD8"sv)) {
        claim = jpeg_claim(file);
    } else if (start.starts_with("\xFF\x4F\xFF\x51"sv)) {
        claim = jpeg_2000_claim(file, 0);
    } else if (holds("jP  ", 4)) {
        claim = jpeg_2000_claim(file, codestream_place(file));
    } else if (start.starts_with("RIFF") && holds("WEBP", 8)) {
        claim = webp_claim(file);
    }
    if (claim) check_claim(*claim, file_bytes);
}

}  // namespace lxs
