// Carries out statements of the scene language that another reader has made: of a scene in another
// format. Their locations are those of that format's file, and so are those of all messages.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "lxs/language/arguments.h"
#include "lxs/language/read_files.h"
#include "lxs/language/statement.h"
#include "lxs/scene/contents.h"
#include "lxs/scene/registry.h"

namespace lxs {

class SceneReader;

class StatementExecutor {
  public:
    /// `directory`: where file names in the scene are looked up. All must outlive it.
    StatementExecutor(const std::string& directory, const Registry& registry,
                      Diagnostics& diagnostics);
    ~StatementExecutor();
    StatementExecutor(const StatementExecutor&) = delete;
    StatementExecutor& operator=(const StatementExecutor&) = delete;

    /// Statements are carried out in order, but later: when many wait, or at finish().
    void add(Statement statement);
    /// Runs `translate`, and reports its error or what it says to ignore as a statement's own.
    /// Throws EndOfReading after very many errors.
    void guard(const std::function<void()>& translate);
    /// The file that an Include names, counted among all that were read. Throws as the scene
    /// language's Include does.
    std::shared_ptr<const SourceFile> open(const Name& file);
    /// The main file, which whoever calls has read.
    void opened(const std::shared_ptr<const SourceFile>& file);
    /// Path of a file that a scene names. Throws InputError if there is none.
    std::string find(const Name& file);
    /// The same without messages; empty if there is none.
    std::string find_quietly(const Name& file);

    /// All files read so far, after what waits is carried out; forgets them.
    ReadFiles take_files();
    /// The scene, after its WorldEnd.
    SceneContents finish();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace lxs
