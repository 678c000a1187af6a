// A scene that a program renders as lxsrender does, and whose image it takes from memory.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "lxs/host/console_log.h"
#include "lxs/host/progress.h"
#include "lxs/host/render_session.h"
#include "lxs/imaging/file_layers.h"

namespace lxs {

/// Bad input: what() is all errors as lxsrender prints them.
class Refusal : public std::runtime_error {
  public:
    explicit Refusal(const std::string& text) : std::runtime_error(text), message(text) {}
    Refusal(const std::string& text, const InputError& first);

    std::string file;  ///< of the first error; empty if it is in no file
    std::uint32_t line = 0, column = 0;
    std::string message;  ///< of the first error, without its place
};

/// What a render has after some passes.
struct RenderedImage {
    RenderTotals totals;
    std::optional<double> error;  ///< ErrorEstimate::relative()
    bool stopped = false;         ///< before its budget was used up
    FileLayers layers;
    std::vector<std::uint8_t> shown;  ///< 8 bits of red, green and blue per pixel
    std::string statistics;           ///< as statistics_json() has it
};

/// Ends when any of these is reached, counted from the first pass of all; as lxsrender if none is
/// given.
struct Ending {
    std::optional<std::uint64_t> passes;
    std::optional<double> seconds;
    std::optional<double> error;
};

/// Any thread may call; one waits for another, until its pass ends.
class Render {
  public:
    /// Called after each pass by the thread that renders; false ends the render.
    using OnPass = std::function<bool(const RenderTotals&)>;

    /// Reads the scene. Throws Refusal, PluginFailure. `sink` does not get what a Refusal says.
    Render(CommandLine command, MessageSink sink);

    /// Goes on until `ending`. Throws Refusal, PluginFailure. False, and nothing is done, while it
    /// runs or after it has thrown.
    bool run(const Ending& ending, const OnPass& on_pass);
    /// Linear radiance so far, row by row.
    std::vector<Rgb> image() const;
    std::uint32_t width() const { return session_->film->width(); }
    std::uint32_t height() const { return session_->film->height(); }
    RenderTotals totals() const;
    /// ErrorEstimate::relative() of the image so far. Takes some 0.1 us a pixel.
    std::optional<double> error() const;
    /// What the passes so far have given, of which there is one at least.
    RenderedImage result();

  private:
    enum class State : std::uint8_t { Loaded, Prepared, Running, Failed };

    void read();
    void render(bool prepared, const OnPass& on_pass, std::unique_lock<std::mutex>& lock);

    PluginLibrary plugins_;
    CommandLine command_;
    MessageSink sink_;
    std::vector<std::string> errors_;  ///< of the scene, while it is read
    ConsoleLog log_;
    std::optional<RenderSession> session_;
    mutable std::mutex mutex_;  ///< free while OnPass is called
    State state_ = State::Loaded;
    RenderTotals totals_;
    bool stopped_ = false;
};

}  // namespace lxs
