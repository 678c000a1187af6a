// Files that statements name, read on all threads before the statements are carried out one by one.
#pragma once

#include <any>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lxs/language/asset_finder.h"
#include "lxs/language/statement.h"
#include "lxs/scene/registry.h"

namespace lxs {

class FilesAhead {
  public:
    /// Both must outlive it.
    FilesAhead(const Registry& registry, AssetFinder& finder)
        : registry_(registry), finder_(finder) {}

    /// Reads the files of shapes and textures among these, several at a time. Says nothing: a file
    /// that is missing or can't be read is met again, and reported, by the statement that names it.
    void read(const std::vector<Statement>& statements);
    /// What was read of the file for `plugin`, once; empty if nothing was.
    std::any take(const std::string& plugin, const std::string& path);
    /// Drops what nobody took, as of statements in the wrong place.
    void forget() { read_.clear(); }

  private:
    using ReadFile = std::function<std::any(const std::string& path)>;
    struct Job {
        std::string plugin, path;
        const ReadFile* read;
        std::any result = {};
    };
    /// The reader of the plugin that the statement names, or null.
    const ReadFile* reader_of(const Statement& statement, const std::string& plugin) const;
    std::vector<Job> jobs_of(const std::vector<Statement>& statements) const;

    const Registry& registry_;
    AssetFinder& finder_;
    std::map<std::pair<std::string, std::string>, std::any> read_;  ///< by plugin and path
};

}  // namespace lxs
