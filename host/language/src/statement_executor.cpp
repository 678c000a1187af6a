// Statements of other readers, on their way to the scene reader.
#include "lxs/language/statement_executor.h"

#include "scene_reader.h"
#include "waiting_statements.h"

namespace lxs {

struct StatementExecutor::Parts {
    Parts(const std::string& directory, const Registry& registry, Diagnostics& diagnostics)
        : reader(directory.empty() ? "." : directory, registry, diagnostics),
          waiting([this](std::vector<Statement> them) { reader.execute_all(std::move(them)); }) {}

    SceneReader reader;
    WaitingStatements waiting;
};

StatementExecutor::StatementExecutor(const std::string& directory, const Registry& registry,
                                     Diagnostics& diagnostics)
    : parts_(std::make_unique<Parts>(directory, registry, diagnostics)) {}

StatementExecutor::~StatementExecutor() = default;

void StatementExecutor::add(Statement statement) {
    parts_->waiting.add(std::move(statement));
}

void StatementExecutor::guard(const std::function<void()>& translate) {
    parts_->reader.guard(translate);
}

std::shared_ptr<const SourceFile> StatementExecutor::open(const Name& file) {
    return parts_->reader.open(file);
}

void StatementExecutor::opened(const std::shared_ptr<const SourceFile>& file) {
    parts_->reader.opened(file);
}

std::string StatementExecutor::find(const Name& file) {
    return parts_->reader.find(file);
}

std::string StatementExecutor::find_quietly(const Name& file) {
    return parts_->reader.find_quietly(file);
}

ReadFiles StatementExecutor::take_files() {
    parts_->waiting.release();
    return parts_->reader.take_files();
}

SceneContents StatementExecutor::finish() {
    parts_->waiting.release();
    return parts_->reader.finish();
}

}  // namespace lxs
