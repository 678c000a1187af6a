// Fuzz target: meshes from PLY and STL files, with subdivision and displacement of what was read.
// The first bytes choose format and refinement, the rest is the file.
#include <cmath>
#include <cstdlib>

#include "fuzz_target.h"
#include "input_bytes.h"
#include "input_files.h"

namespace {

lxs::ParameterValue value(const std::string& type, const std::string& name, auto values) {
    return {type, name, std::move(values), fuzz::somewhere(), {}};
}

lxs::ParameterSet statement(fuzz::InputBytes& input) {
    const std::uint8_t flags = input.byte();
    lxs::ParameterSet set;
    set.plugin = flags & 1 ? "stlmesh" : "plymesh";
    set.where = fuzz::somewhere();
    using Strings = std::vector<std::string>;
    using Bools = std::vector<bool>;
    const bool micro = flags & 2;
    const std::size_t levels = input.below(4);
    set.values.push_back(value("string", "filename", Strings{"mesh"}));
    set.values.push_back(
        value("integer", "nsubdivlevels", std::vector<double>{static_cast<double>(levels)}));
    set.values.push_back(
        value("string", "subdivscheme", Strings{micro ? "microdisplacement" : "loop"}));
    set.values.push_back(value("bool", "dmnormalsplit", Bools{(flags & 4) != 0}));
    set.values.push_back(value("bool", "dmsharpboundary", Bools{(flags & 8) != 0}));
    set.values.push_back(value("bool", "dmnormalsmooth", Bools{(flags & 16) != 0}));
    set.values.push_back(value("bool", "discardmeshnormals", Bools{(flags & 32) != 0}));
    if (flags & 64) set.values.push_back(value("texture", "displacementmap", Strings{"map"}));
    if (!(flags & 1)) set.values.push_back(value("bool", "smooth", Bools{(flags & 128) != 0}));
    return set;
}

/// What the tracer relies on.
void check(const lxs::TriangleMesh& mesh) {
    const std::size_t count = mesh.positions.size();
    const auto fits = [&](std::size_t size) { return size == 0 || size == count; };
    if (!fits(mesh.normals.size()) || !fits(mesh.uvs.size()) || !fits(mesh.colors.size()) ||
        !fits(mesh.alphas.size()) || mesh.indices.size() % 3 != 0)
        std::abort();
    for (const std::uint32_t index : mesh.indices) {
        if (index >= count) std::abort();
    }
    for (const lxs::Vec3& p : mesh.positions) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::InputBytes input(data, size);
    const lxs::ParameterSet set = statement(input);
    fuzz::folder().write("mesh", std::string(input.rest()));
    const auto& factory = fuzz::registry().shapes.at(set.plugin);
    fuzz::SilentDiagnostics diagnostics;
    try {
        const lxs::ParameterReader reader(set, factory.parameters, diagnostics);
        const lxs::Geometry made = factory.create(reader, fuzz::FuzzAssets(), lxs::Matrix());
        check(std::get<lxs::TriangleMesh>(made));
    } catch (const lxs::InputError& refusal) {
        fuzz::check_refusal(refusal);
    }
    return 0;
}
