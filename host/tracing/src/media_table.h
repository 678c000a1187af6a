// The media of a scene by number, as rays carry them (EnteredMedia).
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "lxs/scene/contents.h"

namespace lxs {

class MediaTable {
  public:
    /// Of the media that surfaces, lights or the camera of `contents` stand in. Throws InputError
    /// if there are more than numbers.
    explicit MediaTable(const SceneContents& contents);

    /// kNoMedium for null.
    MediumNumber number_of(const Medium* medium) const {
        return medium ? numbers_.at(medium) : kNoMedium;
    }
    bool contains(const Medium* medium) const { return numbers_.count(medium) != 0; }
    /// Null for kNoMedium.
    const Medium* medium(MediumNumber number) const { return media_[number]; }
    /// As the scene calls it.
    const std::string& name(MediumNumber number) const { return names_[number]; }
    bool empty() const { return numbers_.empty(); }
    /// Of numbers, kNoMedium among them.
    std::size_t size() const { return media_.size(); }

  private:
    void add(const std::shared_ptr<const Medium>& medium, const SceneContents& contents);

    std::vector<const Medium*> media_ = {nullptr};
    std::vector<std::string> names_ = {""};
    std::unordered_map<const Medium*, MediumNumber> numbers_;
};

}  // namespace lxs
