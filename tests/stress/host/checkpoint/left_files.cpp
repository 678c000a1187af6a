// What a killed render has left in its folder.
#include "left_files.h"

#include <OpenImageIO/imageio.h>

#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "lxs/host/checkpoint_file.h"

namespace stress {
namespace {

void read_image(const std::string& path) {
    const auto image = OIIO::ImageInput::open(path);
    if (!image) throw std::runtime_error(OIIO::geterror());
    const OIIO::ImageSpec& spec = image->spec();
    std::vector<float> pixels(spec.image_pixels() * std::size_t(spec.nchannels));
    if (!image->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data()))
        throw std::runtime_error(image->geterror());
}

/// A PNG ends in an empty chunk IEND, which readers don't miss.
void check_png_end(const std::string& bytes) {
    const std::string end("\0\0\0\0IEND\xae\x42\x60\x82", 12);
    if (!bytes.ends_with(end)) throw std::runtime_error("it has no end");
}

void read_output(const files::TemporaryFolder& folder, const std::string& name) {
    if (name == "check") {
        lxs::checkpoint_content(lxs::read_checkpoint_file(folder / name));
    } else if (name == "stats.json") {
        if (nlohmann::json::parse(folder.read(name)).empty()) throw std::runtime_error("is empty");
    } else {
        read_image(folder / name);
        if (name == "out.png") check_png_end(folder.read(name));
    }
}

}  // namespace

std::string torn_outputs(const files::TemporaryFolder& folder) {
    std::string torn;
    for (const char* name : kOutputs) {
        if (!folder.has(name)) continue;
        try {
            read_output(folder, name);
        } catch (const std::exception& error) {
            torn += std::string(name) + ": " + error.what() + '\n';
        }
    }
    return torn;
}

std::string folder_state(const files::TemporaryFolder& folder) {
    std::string state;
    std::error_code gone;  // between one call and the next: a difference as well
    for (const auto& entry : std::filesystem::directory_iterator(folder.path(), gone)) {
        state += entry.path().filename().string() + ' ' + std::to_string(entry.file_size(gone)) +
                 ' ' + std::to_string(entry.last_write_time(gone).time_since_epoch().count()) +
                 '\n';
    }
    return state;
}

std::string temporary_files(const files::TemporaryFolder& folder) {
    std::string names;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path(), ignored)) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(".tmp")) names += name + ' ';
    }
    return names;
}

}  // namespace stress
