// Parts of what was learned: each has its name, what it must fit, and its bytes.
#include "aips/core/base/learned_parts.h"

#include <algorithm>

namespace aips {
namespace {

class SavedPart final : public StateArchive {
  public:
    explicit SavedPart(std::vector<std::byte>& content) : content_(content) {}
    bool restoring() const override { return false; }
    void bytes(std::span<std::byte> data) override {
        content_.insert(content_.end(), data.begin(), data.end());
    }
    std::size_t remaining() const override { return 0; }

  private:
    std::vector<std::byte>& content_;
};

class ReadPart final : public StateArchive {
  public:
    explicit ReadPart(std::span<const std::byte> content) : left_(content) {}
    bool restoring() const override { return true; }
    void bytes(std::span<std::byte> data) override {
        check(data.size() <= left_.size(), "a part of it ends too soon");
        std::copy_n(left_.begin(), data.size(), data.begin());
        left_ = left_.subspan(data.size());
    }
    std::size_t remaining() const override { return left_.size(); }

  private:
    std::span<const std::byte> left_;
};

}  // namespace

LearnedParts::LearnedParts(StateArchive& archive) : archive_(archive) {
    if (!restoring()) return;
    for (Part part; state_of_part(part), !part.name.empty(); part = {})
        parts_.push_back(std::move(part));
}

void LearnedParts::state_of_part(Part& part) {
    const std::size_t letters = archive_.count(part.name.size(), 1);
    StateArchive::check(letters <= kLongestName, "a part of it without a name");
    part.name.resize(letters);
    archive_.bytes(std::as_writable_bytes(std::span(part.name)));
    archive_.value(part.fit);
    archive_.values(part.content);
}

bool LearnedParts::part(std::string_view name, std::uint64_t fit, const Describe& describe) {
    if (!restoring()) {
        Part saved{std::string(name), fit, {}, true};
        SavedPart content(saved.content);
        describe(content);
        state_of_part(saved);
        return true;
    }
    const auto found = std::ranges::find_if(parts_, [&](const Part& part) {
        return part.name == name && part.fit == fit && !part.taken;
    });
    if (found == parts_.end()) return false;
    ReadPart content(found->content);
    describe(content);
    StateArchive::check(content.remaining() == 0, "a part of it goes on where it should end");
    found->taken = true;
    return true;
}

void LearnedParts::end() {
    Part none;
    if (!restoring()) state_of_part(none);
}

std::vector<std::string> LearnedParts::names(bool taken) const {
    std::vector<std::string> names;
    for (const Part& part : parts_) {
        if (part.taken == taken) names.push_back(part.name);
    }
    return names;
}

}  // namespace aips
