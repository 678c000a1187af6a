// Statements that have been parsed and wait to be carried out, so that files that several of them
// name can be read at the same time.
#pragma once

#include <functional>
#include <utility>
#include <variant>
#include <vector>

#include "lxs/language/statement.h"

namespace lxs {

class WaitingStatements {
  public:
    /// `carry_out` gets those that waited, in order.
    explicit WaitingStatements(std::function<void(std::vector<Statement>)> carry_out)
        : carry_out_(std::move(carry_out)) {}

    void add(Statement statement) {
        for (const Argument& argument : statement.arguments)
            values_ += std::visit([](const auto& v) { return v.size(); }, argument.values);
        waiting_.push_back(std::move(statement));
        if (waiting_.size() >= kMostStatements || values_ >= kMostValues) release();
    }
    void release() {
        values_ = 0;
        carry_out_(std::exchange(waiting_, {}));
    }

  private:
    static constexpr std::size_t kMostStatements = 1024;
    static constexpr std::size_t kMostValues = 1 << 16;  ///< 512 KiB of numbers

    std::function<void(std::vector<Statement>)> carry_out_;
    std::vector<Statement> waiting_;
    std::size_t values_ = 0;
};

}  // namespace lxs
