// Ctrl-C, SIGTERM and SIGHUP during a render, and other requests to end it.
#pragma once

#include <string>
#include <string_view>

namespace lxs {

/// While one exists, the first SIGINT, SIGTERM or SIGHUP (unless that is ignored, as under nohup)
/// is noted and the second ends the process at once with exit code 130. Renders of one process at
/// the same time may each have one: a signal stops them all.
class Interruption {
  public:
    /// `signals` false: they are left to the program, and request() alone ends the render.
    explicit Interruption(bool signals = true);
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// By a signal, or by request().
    bool requested() const;
    /// Ends the render as a signal does, but this one alone. `who`: asks for it; a text that lasts.
    void request(std::string_view who);
    /// "stopped by Ctrl-C or a signal"; empty unless requested().
    std::string reason() const;

  private:
    bool signalled() const;

    bool signals_;
    std::string_view asked_by_;  ///< empty: nobody but signals
};

}  // namespace lxs
