// An image file as OpenImageIO is to cache it.
#include "cleaned_input.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "checked_input.h"

namespace lxs {
namespace {

constexpr const char* kPathAttribute = "lxs:path";
constexpr const char* kGammaAttribute = "lxs:gamma";
constexpr const char* kSrgbAttribute = "lxs:srgb";

}  // namespace

OIIO::ImageSpec CleanedInput::configuration(const std::string& path, const StoredCurve& curve) {
    OIIO::ImageSpec configuration;
    configuration.attribute(kGammaAttribute, curve.gamma);
    configuration.attribute(kSrgbAttribute, curve.srgb ? 1 : 0);
    configuration.attribute(kPathAttribute, path);
    return configuration;
}

bool CleanedInput::open(const std::string& /*name*/, OIIO::ImageSpec& /*spec*/) {
    errorfmt("an image texture needs its configuration");
    return false;
}

bool CleanedInput::open(const std::string& /*name*/, OIIO::ImageSpec& spec,
                        const OIIO::ImageSpec& configuration) {
    OIIO::ImageSpec reading;
    reading.attribute("oiio:UnassociatedAlpha", 1);
    const std::string path(configuration.get_string_attribute(kPathAttribute));
    try {
        file_ = open_checked(path, reading);
    } catch (const std::runtime_error& error) {
        errorfmt("{}", error.what());
        return false;
    }
    curve_ = {configuration.get_float_attribute(kGammaAttribute, 1),
              configuration.get_int_attribute(kSrgbAttribute) != 0};
    m_spec = file_->spec();
    m_spec.set_format(OIIO::TypeDesc::FLOAT);
    m_spec.channelformats.clear();
    spec = m_spec;
    return true;
}

bool CleanedInput::close() {
    file_.reset();
    return true;
}

/// A reader that has failed is not used again: OpenImageIO 2.4's for PNG opens its file anew to go
/// back to an earlier row, and crashes at the next one if the file is gone.
bool CleanedInput::forward_error() {
    if (file_) failure_ = file_->geterror();
    file_.reset();
    errorfmt("{}", first_line(failure_));
    return false;
}

void CleanedInput::clean(float* values, std::size_t pixels) {
    for (std::size_t i = 0; i < pixels * m_spec.nchannels; ++i) {
        if (values[i] >= 0 && std::isfinite(values[i])) continue;
        values[i] = 0;
        ++refused_;
    }
    if (curve_.changes()) decode(values, pixels);
}

void CleanedInput::decode(float* values, std::size_t pixels) const {
    for (std::size_t i = 0; i < pixels; ++i)
        for (int c = 0; c < m_spec.nchannels; ++c, ++values)
            if (c != m_spec.alpha_channel) *values = curve_.linear(*values);
}

bool CleanedInput::read_native_scanline(int /*subimage*/, int /*miplevel*/, int y, int z,
                                        void* data) {
    if (!file_ || !file_->read_scanline(y, z, OIIO::TypeDesc::FLOAT, data)) return forward_error();
    clean(static_cast<float*>(data), m_spec.width);
    return true;
}

bool CleanedInput::read_native_tile(int /*subimage*/, int /*miplevel*/, int x, int y, int z,
                                    void* data) {
    if (!file_ || !file_->read_tile(x, y, z, OIIO::TypeDesc::FLOAT, data)) return forward_error();
    clean(static_cast<float*>(data), m_spec.tile_pixels());
    return true;
}

bool CleanedInput::read_through() {
    const bool tiled = m_spec.tile_width > 0;
    const int width = tiled ? m_spec.tile_width : m_spec.width;
    const int height = tiled ? m_spec.tile_height : 1;
    std::vector<float> values(std::size_t{1} * width * height * m_spec.nchannels);
    for (int y = m_spec.y; y < m_spec.y + m_spec.height; y += height) {
        for (int x = m_spec.x; x < m_spec.x + m_spec.width; x += width) {
            const bool read = tiled ? read_native_tile(0, 0, x, y, 0, values.data())
                                    : read_native_scanline(0, 0, y, 0, values.data());
            if (!read) return false;
        }
    }
    return true;
}

}  // namespace lxs
