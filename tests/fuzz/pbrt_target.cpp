// Fuzz target: the reader of pbrt's format, from bytes to SceneContents, with everything that
// directives make on the way. A line "#file NAME" begins another file.
#include <array>
#include <vector>

#include "fuzz_target.h"
#include "input_files.h"
#include "lxs/pbrt/read_pbrt.h"

namespace {

constexpr std::array<std::string_view, 4> kNames = {"a.pbrt", "b.pbrt", "m.ply", "s.spd"};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::string> written;
    const std::string main =
        fuzz::take_files({reinterpret_cast<const char*>(data), data ? size : 0}, kNames, written);
    fuzz::SilentDiagnostics diagnostics;
    try {
        lxs::read_pbrt_text(main, "main.pbrt", fuzz::folder().path().string(), fuzz::registry(),
                            diagnostics);
    } catch (const lxs::InputError& refusal) {
        fuzz::check_refusal(refusal);
    }
    for (const std::string& file : written)
        std::filesystem::remove(file);
    return 0;
}
