// A registry of recording fakes and a collector of warnings, for tests of the scene reader.
#pragma once

#include <string>
#include <vector>

#include "lxs/language/read_scene.h"

namespace lxs::test {

/// Keeps the first line of each warning.
class CollectingDiagnostics : public Diagnostics {
  public:
    void warning(const SourceLocation& where, const std::string& message) override;
    void unknown_parameter(const SourceLocation& where, const std::string& message) override;
    std::vector<std::string> messages;
};

/// The same, and goes on where LuxRender does, and after errors.
class LenientDiagnostics final : public CollectingDiagnostics {
  public:
    void fallback(const SourceLocation& where, const std::string& message,
                  const std::string& instead) override {
        warning(where, message + "; " + instead);
    }
    void error(const InputError& error) override;
};

/// A material that remembers how it was asked for.
class FakeMaterial final : public Material {
  public:
    FakeMaterial(std::string plugin, const Rgb& kd) : plugin_(std::move(plugin)), kd_(kd) {}
    const Bsdf* scatter(const ShadingPoint&, std::pmr::memory_resource&) const override {
        return nullptr;
    }
    MaterialFacts facts() const override { return {}; }
    const std::string& plugin() const { return plugin_; }
    const Rgb& kd() const { return kd_; }

  private:
    std::string plugin_;
    Rgb kd_;
};

/// Shapes sphere (radius) and trianglemesh (P, indices), materials matte (Kd) and mix, volume
/// clear, textures constant and imagemap, all fakes with the declared parameters of the real ones.
Registry fake_registry();

/// Factories without declared parameters for every name of LuxRender.
Registry accepting_registry();

const FakeMaterial& fake(const Primitive& primitive);

/// Reads `world` between WorldBegin and WorldEnd (on a line of their own), as scene "test.lxs".
SceneContents read_world(const std::string& world, CollectingDiagnostics& diagnostics);
SceneContents read_world(const std::string& world);
/// The same for a whole scene.
SceneContents read_text(const std::string& text, CollectingDiagnostics& diagnostics);

/// The error's whole text; empty if the scene is accepted.
std::string error_of_text(const std::string& text);
/// First line of the error of `world`.
std::string error_of_world(const std::string& world);

/// The first line of a text.
std::string first_line(const std::string& text);

}  // namespace lxs::test
