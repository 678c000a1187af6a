// What is said of names that nothing in a scene has.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lxs/sdk/diagnostics.h"

namespace lxs {

/// Words messages about unknown names. Those of one kind are told as one, by the first of them
/// (InputDiagnostics): a few are worded in full, with what is near among perhaps thousands of known
/// names, the others by the name alone.
class UnknownNames {
  public:
    /// unknown_name_message(), or its beginning; `known` gives the known names.
    template <class Known>
    std::string message(const std::string& kind, const std::string& name, const Known& known) {
        constexpr int kInFull = 8;
        int& count = counts_[kind];
        if (count >= kInFull) return unknown_name(kind, name);
        ++count;
        return unknown_name_message(kind, name, known());
    }

  private:
    std::map<std::string, int> counts_;
};

/// Names of a map's entries, in its order.
template <class Map>
std::vector<std::string> names_of(const Map& map) {
    std::vector<std::string> names;
    names.reserve(map.size());
    for (const auto& [name, thing] : map)
        names.push_back(name);
    return names;
}

}  // namespace lxs
