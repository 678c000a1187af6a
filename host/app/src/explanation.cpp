// The transport statistics of a render as text.
#include "lxs/host/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace lxs {
namespace {

constexpr std::size_t kMostRows = 24;  ///< of a table; what brings most comes first

/// "1234", "12.3 thousand", "1.2 million": counts that are read, not reckoned with.
std::string amount(std::uint64_t count) {
    const auto number = static_cast<double>(count);
    if (count < 10'000) return fmt::to_string(count);
    if (number < 1e6) return fmt::format("{:.1f} thousand", number * 1e-3);
    return fmt::format("{:.1f} million", number * 1e-6);
}

std::string percent(double part, double whole) {
    return whole > 0 ? fmt::format("{:.1f} %", 100 * part / whole) : "-";
}

double energy_of(const LightStatistics& light) {
    return light.seen + light.photons;
}

/// The numbers 0 .. count - 1, those with most `weight` first.
std::vector<std::size_t> by_weight(std::size_t count, const auto& weight) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return weight(a) > weight(b); });
    return order;
}

/// What of the rows that a table has no room for, if there are such.
std::string rest_of(std::size_t rows, const char* things) {
    if (rows <= kMostRows) return {};
    return fmt::format("  and {} more {}, each with less\n", rows - kMostRows, things);
}

std::string light_table(const RenderSession& session, const TransportStatistics& transport) {
    const std::size_t count = session.scene->lights().size();
    std::vector<LightStatistics> lights(transport.lights);
    lights.resize(std::max(count, lights.size()));
    const double total = told_luminance(transport);
    std::string text = "lights:\n";
    const auto order = by_weight(count, [&](std::size_t i) {
        return std::pair(energy_of(lights[i]), lights[i].photon_paths);
    });
    for (std::size_t row = 0; row < std::min(count, kMostRows); ++row) {
        const LightStatistics& light = lights[order[row]];
        text += fmt::format("  {}: ", light_name(session, order[row]));
        if (light.photon_paths > 0) {
            const auto counted = static_cast<double>(light.counted_paths);
            text += fmt::format("{} photons, {} of them counted; ", amount(light.photon_paths),
                                percent(counted, static_cast<double>(light.photon_paths)));
        } else {
            text += "no photons; ";
        }
        text += total > 0 ? fmt::format("{} of the image, {} of it by photons\n",
                                        percent(energy_of(light), total),
                                        percent(light.photons, energy_of(light)))
                          : "its part of the image is not told\n";
    }
    return text + rest_of(count, "lights");
}

/// What became of most photons that met a material, and of the others.
std::string fates(const MaterialStatistics& material) {
    const auto all = static_cast<double>(material.hits);
    std::string text;
    const auto add = [&](std::uint64_t count, const char* what) {
        if (count == 0) return;
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                            percent(static_cast<double>(count), all), what);
    };
    add(material.taken, "taken");
    add(material.unseen, "not in view");
    add(material.direct, "left to shadow rays");
    add(material.passing, "only pass: mirror, glass or gloss takes none");
    add(material.black, "black");
    if (material.cut > 0) {
        text += fmt::format("; {} ended by the depth limit",
                            percent(static_cast<double>(material.cut), all));
    }
    return text;
}

std::string material_table(const RenderSession& session, const TransportStatistics& transport) {
    const auto names = session.scene->material_names();
    std::vector<MaterialStatistics> materials(transport.materials);
    materials.resize(names.size());
    std::string text = "materials:\n";
    const auto order = by_weight(names.size(), [&](std::size_t i) { return materials[i].hits; });
    for (std::size_t row = 0; row < std::min(names.size(), kMostRows); ++row) {
        const MaterialStatistics& material = materials[order[row]];
        const std::string& name = names[order[row]];
        const bool implied = session.implied_material == order[row];
        // A lamp's own shape has it as a rule, and nobody asks what became of photons there.
        if (implied && material.hits == 0) continue;
        text += fmt::format("  {}: ", implied        ? "shapes without a Material, matte"
                                      : name.empty() ? "without a name"
                                                     : in_quotes(name));
        text += material.hits > 0
                    ? fmt::format("met by {} photons: {}\n", amount(material.hits), fates(material))
                    : "met by no photon\n";
    }
    return text + rest_of(names.size(), "materials");
}

std::string media_list(const RenderSession& session) {
    const std::vector<std::string> notes = session.scene->media_notes();
    if (notes.empty()) return {};
    std::string text = "media:\n";
    for (const std::string& note : notes)
        text += fmt::format("  {}\n", note);
    return text;
}

std::string times(const RenderSession& session, const TransportStatistics& transport) {
    std::string text = "seconds:";
    for (const auto& [phase, seconds] : session.times)
        text += fmt::format(" {} {:.2f},", phase, seconds);
    text.back() = '\n';
    if (transport.seconds.empty()) return text;
    text += "of the render:";
    for (const auto& [stage, seconds] : transport.seconds)
        text += fmt::format(" {} {:.2f},", stage, seconds);
    text.back() = '\n';
    return text;
}

}  // namespace

std::string light_name(const RenderSession& session, std::size_t light) {
    const Light& of_scene = *session.scene->lights()[light];
    std::string name = fmt::format("light {} ({}", light, of_scene.kind());
    const auto places = session.scene->light_places();
    if (light < places.size() && places[light].file)
        name += fmt::format(", {}:{}", places[light].file->name, places[light].line);
    const auto groups = session.scene->light_groups();
    if (groups.size() > 1) name += fmt::format(", group {}", in_quotes(groups[of_scene.group()]));
    return name + ')';
}

double told_luminance(const TransportStatistics& transport) {
    double sum = 0;
    for (const LightStatistics& light : transport.lights)
        sum += energy_of(light);
    return sum;
}

std::uint64_t told_photon_paths(const TransportStatistics& transport) {
    std::uint64_t sum = 0;
    for (const LightStatistics& light : transport.lights)
        sum += light.photon_paths;
    return sum;
}

std::string explanation(const RenderSession& session, const TransportStatistics& transport) {
    std::string text = light_table(session, transport);
    if (told_photon_paths(transport) > 0) {
        text += material_table(session, transport);
    } else {
        text += fmt::format("photons: \"{}\" shot none\n", session.integrator_name);
    }
    text += media_list(session);
    for (const std::string& skipped : transport.skipped)
        text += fmt::format("left out {}\n", skipped);
    return text + times(session, transport);
}

std::string transport_line(const TransportStatistics& transport) {
    const std::uint64_t shot = told_photon_paths(transport);
    const double total = told_luminance(transport);
    if (shot == 0 || !(total > 0)) return {};
    double photons = 0;
    std::uint64_t counted = 0;
    for (const LightStatistics& light : transport.lights) {
        photons += light.photons;
        counted += light.counted_paths;
    }
    return fmt::format("photons brought {} of the image; of {} shot, {} came where the camera sees",
                       percent(photons, total), amount(shot),
                       percent(static_cast<double>(counted), static_cast<double>(shot)));
}

}  // namespace lxs
