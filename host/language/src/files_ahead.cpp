// Which files to read ahead, and the reading.
#include "files_ahead.h"

#include "no_messages.h"

#include <tbb/parallel_for.h>

#include <exception>
#include <set>
#include <variant>

namespace lxs {
namespace {

/// The argument, if it is one string.
const std::string* text_of(const Statement& statement, std::size_t index) {
    if (index >= statement.arguments.size()) return nullptr;
    const auto* texts = std::get_if<std::vector<std::string>>(&statement.arguments[index].values);
    return texts != nullptr && texts->size() == 1 ? &texts->front() : nullptr;
}

/// The index of the argument that names the plugin: `Shape "plymesh"`, `Texture "t" "color"
/// "imagemap"`. Other statements have none with files.
std::size_t plugin_argument(const Statement& statement) {
    if (statement.name == "Shape") return 0;
    return statement.name == "Texture" ? 2 : statement.arguments.size();
}

const std::string* file_name_of(const Statement& statement) {
    for (std::size_t i = plugin_argument(statement) + 1; i < statement.arguments.size(); ++i) {
        const std::string* const parameter = text_of(statement, i);
        if (parameter != nullptr && *parameter == "string filename")
            return text_of(statement, i + 1);
    }
    return nullptr;
}

template <class Product>
const auto* reader_in(const std::map<std::string, Factory<Product>>& factories,
                      const std::string& plugin) {
    const auto found = factories.find(plugin);
    const auto* reader = found == factories.end() ? nullptr : &found->second.read_file;
    return reader != nullptr && *reader ? reader : nullptr;
}

}  // namespace

const FilesAhead::ReadFile* FilesAhead::reader_of(const Statement& statement,
                                                  const std::string& plugin) const {
    if (statement.name == "Shape") return reader_in(registry_.shapes, plugin);
    const std::string* const type = text_of(statement, 1);
    if (type == nullptr) return nullptr;
    if (*type == "float") return reader_in(registry_.float_textures, plugin);
    return *type == "color" ? reader_in(registry_.color_textures, plugin) : nullptr;
}

std::vector<FilesAhead::Job> FilesAhead::jobs_of(const std::vector<Statement>& statements) const {
    NoMessages silent;
    std::vector<Job> jobs;
    std::set<std::pair<std::string, std::string>> known;
    for (const Statement& statement : statements) {
        const std::string* const plugin = text_of(statement, plugin_argument(statement));
        const std::string* const name = plugin != nullptr ? file_name_of(statement) : nullptr;
        const ReadFile* const read = name != nullptr ? reader_of(statement, *plugin) : nullptr;
        if (read == nullptr) continue;
        try {
            std::string path = finder_.find(*name, statement.where, silent);
            if (known.emplace(*plugin, path).second) jobs.push_back({*plugin, path, read});
        } catch (const InputError&) {
            continue;  // the statement says so in its turn
        }
    }
    return jobs;
}

void FilesAhead::read(const std::vector<Statement>& statements) {
    std::vector<Job> jobs = jobs_of(statements);
    if (jobs.size() < 2) return;
    tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
        try {
            jobs[i].result = (*jobs[i].read)(jobs[i].path);
        } catch (const std::exception&) {
            jobs[i].result.reset();  // the statement fails in its turn
        }
    });
    for (Job& job : jobs) {
        if (job.result.has_value()) read_[{job.plugin, job.path}] = std::move(job.result);
    }
}

std::any FilesAhead::take(const std::string& plugin, const std::string& path) {
    const auto found = read_.find({plugin, path});
    if (found == read_.end()) return {};
    std::any result = std::move(found->second);
    read_.erase(found);
    return result;
}

}  // namespace lxs
