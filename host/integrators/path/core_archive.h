// A checkpoint of the host as an archive of core, for tables that `path` shares with the engine.
#pragma once

#include "aips/core/base/state_archive.h"
#include "lxs/sdk/state_archive.h"

namespace lxs {

/// Passes bytes on.
class CoreArchive final : public aips::StateArchive {
  public:
    /// `archive` outlives it.
    explicit CoreArchive(lxs::StateArchive& archive) : archive_(archive) {}
    bool restoring() const override { return archive_.restoring(); }
    void bytes(std::span<std::byte> data) override { archive_.bytes(data); }
    std::size_t remaining() const override { return archive_.remaining(); }

  private:
    lxs::StateArchive& archive_;
};

}  // namespace lxs
