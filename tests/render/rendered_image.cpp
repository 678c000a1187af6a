// Renders a scene file with lxsrender and reads the image back.
#include "rendered_image.h"

#include <OpenImageIO/imageio.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "block_test.h"

namespace render {
namespace fs = std::filesystem;
namespace {

/// Not an ImageBuf: its cache would give an earlier render of the same name and second.
std::unique_ptr<OIIO::ImageInput> opened(const fs::path& file) {
    auto input = OIIO::ImageInput::open(file.string());
    if (!input) throw std::runtime_error(OIIO::geterror());
    return input;
}

}  // namespace

std::vector<double> Image::luminance() const {
    std::vector<double> values(width * height);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = 0.2126 * double(rgb[3 * i]) + 0.7152 * double(rgb[3 * i + 1]) +
                    0.0722 * double(rgb[3 * i + 2]);
    }
    return values;
}

std::vector<double> Image::block_means(std::size_t size) const {
    return statistics::block_means(luminance(), width, height, size);
}

std::set<std::string> channel_names(const fs::path& file) {
    const auto names = opened(file)->spec().channelnames;
    return {names.begin(), names.end()};
}

Image read_channels(const fs::path& file, const std::vector<std::string>& channels) {
    const auto input = opened(file);
    const OIIO::ImageSpec& spec = input->spec();
    Image image{std::size_t(spec.width), std::size_t(spec.height), {}};
    image.rgb.resize(image.width * image.height * channels.size());
    float* first = image.rgb.data();
    for (const std::string& name : channels) {
        const int channel = spec.channelindex(name);
        if (channel < 0) throw std::runtime_error(file.string() + ": no channel \"" + name + '"');
        if (!input->read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::FLOAT, first++,
                               OIIO::stride_t(channels.size() * sizeof(float)))) {
            throw std::runtime_error("cannot read " + file.string() + ": " + input->geterror());
        }
    }
    return image;
}

Image read_layer(const fs::path& file, const std::string& layer) {
    const std::string prefix = layer.empty() ? "" : layer + '.';
    return read_channels(file, {prefix + "R", prefix + "G", prefix + "B"});
}

std::string header_text(const fs::path& file, const std::string& name) {
    const auto input = opened(file);
    const OIIO::ParamValue* text = input->spec().find_attribute(name);
    if (!text) throw std::runtime_error(file.string() + ": no \"" + name + "\" in the header");
    return text->get_string();
}

Image read_image(const fs::path& file) {
    return read_layer(file, "");
}

void write_image(const Image& image, const fs::path& file) {
    const auto output = OIIO::ImageOutput::create(file.string());
    const OIIO::ImageSpec spec(int(image.width), int(image.height), 3, OIIO::TypeDesc::FLOAT);
    if (!output || !output->open(file.string(), spec) ||
        !output->write_image(OIIO::TypeDesc::FLOAT, image.rgb.data()) || !output->close()) {
        throw std::runtime_error("cannot write " + file.string());
    }
}

std::string output_of(const std::string& command) {
    const auto close = [](std::FILE* pipe) { return pclose(pipe); };
    std::unique_ptr<std::FILE, decltype(close)> pipe(popen(command.c_str(), "r"), close);
    std::string text;
    std::array<char, 4096> buffer;
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe.get())) {
        text.append(buffer.data(), n);
    }
    if (pclose(pipe.release()) != 0) throw std::runtime_error(command + "\n" + text);
    return text;
}

Image render(const fs::path& scene, const std::string& arguments, const Folder& folder) {
    const fs::path output = folder.path() / "out.exr";
    output_of(std::string(LXSRENDER) + " '" + scene.string() + "' -o '" + output.string() + "' " +
              arguments + " 2>&1");
    return read_image(output);
}

fs::path edited_scene(const fs::path& scene, const Folder& folder,
                      const std::vector<std::pair<std::string, std::string>>& replacements) {
    std::ifstream in(scene);
    std::stringstream content;
    content << in.rdbuf();
    std::string text = content.str();
    for (const auto& [from, to] : replacements) {
        const auto at = text.find(from);
        if (at == std::string::npos) throw std::runtime_error(scene.string() + ": no " + from);
        text.replace(at, from.size(), to);
    }
    fs::path copy = folder.path() / scene.filename();
    std::ofstream(copy) << text;
    return copy;
}

fs::path small_scene(const std::string& name, const Folder& folder, int width, int height) {
    fs::path copy = edited_scene(fs::path(SCENES) / (name + ".lxs"), folder, {});
    std::ifstream in(copy);
    std::stringstream content;
    content << in.rdbuf();
    std::string text = content.str();
    const std::array<std::pair<const char*, int>, 2> sizes{
        {{"xresolution", width}, {"yresolution", height}}};
    for (const auto& [key, size] : sizes) {
        text = std::regex_replace(text, std::regex(std::string(key) + "\" \\[\\d+\\]"),
                                  std::string(key) + "\" [" + std::to_string(size) + "]");
    }
    std::ofstream(copy) << text;
    // Meshes and included parts are looked for beside the scene.
    const fs::path meshes = folder.path() / "meshes";
    if (!fs::exists(meshes)) fs::create_directory_symlink(fs::path(SCENES) / "meshes", meshes);
    return copy;
}

}  // namespace render
