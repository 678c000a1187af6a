// Can this build run a method, with these overrides, to the letter?
#include "method_check.h"

#include <fmt/format.h>
#include <unistd.h>

#include <span>
#include <string_view>
#include <system_error>

#include "lxs/host/render_session.h"
#include "lxs/imaging/atomic_file.h"
#include "study_file.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBall = R"(Film "fleximage" "integer xresolution" [4]
  "integer yresolution" [4]
Camera "perspective"
WorldBegin
LightSource "point"
Shape "sphere"
WorldEnd
)";

/// Whatever a run would only warn of is an error here.
class WarningsAreErrors : public lxs::InputDiagnostics {
  public:
    explicit WarningsAreErrors(lxs::ConsoleLog& log) : InputDiagnostics(log, true) {}
    void error(const lxs::InputError& error) override { throw lxs::InputError(error); }
    void warning(const lxs::SourceLocation& where, const std::string& message) override {
        throw lxs::InputError(where, message);
    }
};

/// The ball's scene file, gone with the object.
class BallScene {
  public:
    explicit BallScene(const fs::path& folder)
        : file_(folder / fmt::format("method-check-{}.lxs", ::getpid())) {
        make_folder(folder);
        lxs::write_file_atomically(file_.string(), std::as_bytes(std::span(kBall)));
    }
    ~BallScene() {
        std::error_code ignored;
        fs::remove(file_, ignored);
    }
    BallScene(const BallScene&) = delete;
    BallScene& operator=(const BallScene&) = delete;
    std::string file() const { return file_.string(); }

  private:
    fs::path file_;
};

}  // namespace

void check_method(const Method& method, const std::vector<std::string>& overrides,
                  const lxs::PluginLibrary& plugins, const fs::path& folder, lxs::ConsoleLog& log) {
    const BallScene scene(folder);
    lxs::CommandLine command;
    command.scene = scene.file();
    command.output = (folder / "method-check.exr").string();
    command.integrator = method.integrator;
    command.overrides = overrides;
    if (!method.sampler.empty()) command.sampler = method.sampler;
    WarningsAreErrors diagnostics(log);
    try {
        lxs::prepare_session(command, plugins, diagnostics, log);
    } catch (const lxs::InputError& error) {
        throw StudyError(
            fmt::format("method \"{}\" can't be run by this build: {}", method.name, error.what()));
    }
}

void check_overrides(const std::vector<std::string>& overrides, const lxs::PluginLibrary& plugins) {
    for (const std::string& text : overrides) {
        const std::string plugin = text.substr(0, text.find('.'));
        if (plugins.find(plugin) == nullptr) {
            throw StudyError(
                fmt::format("--set {}: {}", text,
                            lxs::unknown_name_message("integrator", plugin, plugins.names())));
        }
    }
}

}  // namespace bench
