// An image file as OpenImageIO is to cache it: floats, never negative, always finite.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <memory>
#include <string>

#include "lxs/spectrum/stored_curve.h"

namespace lxs {

/// Sets values that no texture may have (NaN, infinite, negative) to 0. Registered with the image
/// cache as the reader of virtual files; the open() configuration names the real file. Finest level
/// only.
class CleanedInput final : public OIIO::ImageInput {
  public:
    /// Configuration for open(). `curve`: by which stored values become linear.
    static OIIO::ImageSpec configuration(const std::string& path, const StoredCurve& curve);
    /// What the image cache calls to make readers.
    static OIIO::ImageInput* create() { return new CleanedInput; }

    const char* format_name() const override { return "cleaned"; }
    bool open(const std::string& name, OIIO::ImageSpec& spec) override;
    bool open(const std::string& name, OIIO::ImageSpec& spec,
              const OIIO::ImageSpec& configuration) override;
    bool close() override;
    bool seek_subimage(int subimage, int miplevel) override {
        return subimage == 0 && miplevel == 0;
    }
    bool read_native_scanline(int subimage, int miplevel, int y, int z, void* data) override;
    bool read_native_tile(int subimage, int miplevel, int x, int y, int z, void* data) override;

    /// Reads the whole image once, a row of tiles at a time. False if the file is damaged.
    bool read_through();
    /// Values set to 0 so far.
    std::uint64_t refused() const { return refused_; }

  private:
    void clean(float* values, std::size_t pixels);
    void decode(float* values, std::size_t pixels) const;
    bool forward_error();

    std::unique_ptr<OIIO::ImageInput> file_;
    std::string failure_;  ///< why reading failed; empty if it did not
    std::uint64_t refused_ = 0;
    StoredCurve curve_;
};

}  // namespace lxs
