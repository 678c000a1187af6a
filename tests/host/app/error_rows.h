// The rows of the pages of docs/reference/errors, and what causes them.
#pragma once

#include <string>
#include <vector>

#include "lxsrender_process.h"

namespace lxs::test {

/// A row of a table of messages.
struct ErrorRow {
    std::string cause;    ///< words, or code in backquotes with words between
    std::string message;  ///< "..." stands for any text
    int exit_code = 0;    ///< 0: a warning
};

/// index.md, which lists the exit codes and explains the tables.
std::string error_index();
/// The rows of all other pages: every line of a table there is one, but for its head.
std::vector<ErrorRow> error_rows();

/// Does what lxsrender does with these arguments, in a process of its own but without a new
/// program: its libraries take longer to load than most scenes to fail.
RunResult run_forked(const TemporaryFolder& folder, std::vector<std::string> arguments);

/// Does what lxsrender does with a cause in code: `CODE` is a part of the scene (before WorldBegin
/// if it begins with a statement that stands there, or after the words "before WorldBegin:"), or
/// options if it begins with '-'; after "and NAME holding" it is the content of a file, after "the
/// whole scene is" all of the scene. Words that begin with "pbrt" speak of a scene of pbrt.
RunResult run_written_cause(const std::string& cause, const TemporaryFolder& folder);

/// A render whose image texture is cut short between two passes, before all of it has been read.
RunResult render_with_vanishing_texture(const TemporaryFolder& folder);

}  // namespace lxs::test
