// Opens image files with OpenImageIO once their claims have been checked.
#pragma once

#include <OpenImageIO/imageio.h>

#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "image_claim.h"

namespace lxs {

/// The reader of the image file `path`, opened with the configuration `reading`: one of a format
/// that holds pictures, whose sizes check_claim() has found good, before and after it was opened.
/// Throws std::runtime_error with the reason.
std::unique_ptr<OIIO::ImageInput> open_checked(const std::string& path,
                                               const OIIO::ImageSpec& reading);

/// First line of an OpenImageIO message, printable and without its full stop; never empty.
std::string first_line(const std::string& text);

/// What `read` returns; whatever it throws becomes a std::runtime_error, but for lack of memory:
/// readers throw what their libraries do.
template <class Read>
auto with_reasons(Read&& read) {
    try {
        return std::forward<Read>(read)();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw std::runtime_error(first_line(error.what()));
    }
}

/// Width, height, layers, channels and tiles.
ImageClaim claim_of(const OIIO::ImageSpec& spec);

}  // namespace lxs
