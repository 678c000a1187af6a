// Suggestions for misspelt names, by edit distance.
#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "lxs/sdk/diagnostics.h"

namespace lxs {
namespace {

constexpr std::size_t kLongestName = 64;  // longer ones are no misspelling of a known name
constexpr std::size_t kMostListed = 40;   // known names that a message tells

std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Optimal string alignment distance: insertions, deletions, substitutions and swaps of two
/// neighbouring characters cost 1 each. `bound` if it is no less: most names are far from most
/// others, which shows in the first characters. Names have at most kLongestName characters.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t bound) {
    const std::size_t difference = std::max(a.size(), b.size()) - std::min(a.size(), b.size());
    if (difference >= bound) return bound;
    std::array<std::array<std::size_t, kLongestName + 1>, 3> rows{};
    auto *row = &rows[0], *last = &rows[1], *before_last = &rows[2];
    for (std::size_t j = 0; j <= b.size(); ++j)
        (*row)[j] = j;
    std::size_t least = 0, least_of_last = 0;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(last, before_last);
        std::swap(row, last);
        (*row)[0] = i;
        least_of_last = std::exchange(least, i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substitution = (*last)[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            std::size_t distance = std::min({(*last)[j] + 1, (*row)[j - 1] + 1, substitution});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) distance = std::min(distance, (*before_last)[j - 2] + 1);
            (*row)[j] = distance;
            least = std::min(least, distance);
        }
        // A swap leads over one row.
        if (std::min(least, least_of_last + 1) >= bound) return bound;
    }
    return std::min((*row)[b.size()], bound);
}

/// "a, b, c", `first` before the others, if there is one; of many the first few and their number.
std::string listed(const std::string& first, const std::vector<std::string>& names) {
    std::string list = first;
    std::size_t count = first.empty() ? 0 : 1;
    for (const std::string& name : names) {
        if (count == kMostListed) break;
        if (name == first) continue;
        if (count > 0) list += ", ";
        list += name;
        ++count;
    }
    if (names.size() <= count) return list;
    return list + ", ... (" + std::to_string(names.size() - count) + " more)";
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
    if (name.empty() || name.size() > kLongestName) return {};
    const std::string wanted = lower_case(name);
    // A third of the letters may be wrong: "tonemappkernal" is near, "fog" and "box" are not.
    std::size_t best_distance = std::max<std::size_t>(1, name.size() / 3) + 1;
    std::string best;
    for (const std::string& candidate : known) {
        if (candidate.size() > kLongestName) continue;
        const std::size_t distance = edit_distance(wanted, lower_case(candidate), best_distance);
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

std::string unknown_name(std::string_view kind, std::string_view name) {
    return "unknown " + std::string(kind) + " " + in_quotes(name);
}

std::string unknown_name_message(std::string_view kind, const std::string& name,
                                 const std::vector<std::string>& known) {
    std::string message = unknown_name(kind, name);
    const std::string nearest = nearest_name(name, known);
    if (!nearest.empty()) message += "; did you mean \"" + nearest + "\"?";
    if (known.empty()) return message + "; none is known";
    message += nearest.empty() ? "; known: " : " Known: ";
    return message + listed(nearest, known);
}

}  // namespace lxs
