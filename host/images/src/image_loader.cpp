// The image library of programs that load it with the first image.
#include <filesystem>

#include "lxs/images/image_library.h"
#include "lxs/modules/load_module.h"
#include "lxs/modules/module_file.h"

namespace lxs {
namespace {

namespace fs = std::filesystem;

class LoadedLibrary {
  public:
    LoadedLibrary() {
        const fs::path file = image_library_file();
        if (file.empty()) {
            throw ImageLibraryFailure("images can't be read: the file " LXS_IMAGES_MODULE
                                      " is missing from the installation");
        }
        try {
            load_module(module_, file);
            library_ = module_function<const ImageLibrary*()>(module_, "lxs_image_library")();
        } catch (const std::exception& cause) {
            throw ImageLibraryFailure("images can't be read: '" + file.string() +
                                      "' can't be loaded: " + cause.what());
        }
    }
    const ImageLibrary& get() const { return *library_; }

  private:
    boost::dll::shared_library module_;
    const ImageLibrary* library_ = nullptr;
};

}  // namespace

fs::path image_library_file() {
    return beside_program({LXS_INSTALLED_IMAGES, LXS_BUILT_IMAGES});
}

const ImageLibrary& image_library() {
    static const LoadedLibrary loaded;
    return loaded.get();
}

}  // namespace lxs
