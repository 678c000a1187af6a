// Fuzz target: the scene reader, from bytes to SceneContents, with everything that statements make
// on the way. A line "#file NAME" begins another file, which the scene may include or name as a
// mesh, table or lamp.
#include <array>
#include <utility>
#include <vector>

#include "fuzz_target.h"
#include "input_files.h"
#include "lxs/language/read_scene.h"

namespace {

constexpr std::array<std::string_view, 6> kNames = {"a.lxs", "b.lxs", "m.ply",
                                                    "m.stl", "l.ies", "t.nk"};

/// The main text, and the files behind it.
std::string take_files(std::string_view text, std::vector<std::string>& written) {
    constexpr std::string_view kMark = "\n#file ";
    std::size_t at = text.find(kMark);
    std::string main(text.substr(0, at));
    while (at != std::string_view::npos) {
        const std::size_t name = at + kMark.size();
        const std::size_t line_end = std::min(text.find('\n', name), text.size());
        const std::size_t next = text.find(kMark, line_end);
        const std::size_t begin = std::min(line_end + 1, text.size());
        for (const std::string_view known : kNames) {
            if (text.substr(name, line_end - name) != known) continue;
            const std::size_t end = std::min(next, text.size());
            written.push_back(fuzz::folder().write(
                std::string(known),
                std::string(text.substr(begin, end < begin ? 0 : end - begin))));
        }
        at = next;
    }
    return main;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::string> written;
    const std::string main =
        take_files({reinterpret_cast<const char*>(data), data ? size : 0}, written);
    fuzz::SilentDiagnostics diagnostics;
    try {
        lxs::read_scene_text(main, "main.lxs", fuzz::folder().path().string(), fuzz::registry(),
                             diagnostics);
    } catch (const lxs::InputError& refusal) {
        fuzz::check_refusal(refusal);
    }
    for (const std::string& file : written)
        std::filesystem::remove(file);
    return 0;
}
