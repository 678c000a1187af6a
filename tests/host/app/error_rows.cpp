// The rows of the pages of docs/reference/errors, and what causes them.
#include "error_rows.h"

#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "lxs/host/render_command.h"

namespace lxs::test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The pages of messages, in the order of their names.
std::vector<fs::path> pages_of_messages() {
    std::vector<fs::path> pages;
    for (const auto& entry : fs::directory_iterator(ERROR_PAGES)) {
        if (entry.path().extension() == ".md" && entry.path().filename() != "index.md") {
            pages.push_back(entry.path());
        }
    }
    std::sort(pages.begin(), pages.end());
    return pages;
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::size_t begin = 1;
    for (std::size_t end; (end = line.find('|', begin)) != std::string::npos; begin = end + 1) {
        const auto first = line.find_first_not_of(' ', begin);
        const auto last = line.find_last_not_of(' ', end - 1);
        cells.push_back(first < end ? line.substr(first, last - first + 1) : "");
    }
    return cells;
}

std::string without_quotes(const std::string& code) {
    if (code.size() < 2 || code.front() != '`' || code.back() != '`') {
        throw std::runtime_error("the message of a row must stand in backquotes: " + code);
    }
    return code.substr(1, code.size() - 2);
}

/// "\n" and "\xff" as they stand in code.
std::string unescaped(const std::string& code) {
    std::string text;
    for (std::size_t i = 0; i < code.size(); ++i) {
        if (code.compare(i, 2, "\\n") == 0) {
            text += '\n';
            i += 1;
        } else if (code.compare(i, 2, "\\x") == 0) {
            text += static_cast<char>(std::stoi(code.substr(i + 2, 2), nullptr, 16));
            i += 3;
        } else {
            text += code[i];
        }
    }
    return text;
}

bool stands_before_world(const std::string& code) {
    static constexpr std::array kStatements{
        "Camera",   "Film",        "PixelFilter", "Sampler",         "SurfaceIntegrator",
        "Renderer", "Accelerator", "SearchPath",  "VolumeIntegrator"};
    const std::string word = code.substr(0, code.find(' '));
    return std::find(kStatements.begin(), kStatements.end(), word) != kStatements.end();
}

/// A scene of pbrt with a lamp and a ball.
std::string small_pbrt_scene(const std::string& options, const std::string& world) {
    return "Film \"rgb\" \"integer xresolution\" 4 \"integer yresolution\" 4\n" + options +
           "WorldBegin\nLightSource \"infinite\"\nShape \"sphere\"\n" + world;
}

/// What a cause asks for.
struct WrittenCause {
    std::string options, world, whole;
    std::vector<std::string> arguments;
    bool pbrt = false;  ///< the scene is one of pbrt

    void add(const std::string& words, const std::string& code, const TemporaryFolder& folder) {
        constexpr std::string_view kAnd = "and ", kHolding = " holding ";
        pbrt |= words.starts_with("pbrt");
        if (words.ends_with(kHolding)) {
            const auto begin = words.rfind(kAnd) + kAnd.size();
            folder.write(words.substr(begin, words.size() - kHolding.size() - begin),
                         unescaped(code));
        } else if (words == "the whole scene is ") {
            whole = unescaped(code);
        } else if (code.starts_with('-')) {
            std::istringstream text(code);
            arguments.insert(arguments.end(), std::istream_iterator<std::string>(text), {});
        } else if (words == "pbrt, the whole scene: ") {
            whole = unescaped(code);
        } else if (words == "before WorldBegin: " || words == "pbrt, before WorldBegin: " ||
                   (words != "after WorldBegin: " && stands_before_world(code))) {
            options += code + "\n";
        } else {
            world += code + "\n";
        }
    }
};

/// What main() of lxsrender does.
[[noreturn]] void act_as_lxsrender(const std::vector<std::string>& arguments) {
    std::vector<const char*> pointers;
    pointers.reserve(arguments.size());
    for (const std::string& argument : arguments)
        pointers.push_back(argument.c_str());
    CommandLine command;
    const auto done =
        parse_command_line(static_cast<int>(pointers.size()), pointers.data(), command);
    if (done) ::_exit(static_cast<int>(*done));
    ConsoleLog log(command.verbosity);
    ::_exit(static_cast<int>(carry_out(command, log)));
}

}  // namespace

std::string error_index() {
    return text_of(fs::path(ERROR_PAGES) / "index.md");
}

std::vector<ErrorRow> error_rows() {
    std::vector<ErrorRow> rows;
    for (const fs::path& path : pages_of_messages()) {
        std::istringstream page(text_of(path));
        for (std::string line; std::getline(page, line);) {
            if (!line.starts_with('|') || line == "| cause | message | code |" ||
                line == "| --- | --- | --- |")
                continue;
            const std::vector<std::string> cells = cells_of(line);
            if (cells.size() != 3)
                throw std::runtime_error("no row of three cells in " + path.string() + ": " + line);
            rows.push_back({cells[0], without_quotes(cells[1]), std::stoi(cells[2])});
        }
    }
    return rows;
}

RunResult run_forked(const TemporaryFolder& folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"lxsrender", "--plugin-path", PLUGINS});
    return LxsrenderProcess(folder, {}, "", [&] { act_as_lxsrender(arguments); }).wait();
}

RunResult run_written_cause(const std::string& cause, const TemporaryFolder& folder) {
    WrittenCause written;
    std::size_t at = 0;
    for (std::size_t begin; (begin = cause.find('`', at)) != std::string::npos;) {
        const std::size_t end = cause.find('`', begin + 1);
        const std::size_t words = cause.find_first_not_of(' ', at);
        written.add(cause.substr(words, begin - words), cause.substr(begin + 1, end - begin - 1),
                    folder);
        at = end + 1;
    }
    const std::string name = written.pbrt ? "scene.pbrt" : "scene.lxs";
    const auto usual = written.pbrt ? small_pbrt_scene : small_scene;
    folder.write(name,
                 written.whole.empty() ? usual(written.options, written.world) : written.whole);
    std::vector<std::string> arguments{name};
    const auto& given = written.arguments;
    if (std::find(given.begin(), given.end(), "--time") == given.end() &&
        std::find(given.begin(), given.end(), "--passes") == given.end()) {
        arguments.insert(arguments.end(), {"--passes", "1"});
    }
    arguments.insert(arguments.end(), given.begin(), given.end());
    return run_forked(folder, arguments);
}

RunResult render_with_vanishing_texture(const TemporaryFolder& folder) {
    constexpr int kWidth = 64, kHeight = 16384;
    const std::string path = folder / "t.tif";
    const auto out = OIIO::ImageOutput::create(path);
    const std::vector<unsigned char> pixels(std::size_t{3} * kWidth * kHeight, 100);
    OIIO::ImageSpec spec(kWidth, kHeight, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("compression", "none");
    if (!out->open(path, spec) || !out->write_image(OIIO::TypeDesc::UINT8, pixels.data()) ||
        !out->close()) {
        throw std::runtime_error("can't write the test's texture");
    }
    // Few lookups a pass: most tiles of the texture are read after the file is cut short.
    folder.write("scene.lxs",
                 small_scene("", "Texture \"t\" \"color\" \"imagemap\" \"string filename\" [\"" +
                                     std::string("t.tif") +
                                     "\"]\nMaterial \"matte\" \"texture Kd\" [\"t\"]\n"
                                     "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3]\n"
                                     "  \"point P\" [-2 -2 -2  2 -2 -2  2 -2 2  -2 -2 2]\n"
                                     "  \"float uv\" [0 0  1 0  1 1  0 1]"));
    return run_lxsrender(folder, {"scene.lxs", "--passes", "40", "--integrator", "saboteur",
                                  "--plugin-path", std::string(TEST_MODULES) + "/saboteur", "--set",
                                  "saboteur.deed=truncate", "--set", "saboteur.victim=t.tif"});
}

}  // namespace lxs::test
