// Fuzz target: photometric files of lamps (IES), and the intensities looked up in them.
#include <cmath>
#include <cstdlib>

#include "fuzz_target.h"
#include "input_files.h"
#include "photometric_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), data ? size : 0);
    try {
        const lxs::PhotometricWeb web =
            lxs::parse_photometric_text(text, "lamp.ies", fuzz::somewhere());
        const double largest = web.largest();
        for (const double vertical : {0.0, 33.3, 90.0, 180.0}) {
            for (const double horizontal : {-170.0, 0.0, 91.0, 359.0}) {
                const double candela = web.intensity(vertical, horizontal);
                if (!(candela >= 0 && candela <= largest * (1 + 1e-6))) std::abort();
            }
        }
        if (!std::isfinite(largest)) std::abort();
    } catch (const lxs::InputError& refusal) {
        fuzz::check_refusal(refusal);
    }
    return 0;
}
