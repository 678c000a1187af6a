// Fuzz target: the scene reader, from bytes to SceneContents, with everything that statements make
// on the way. A line "#file NAME" begins another file, which the scene may include or name as a
// mesh, table or lamp.
#include <array>

#include "fuzz_target.h"
#include "input_files.h"
#include "lxs/language/read_scene.h"

namespace {

constexpr std::array<std::string_view, 6> kNames = {"a.lxs", "b.lxs", "m.ply",
                                                    "m.stl", "l.ies", "t.nk"};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::read_with_files(data, size, kNames, [](const std::string& text, lxs::Diagnostics& to) {
        lxs::read_scene_text(text, "main.lxs", fuzz::folder().path().string(), fuzz::registry(),
                             to);
    });
    return 0;
}
