// PNG files in memory.
#include "png_encoder.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

namespace lxs {
namespace {

/// libpng leaves by it; it must not return.
[[noreturn]] void fail(png_structp /*png*/, png_const_charp reason) {
    throw std::runtime_error(reason);
}
void ignore(png_structp /*png*/, png_const_charp /*warning*/) {}

void append(png_structp png, png_bytep data, std::size_t count) {
    auto& bytes = *static_cast<std::vector<std::byte>*>(png_get_io_ptr(png));
    const auto added = std::as_bytes(std::span(data, count));
    bytes.insert(bytes.end(), added.begin(), added.end());
}
void flush(png_structp /*png*/) {}

/// libpng's two structures of a file that is written.
class Writer {
  public:
    Writer() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, &fail, &ignore)) {
        if (png_) info_ = png_create_info_struct(png_);
        if (info_) return;
        png_destroy_write_struct(&png_, nullptr);
        throw std::bad_alloc();
    }
    ~Writer() { png_destroy_write_struct(&png_, &info_); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    png_structp png() const { return png_; }
    png_infop info() const { return info_; }

  private:
    png_structp png_;
    png_infop info_ = nullptr;
};

}  // namespace

std::vector<std::byte> encode_png(std::uint32_t width, std::uint32_t height, double gamma,
                                  std::span<const std::uint8_t> rgb, std::span<const float> alpha) {
    std::vector<std::byte> bytes;
    const Writer writer;
    const png_structp png = writer.png();
    png_set_write_fn(png, &bytes, &append, &flush);
    png_set_IHDR(png, writer.info(), width, height, 8,
                 alpha.empty() ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (std::abs(gamma - 2.2) < 0.01) {
        png_set_sRGB_gAMA_and_cHRM(png, writer.info(), PNG_sRGB_INTENT_ABSOLUTE);
    } else {
        png_set_gAMA(png, writer.info(), 1 / gamma);
    }
    png_write_info(png, writer.info());
    std::vector<std::uint8_t> row(alpha.empty() ? 0 : std::size_t{4} * width);
    for (std::uint32_t y = 0; y < height; ++y) {
        const std::uint8_t* const colors = rgb.data() + std::size_t{3} * width * y;
        for (std::size_t x = 0; x < row.size() / 4; ++x) {
            std::copy_n(colors + 3 * x, 3, &row[4 * x]);
            row[4 * x + 3] =
                static_cast<std::uint8_t>(std::lround(255 * alpha[std::size_t{y} * width + x]));
        }
        png_write_row(png, row.empty() ? colors : row.data());
    }
    png_write_end(png, writer.info());
    return bytes;
}

}  // namespace lxs
