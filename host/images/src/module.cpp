// The shared object with the image library.
#include "lxs/images/image_library.h"

/// What image_loader.cpp looks for.
extern "C" __attribute__((visibility("default"))) const lxs::ImageLibrary* lxs_image_library() {
    return &lxs::image_library();
}
