// Renders a scene with one integrator and compares it with its reference.
#include "check_scene.h"

#include <fmt/format.h>

#include <exception>
#include <set>
#include <sstream>

namespace conformance {
namespace {

namespace fs = std::filesystem;

/// lxsrender's warnings in `said`, each once.
void collect_warnings(const std::string& said, std::set<std::string>& warnings) {
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);) {
        const auto at = line.find("warning: ");
        if (at != std::string::npos) warnings.insert(line.substr(at));
    }
}

}  // namespace

Row check_scene(const Scene& scene, const std::string& integrator, const CheckSettings& settings) {
    Row row;
    row.scene = scene.name;
    row.integrator = integrator;
    row.limit = scene.limit;
    const render::Folder folder;
    const std::string threads =
        settings.threads > 0 ? fmt::format("--threads {}", settings.threads) : "";
    std::set<std::string> warnings;
    const RenderPasses render = [&](std::size_t passes, std::size_t seed) {
        const fs::path output = folder.path() / "out.exr";
        collect_warnings(
            render::output_of(fmt::format("'{}' '{}' -o '{}' --integrator {} --passes {} --seed {} "
                                          "{} 2>&1",
                                          settings.renderer.string(), scene.file.string(),
                                          output.string(), integrator, passes, seed, threads)),
            warnings);
        return render::read_image(output);
    };
    try {
        const render::Image reference = render::read_image(scene.reference);
        const WithinLimits within = [&](const render::Image& image) {
            return is_below(compare(image, reference).luminance, scene.limit);
        };
        const SettledImage ours = render_settled(render, scene.limit, within, settings.budget);
        row.found = compare(ours.image, reference);
        row.noise = ours.noise;
        row.passes = ours.passes;
        row.seconds = ours.seconds;
        row.settled = ours.settled;
        row.refused = negatives(ours.image) + not_finite(ours.image);
        row.reference_negatives = negatives(reference);
        if (!settings.keep.empty()) {
            render::write_image(ours.image,
                                settings.keep / (scene.name + "." + integrator + ".exr"));
        }
    } catch (const std::exception& error) {
        row.failure = error.what();
    }
    row.warnings.assign(warnings.begin(), warnings.end());
    return row;
}

}  // namespace conformance
