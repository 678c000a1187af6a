// The host's lights, materials and scenes keep the engine's contracts: validate_host() finds
// nothing in the scenes of scenes/.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>

#include "aips/adapter/host_validation.h"
#include "lxs/language/asset_finder.h"
#include "lxs/language/read_scene.h"
#include "lxs/tracing/trace_scene.h"
#include "scene_shim.h"

namespace checked_scenes_test {
namespace {

namespace fs = std::filesystem;

class Silent final : public lxs::Diagnostics {
  public:
    void warning(const lxs::SourceLocation&, const std::string&) override {}
    void unknown_parameter(const lxs::SourceLocation&, const std::string&) override {}
};

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(SCENES)) {
        if (entry.path().extension() == ".lxs") names.push_back(entry.path().stem());
    }
    std::ranges::sort(names);
    return names;
}

class CheckedScenes : public testing::TestWithParam<std::string> {};

TEST_P(CheckedScenes, AreSoundHosts) {
    const std::string path = std::string(SCENES) + "/" + GetParam() + ".lxs";
    Silent silent;
    lxs::Registry registry;
    lxs::register_shapes(registry);
    lxs::register_shading(registry);
    lxs::SceneContents contents = lxs::read_scene(path, registry, silent);
    lxs::AssetFinder finder(contents.directory);
    const auto scene = lxs::make_trace_scene(
        std::move(contents),
        [&](const std::string& name, const lxs::SourceLocation& where) {
            return finder.find(name, where, silent);
        },
        silent);
    const aips::shim::SceneShim shim(*scene);
    aips::HostValidationSettings settings;
    settings.samples = 2048;
    settings.places = 2;
    for (const aips::HostFinding& finding : aips::validate_host(shim, settings))
        ADD_FAILURE() << to_string(finding);
}

INSTANTIATE_TEST_SUITE_P(Folder, CheckedScenes, testing::ValuesIn(scene_names()),
                         [](const auto& scene) {
                             return std::regex_replace(scene.param, std::regex("-"), "_");
                         });

}  // namespace
}  // namespace checked_scenes_test
