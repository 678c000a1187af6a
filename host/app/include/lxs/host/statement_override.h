// `--width`, `--height`, `--sampler` and `--set` of a sampler: options that stand above the scene's
// own statements.
#pragma once

#include "lxs/host/command_line.h"
#include "lxs/scene/contents.h"
#include "lxs/sdk/log.h"

namespace lxs {

/// Changes the statements that `command` names. --width sets the Film's xresolution and, in
/// proportion, its yresolution (at least 1 pixel) unless --height gives it; a crop window keeps its
/// fractions. --sampler sets the Sampler's name; the scene's parameters of another sampler are
/// dropped. Overrides of another sampler than the chosen one are said to have no effect. Throws
/// InputError for a sampler's unknown parameter and for a value that does not read as its type.
void apply_statement_overrides(const CommandLine& command, SceneContents& contents, Log& log);

}  // namespace lxs
