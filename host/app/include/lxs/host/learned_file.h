// What a render learned, kept in a file for others: the frames of an animation, mostly.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lxs/host/command_line.h"
#include "lxs/host/console_log.h"
#include "lxs/host/render_session.h"

namespace lxs {

/// Throws OutputFailure if nothing can be written where --learned-out says.
void check_learned_place(const CommandLine& command, ConsoleLog& log);

/// A whole file of what was learned; its bytes.
using LearnedFile = std::vector<std::byte>;

/// What --learned-in names, if it is given. Throws LearnedFailure if there is no such file, or if
/// it is damaged or of another version.
std::optional<LearnedFile> read_learned(const CommandLine& command);

/// Gives the integrator, which is prepared, what was learned. Throws LearnedFailure if that was
/// another integrator, or another version of it.
void take_learned(const LearnedFile& file, const CommandLine& command, RenderSession& session,
                  ConsoleLog& log);

/// Before the first pass: throws LearnedFailure if the integrator has nothing for --learned-out.
void check_learns(const CommandLine& command, RenderSession& session);

/// Writes what --learned-out asks for. False, and an error, if it can't be written.
bool write_learned(const CommandLine& command, RenderSession& session, ConsoleLog& log);

}  // namespace lxs
