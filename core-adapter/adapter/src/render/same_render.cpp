// The settings and sizes that a saved state depends on.
#include "render/same_render.h"

#include "aips/adapter/settings_table.h"

namespace aips {
namespace {

/// To be raised whenever the content of states changes.
constexpr std::uint32_t kStateVersion = 28;

void state_of_settings(StateArchive& archive, const Settings& settings) {
    const auto same = [&](const auto& value, const char* name) {
        if constexpr (std::is_same_v<decltype(value), const bool&>) {
            archive.same(std::uint8_t(value), name);
        } else {
            archive.same(value, name);
        }
    };
    for (const SettingRow& row : setting_rows())
        std::visit([&](auto member) { same(settings.*member, row.name.data()); }, row.member);
}

}  // namespace

void state_of_identity(StateArchive& archive, const Host& host, const Settings& settings,
                       std::uint32_t eye_paths) {
    archive.same(kStateVersion, "version of the engine");
    // Before the settings, of which some are off in media.
    archive.same(std::uint8_t(host.scene.media() != nullptr), "media");
    state_of_settings(archive, settings);
    archive.same(host.film.width(), "image size");
    archive.same(host.film.height(), "image size");
    archive.same(eye_paths, "eye paths");
    archive.same(host.scene.light_groups(), "light groups");
    archive.same(std::uint64_t{host.scene.lights().size()}, "lights");
    archive.same(std::uint64_t{host.scene.material_names().size()}, "materials");
}

void state_of_version(StateArchive& archive) {
    std::uint32_t version = kStateVersion;
    archive.value(version);
    if (version != kStateVersion)
        throw StateError("it was learned by another version of the engine");
}

}  // namespace aips
