// Renders of scenes with something wrong in them.
#include "stressed_scene.h"

#include <cmath>
#include <iterator>
#include <numeric>
#include <sstream>

#include "lxsrender_process.h"

namespace stress {
namespace {

RenderWay aips(const std::string& guide, const std::string& mode) {
    return {"aips, guide " + guide + ", " + mode,
            "--integrator aips --set aips.photonperpass=3000 --set aips.guide=" + guide +
                " --set aips.mode=" + mode};
}

std::vector<std::string> words(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

}  // namespace

const std::vector<RenderWay>& main_ways() {
    static const std::vector<RenderWay> ways{
        aips("adaptive", "progressive"),
        {"sppm", "--integrator sppm --set sppm.photonperpass=3000"},
        {"path", "--integrator path"},
        {"Metropolis", "--integrator path --sampler metropolis"}};
    return ways;
}

RenderWay strict_way() {
    RenderWay way = main_ways().front();
    way.arguments += " --strict";
    return way;
}

const std::vector<RenderWay>& all_ways() {
    static const std::vector<RenderWay> ways = [] {
        std::vector<RenderWay> all = main_ways();
        all.push_back(aips("none", "progressive"));
        all.push_back(aips("paper", "progressive"));
        all.push_back(aips("adaptive", "photonmap"));
        all.push_back(aips("paper", "ppm"));
        return all;
    }();
    return ways;
}

std::size_t Outcome::bad_pixels() const {
    std::size_t bad = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        bool good = true;
        for (std::size_t c = 0; c < 3; ++c)
            good &= std::isfinite(image.rgb[i + c]) && image.rgb[i + c] >= 0;
        bad += good ? 0 : 1;
    }
    return bad;
}

double Outcome::mean() const {
    const auto values = image.luminance();
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

std::uint64_t Outcome::refused(const std::string& kind, const std::string& origin) const {
    const auto& all = statistics.at("refused");
    return all.contains(kind) ? all.at(kind).value(origin, std::uint64_t{0}) : 0;
}

std::vector<std::string> Outcome::origins(const std::string& kind) const {
    std::vector<std::string> names;
    const auto& all = statistics.at("refused");
    if (!all.contains(kind)) return names;
    for (const auto& item : all.at(kind).items())
        names.push_back(item.key());
    return names;
}

std::string quad(const std::string& corners) {
    return "Shape \"trianglemesh\" \"integer triindices\" [0 1 2 0 2 3] \"point P\" [" + corners +
           "]\n";
}

std::string room(const std::string& world, bool lit) {
    std::string text =
        "LookAt 0 -1.9 0  0 0 0  0 0 1\n"
        "Camera \"perspective\" \"float fov\" [80]\n"
        "Film \"fleximage\" \"integer xresolution\" [16] \"integer yresolution\" [12]\n"
        "PixelFilter \"box\" \"float xwidth\" [0.5] \"float ywidth\" [0.5]\n"
        "WorldBegin\n"
        "MakeNamedMaterial \"wall\" \"string type\" [\"matte\"] \"color Kd\" [0.5 0.5 0.5]\n"
        "NamedMaterial \"wall\"\n" +
        quad("-2 -2 -2  2 -2 -2  2 2 -2  -2 2 -2") + quad("-2 -2 2  -2 2 2  2 2 2  2 -2 2") +
        quad("-2 2 -2  2 2 -2  2 2 2  -2 2 2") + quad("-2 -2 -2  -2 2 -2  -2 2 2  -2 -2 2") +
        quad("2 -2 -2  2 -2 2  2 2 2  2 2 -2") + quad("-2 -2 -2  -2 -2 2  2 -2 2  2 -2 -2");
    if (lit) {
        text +=
            "AttributeBegin\nAreaLightSource \"area\" \"color L\" [3 3 3] \"float power\" [0] "
            "\"float efficacy\" [0]\n" +
            quad("-1 -1 1.9  -1 1 1.9  1 1 1.9  1 -1 1.9") + "AttributeEnd\n";
    }
    return text + world + "WorldEnd\n";
}

Outcome render_scene(const std::string& scene, const RenderWay& way, const render::Folder& folder,
                     int passes) {
    folder.write("scene.lxs", scene);
    std::vector<std::string> arguments{
        "scene.lxs", "-o", "out.exr", "--stats", "stats.json", "--passes", std::to_string(passes)};
    for (const std::string& word : words(way.arguments))
        arguments.push_back(word);
    const auto run = lxs::test::run_lxsrender(folder, arguments);
    Outcome outcome{run.exit_code, run.err, {}, {}};
    if (run.exit_code != 0) return outcome;
    outcome.image = render::read_image(folder.path() / "out.exr");
    outcome.statistics = nlohmann::json::parse(folder.read("stats.json"));
    return outcome;
}

}  // namespace stress
