// Fuzz target: the scene reader, from bytes to SceneContents, with everything that statements make
// on the way. A line "#file NAME" begins another file, which the scene may include or name as a
// mesh, table or lamp.
#include <array>
#include <vector>

#include "fuzz_target.h"
#include "input_files.h"
#include "lxs/language/read_scene.h"

namespace {

constexpr std::array<std::string_view, 6> kNames = {"a.lxs", "b.lxs", "m.ply",
                                                    "m.stl", "l.ies", "t.nk"};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::string> written;
    const std::string main =
        fuzz::take_files({reinterpret_cast<const char*>(data), data ? size : 0}, kNames, written);
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
