// Long lists of numbers, read without the grammar.
#pragma once

#include <vector>

namespace lxs {

/// Appends the plain numbers that begin at `at`, blanks between them, to `values`. Stops before
/// `end`, a bracket, and all that needs the grammar: comments, words, numbers out of range and what
/// looks like no number. Returns where it stopped, behind the last number's blanks.
const char* read_number_run(const char* at, const char* end, std::vector<double>& values);

}  // namespace lxs
