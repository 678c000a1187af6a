// A film's state in memory.
#pragma once

#include <cstring>
#include <span>
#include <vector>

#include "lxs/sdk/state_archive.h"

namespace lxs::test {

/// Keeps what is saved, and restores it.
class MemoryArchive final : public StateArchive {
  public:
    bool restoring() const override { return restoring_; }
    void bytes(std::span<std::byte> data) override {
        if (!restoring_) {
            bytes_.insert(bytes_.end(), data.begin(), data.end());
            return;
        }
        if (data.size() > remaining()) throw StateError("ends too soon");
        std::memcpy(data.data(), bytes_.data() + used_, data.size());
        used_ += data.size();
    }
    std::size_t remaining() const override { return restoring_ ? bytes_.size() - used_ : 0; }

    void restore() { restoring_ = true, used_ = 0; }
    std::vector<std::byte>& content() { return bytes_; }

  private:
    std::vector<std::byte> bytes_;
    std::size_t used_ = 0;
    bool restoring_ = false;
};

}  // namespace lxs::test
