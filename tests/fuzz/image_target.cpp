// Fuzz target: image files of others, as textures and as maps of lights. The first byte chooses one
// of the small files of all formats (rows, tiles, a volume, a cube map), the rest edits it.
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "damaged_bytes.h"
#include "fuzz_target.h"
#include "input_bytes.h"
#include "input_files.h"
#include "lxs/images/image_library.h"
#include "made_images.h"

namespace {

void read_as_texture(const std::string& path) {
    static const auto cache = lxs::image_library().make_cache();
    const auto image = cache->open(path);
    for (const float s : {0.0f, 0.3f, 0.999f, 1.7f}) {
        float value = -1;
        image->look_up(s, 1 - s, image->channels() - 1, {}, std::span(&value, 1));
        if (!(std::isfinite(value) && value >= 0)) std::abort();
    }
}

void read_as_map(const std::string& path) {
    const lxs::FloatImage image = lxs::image_library().read(path);
    if (image.width < 1 || image.height < 1 || image.channels < 1 ||
        image.values.size() != image.width * image.height * image.channels)
        std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::vector<lxs::test::MadeImage> images = lxs::test::small_images();
    fuzz::InputBytes input(data, size);
    const lxs::test::MadeImage& whole = images[input.below(images.size())];
    const std::vector<std::byte> bytes =
        fuzz::damaged_bytes(std::as_bytes(std::span(whole.bytes)), input);
    const std::string path = fuzz::folder().write(
        whole.name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    for (const auto read : {&read_as_texture, &read_as_map}) {
        try {
            read(path);
        } catch (const std::runtime_error& refusal) {
            fuzz::check_refusal(refusal);
        }
    }
    return 0;
}
