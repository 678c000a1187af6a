// What statements take: names, numbers, parameters. Checks a parsed statement and hands them out.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lxs/language/statement.h"

namespace lxs {

/// A name and where it stands.
struct Name {
    std::string text;
    SourceLocation where;
};

/// Throws InputError unless the statement stands alone.
void expect_no_arguments(const Statement& statement);

/// The only argument, `count` numbers with or without brackets. Throws InputError.
std::vector<double> take_numbers(const Statement& statement, std::size_t count);

/// The only argument, a list of any number of numbers. Throws InputError.
std::vector<double> take_number_list(const Statement& statement);

/// Argument number `index`, one string. Throws InputError.
Name take_name(const Statement& statement, std::size_t index);

/// The only argument, one string. Throws InputError.
Name take_only_name(const Statement& statement);

/// The arguments from `first` on as `"type name" value` pairs; moves the values out of the
/// statement. `plugin` is whose parameters they are. Throws InputError.
ParameterSet take_parameters(Statement& statement, std::size_t first, const Name& plugin);

/// Statement that takes a plugin name and parameters: `Camera "perspective" ...`.
ParameterSet take_plugin(Statement& statement);

}  // namespace lxs
