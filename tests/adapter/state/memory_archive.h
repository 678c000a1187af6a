// State archives in memory.
#pragma once

#include <cstring>
#include <span>
#include <vector>

#include "aips/core/base/state_archive.h"

namespace mock {

using Bytes = std::vector<std::byte>;

/// Appends to a vector.
class Saving final : public aips::StateArchive {
  public:
    bool restoring() const override { return false; }
    void bytes(std::span<std::byte> data) override {
        // By pointers, which the library copies at once; iterators of spans byte by byte.
        saved_.insert(saved_.end(), data.data(), data.data() + data.size());
    }
    std::size_t remaining() const override { return 0; }
    const Bytes& saved() const { return saved_; }

  private:
    Bytes saved_;
};

/// Reads bytes that outlive it.
class Restoring final : public aips::StateArchive {
  public:
    explicit Restoring(std::span<const std::byte> saved) : left_(saved) {}
    bool restoring() const override { return true; }
    void bytes(std::span<std::byte> data) override {
        if (data.size() > left_.size()) throw aips::StateError("the saved state is cut short");
        if (!data.empty()) std::memcpy(data.data(), left_.data(), data.size());
        left_ = left_.subspan(data.size());
    }
    std::size_t remaining() const override { return left_.size(); }

  private:
    std::span<const std::byte> left_;
};

}  // namespace mock
