// A folder of files that the inputs of fuzz targets name, and what else targets share of a host.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lxs/scene/registry.h"
#include "temporary_folder.h"

namespace fuzz {

/// Checks warnings and throws them away.
class SilentDiagnostics final : public lxs::Diagnostics {
  public:
    void warning(const lxs::SourceLocation& where, const std::string& message) override;
    void unknown_parameter(const lxs::SourceLocation& where, const std::string& message) override;
    void fallback(const lxs::SourceLocation& where, const std::string& message,
                  const std::string& instead) override;
    void error(const lxs::InputError& error) override;
};

/// All shapes, textures, materials and media; made once.
const lxs::Registry& registry();

/// A folder of this process; removed at its end. Small good files of each kind lie in it: mesh.ply,
/// mesh.stl, lamp.ies, metal.nk, light.spd, image.png.
const files::TemporaryFolder& folder();

/// The text before the first line "#file NAME"; what is behind such a line is written to folder(),
/// if the name is one of `names`, and its path added to `written`.
std::string take_files(std::string_view text, std::span<const std::string_view> names,
                       std::vector<std::string>& written);

/// Runs `read` on the main file of an input whose other files, of `names`, lie in folder()
/// meanwhile; checks what it refuses.
void read_with_files(const std::uint8_t* data, std::size_t size,
                     std::span<const std::string_view> names,
                     const std::function<void(const std::string&, lxs::Diagnostics&)>& read);

/// Named textures and materials are constants, whatever their name; files are those of folder().
class FuzzAssets final : public lxs::AssetContext {
  public:
    std::string resolve(const std::string& name, const lxs::SourceLocation& where) const override;
    std::shared_ptr<const lxs::FloatTexture> float_texture(
        const std::string& name, const lxs::SourceLocation& where) const override;
    std::shared_ptr<const lxs::ColorTexture> color_texture(
        const std::string& name, const lxs::SourceLocation& where) const override;
    std::shared_ptr<const lxs::FresnelTexture> fresnel_texture(
        const std::string& name, const lxs::SourceLocation& where) const override;
    std::shared_ptr<const lxs::Material> material(const std::string& name,
                                                  const lxs::SourceLocation& where) const override;
};

/// Where made-up parameters stand.
lxs::SourceLocation somewhere();

/// Ends the process unless the message says something, is short, and holds no control characters.
void check_message(std::string_view message);
void check_refusal(const std::exception& refusal);

}  // namespace fuzz
