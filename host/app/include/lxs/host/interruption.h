// Ctrl-C and SIGTERM during a render.
#pragma once

namespace lxs {

/// While one exists, the first SIGINT or SIGTERM is noted and the second ends the process at once
/// with exit code 130. At most one may exist at a time.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    bool requested() const;
};

}  // namespace lxs
