// Fuzz target: the reader of pbrt's format, from bytes to SceneContents, with everything that
// directives make on the way. A line "#file NAME" begins another file.
#include <array>

#include "fuzz_target.h"
#include "input_files.h"
#include "lxs/pbrt/read_pbrt.h"

namespace {

constexpr std::array<std::string_view, 4> kNames = {"a.pbrt", "b.pbrt", "m.ply", "s.spd"};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::read_with_files(data, size, kNames, [](const std::string& text, lxs::Diagnostics& to) {
        lxs::read_pbrt_text(text, "main.pbrt", fuzz::folder().path().string(), fuzz::registry(),
                            to);
    });
    return 0;
}
