// Fuzz target: files of optical constants (Sopra, LuxPop, tables of n and k) and of sampled
// spectra. The first byte chooses the texture, the rest is the file.
#include <cstdlib>

#include "fuzz_target.h"
#include "input_bytes.h"
#include "input_files.h"

namespace {

template <class Factory>
auto make(const Factory& factory, const std::string& plugin) {
    lxs::ParameterSet set;
    set.plugin = plugin;
    set.where = fuzz::somewhere();
    set.values.push_back(
        {"string", "filename", std::vector<std::string>{"table"}, fuzz::somewhere(), {}});
    fuzz::SilentDiagnostics diagnostics;
    const lxs::ParameterReader reader(set, factory.parameters, diagnostics);
    return factory.create(reader, fuzz::FuzzAssets(), lxs::Matrix());
}

/// "preset" tells the formats of optical constants apart by itself.
void read_table(std::size_t kind) {
    const lxs::Registry& all = fuzz::registry();
    if (kind == 0) {
        make(all.color_textures.at("tabulateddata"), "tabulateddata")->evaluate({});
    } else {
        const char* plugin = kind == 1 ? "preset" : kind == 2 ? "sopra" : "luxpop";
        make(all.fresnel_textures.at(plugin), plugin)->evaluate({});
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::InputBytes input(data, size);
    const std::size_t kind = input.below(4);
    fuzz::folder().write("table", std::string(input.rest()));
    try {
        read_table(kind);
    } catch (const lxs::InputError& refusal) {
        fuzz::check_refusal(refusal);
    }
    return 0;
}
