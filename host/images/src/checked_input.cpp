// The formats of images, and the choice of a reader.
#include "checked_input.h"

#include <OpenImageIO/strutil.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace lxs {
namespace {

namespace fs = std::filesystem;

/// Those that renderers and their exporters know. OpenImageIO has more, for films, scanners,
/// volumes and cameras; their readers ask for whatever a file claims as they open it.
constexpr std::array<std::string_view, 13> kFormats{
    "openexr", "hdr",      "png", "jpeg", "tiff", "bmp",  "dds",
    "gif",     "jpeg2000", "pnm", "sgi",  "webp", "targa"};  // the last has no mark of its own, and
                                                             // may take others' files

constexpr std::int64_t kFarthest = std::int64_t{1} << 30;  // sums of places and sides are ints

void check_opened(const OIIO::ImageSpec& spec, std::uint64_t bytes) {
    check_claim(claim_of(spec), bytes);
    if (std::abs(std::int64_t{spec.x}) > kFarthest || std::abs(std::int64_t{spec.y}) > kFarthest)
        throw std::runtime_error("its pixels lie outside of its image");
}

/// Null if this is no file of that format; `reason` then says why.
std::unique_ptr<OIIO::ImageInput> open_as(std::string_view format, const std::string& path,
                                          const OIIO::ImageSpec& reading, std::string& reason) {
    auto file = OIIO::ImageInput::create(std::string(format));
    OIIO::ImageSpec spec, configuration = reading;
    // Of a grey BMP file with run lengths it would write three channels where it says one.
    configuration.attribute("bmp:monochrome_detect", 0);
    if (file && file->open(path, spec, configuration)) return file;
    if (file) reason = file->geterror();
    return nullptr;
}

/// The format that files with the ending of `path` have; empty if it is none of ours.
std::string_view usual_format(const std::string& path) {
    static const auto endings = OIIO::get_extension_map();  // of each format
    const std::string ending = OIIO::Strutil::lower(fs::path(path).extension().string());
    for (const std::string_view format : kFormats) {
        const auto known = endings.find(std::string(format));
        if (ending.empty() || known == endings.end()) continue;
        if (std::ranges::find(known->second, ending.substr(1)) != known->second.end())
            return format;
    }
    return {};
}

std::unique_ptr<OIIO::ImageInput> open_with_any(const std::string& path, std::uint64_t bytes,
                                                const OIIO::ImageSpec& reading) {
    check_header(path, bytes);
    const std::string_view usual = usual_format(path);
    std::string reason;
    auto file = usual.empty() ? nullptr : open_as(usual, path, reading, reason);
    // The name may be wrong: the other formats know theirs by what stands in it.
    for (const std::string_view format : kFormats) {
        std::string ignored;
        if (!file && format != usual) file = open_as(format, path, reading, ignored);
    }
    if (file) return file;
    if (reason.empty())
        reason = fmt::format("it has none of the formats {}", fmt::join(kFormats, ", "));
    throw std::runtime_error(reason);
}

}  // namespace

std::unique_ptr<OIIO::ImageInput> open_checked(const std::string& path,
                                               const OIIO::ImageSpec& reading) {
    // Ours are checked instead, and say what they are.
    static const bool unlimited =
        OIIO::attribute("limits:imagesize_MB", 0) && OIIO::attribute("limits:channels", 0);
    static_cast<void>(unlimited);
    std::error_code missing;
    const std::uint64_t bytes = fs::file_size(path, missing);
    if (missing) throw std::runtime_error(missing.message());
    return with_reasons([&] {
        auto file = open_with_any(path, bytes, reading);
        check_opened(file->spec(), bytes);
        return file;
    });
}

std::string first_line(const std::string& text) {
    std::string line = text.substr(0, text.find('\n'));
    while (!line.empty() && (line.back() == '.' || line.back() == ' '))
        line.pop_back();
    // It may hold names from the file, and goes to terminals.
    std::ranges::replace_if(
        line, [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
    return line.empty() ? "reading failed" : line;
}

ImageClaim claim_of(const OIIO::ImageSpec& spec) {
    return {spec.width,      spec.height,      spec.depth,     spec.nchannels,
            spec.tile_width, spec.tile_height, spec.tile_depth};
}

}  // namespace lxs
