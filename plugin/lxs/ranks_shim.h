// The host's ranks in the engine's terms.
#pragma once

#include <utility>

#include "aips/adapter/ranks.h"
#include "lxs/sdk/ranks.h"

namespace aips::shim {

class RanksShim final : public Ranks {
  public:
    explicit RanksShim(lxs::Ranks& ranks) : ranks_(ranks) {}
    std::uint32_t rank() const override { return ranks_.rank(); }
    std::uint32_t count() const override { return ranks_.count(); }
    RankMessages exchange(std::span<const std::byte> own) override {
        lxs::RankMessages messages = ranks_.exchange(own);
        return {std::move(messages.bytes), std::move(messages.begins)};
    }

  private:
    lxs::Ranks& ranks_;
};

}  // namespace aips::shim
