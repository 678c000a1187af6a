// Ctrl-C, SIGTERM and SIGHUP during a render.
#pragma once

namespace lxs {

/// While one exists, the first SIGINT, SIGTERM or SIGHUP (unless that is ignored, as under nohup)
/// is noted and the second ends the process at once with exit code 130. Renders of one process at
/// the same time may each have one: a signal stops them all.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    bool requested() const;
};

}  // namespace lxs
