// `--width` and `--sampler`: options that stand above the scene's own statements.
#pragma once

#include "lxs/host/command_line.h"
#include "lxs/scene/contents.h"

namespace lxs {

/// Changes the statements that `command` names. --width sets the Film's xresolution and, in
/// proportion, its yresolution (at least 1 pixel); a crop window keeps its fractions. --sampler
/// sets the Sampler's name; the scene's parameters of another sampler are dropped.
void apply_statement_overrides(const CommandLine& command, SceneContents& contents);

}  // namespace lxs
