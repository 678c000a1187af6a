// Failures that end lxsrender with an exit code of their own. Bad input is an InputError.
#pragma once

#include <stdexcept>

namespace lxs {

/// A plugin module that can't be loaded or does not keep its contract.
class PluginFailure : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// An output that can't be written.
class OutputFailure : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A checkpoint that can't be made or gone on from, or that must not be replaced.
class CheckpointFailure : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A file of what was learned that can't be used.
class LearnedFailure : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A scene that an integrator can't render, with nothing in a file to point at.
class SceneFailure : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace lxs
