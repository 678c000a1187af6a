// The host's checkpoint as an archive of the engine.
#pragma once

#include "aips/core/base/state_archive.h"
#include "lxs/sdk/state_archive.h"

namespace aips::shim {

/// Passes bytes on; what the host's archive throws goes through the engine to the host.
class StateShim final : public StateArchive {
  public:
    /// `archive` outlives it.
    explicit StateShim(lxs::StateArchive& archive) : archive_(archive) {}
    bool restoring() const override { return archive_.restoring(); }
    void bytes(std::span<std::byte> data) override { archive_.bytes(data); }
    std::size_t remaining() const override { return archive_.remaining(); }

  private:
    lxs::StateArchive& archive_;
};

}  // namespace aips::shim
