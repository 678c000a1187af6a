// Fuzz target: EXR files of others, read and merged with themselves under another seed; what begins
// with a brace is a statistics file, summed up twice likewise.
#include <cmath>
#include <cstdlib>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "fuzz_target.h"
#include "lxs/imaging/image_header.h"
#include "lxs/merge/merger.h"
#include "lxs/merge/statistics_sums.h"

namespace {

void sum_statistics(std::string_view text) {
    try {
        lxs::StatisticsSums sums;
        sums.add(text, "a.json", {1, 2, 3});
        const std::string merged =
            R"({"renders": )" +
            sums.merged().dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
            "}";
        lxs::StatisticsSums again;
        again.add(merged, "b.json", {1, 2, 3});
        (void)again.merged();
    } catch (const lxs::MergeRefusal& refusal) {
        if (std::string_view(refusal.what()).find(".json'") == std::string_view::npos) throw;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 0 && data[0] == '{') {
        sum_statistics({reinterpret_cast<const char*>(data), size});
        return 0;
    }
    try {
        lxs::ExrImage image = lxs::decode_exr(std::as_bytes(std::span(data, size)), "a.exr");
        lxs::Merger merger;
        merger.add(image, "a.exr");
        image.metadata[lxs::image_header::kSeed] = "18446744073709551615";
        merger.add(image, "b.exr");
        for (const auto& [channel, values] : merger.merged().channels) {
            for (const float value : values)
                if (std::isnan(value)) std::abort();
        }
        (void)merger.error();
    } catch (const std::runtime_error& refusal) {
        if (std::string_view(refusal.what()).find(".exr'") == std::string_view::npos) throw;
    }
    return 0;
}
