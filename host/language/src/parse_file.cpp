// Connects the grammar to the statement builder.
#include "lxs/language/parse_file.h"

#include "grammar.h"
#include "statement_builder.h"

namespace lxs {
namespace {

namespace peg = tao::pegtl;

template <class Rule>
struct Action : peg::nothing<Rule> {};

template <>
struct Action<grammar::Word> {
    template <class Input>
    static void apply(const Input& in, StatementBuilder& builder) {
        builder.begin_statement(in.begin(), in.string_view());
    }
};

template <>
struct Action<grammar::StatementText> {
    static void apply0(StatementBuilder& builder) { builder.end_statement(); }
};

template <>
struct Action<grammar::ListBegin> {
    template <class Input>
    static void apply(const Input& in, StatementBuilder& builder) {
        builder.begin_list(in.begin());
    }
};

template <>
struct Action<grammar::ListEnd> {
    static void apply0(StatementBuilder& builder) { builder.end_list(); }
};

template <>
struct Action<grammar::FiniteNumber> {
    template <class Input>
    static void apply(const Input& in, StatementBuilder& builder) {
        builder.add_number(in.begin(), in.string_view());
    }
};

template <>
struct Action<grammar::NotFinite> {
    template <class Input>
    static void apply(const Input& in, StatementBuilder& builder) {
        builder.add_not_finite(in.begin());
    }
};

template <>
struct Action<grammar::StringBegin> {
    template <class Input>
    static void apply(const Input& in, StatementBuilder& builder) {
        builder.begin_string(in.begin());
    }
};

template <>
struct Action<grammar::StringText> {
    template <class Input>
    static void apply(const Input& in, StatementBuilder& builder) {
        builder.add_string(in.string_view());
    }
};

template <>
struct Action<grammar::Bool> {
    template <class Input>
    static void apply(const Input& in, StatementBuilder& builder) {
        builder.add_bool(in.begin(), in.size() == 4);
    }
};

/// Words the error for each rule that the grammar demands with must<>.
template <class Rule>
struct Control : peg::normal<Rule> {
    template <class Input>
    [[noreturn]] static void raise(const Input& in, StatementBuilder& builder) {
        if constexpr (std::is_same_v<Rule, grammar::StringEnd>) {
            builder.fail_string(in.current());
        } else if constexpr (std::is_same_v<Rule, grammar::ListEnd>) {
            builder.fail_list(in.current());
        } else if constexpr (std::is_same_v<Rule, grammar::EndOfFile>) {
            builder.fail_statement(in.current());
        } else if constexpr (std::is_same_v<Rule, grammar::NumberEnd>) {
            builder.fail_number_end();
        } else {
            builder.fail_number(in.current());
        }
    }
};

}  // namespace

void parse_file(const std::shared_ptr<const SourceFile>& file, const StatementHandler& handler) {
    const std::string& text = *file->text;
    peg::memory_input<peg::tracking_mode::lazy, peg::eol::lf> input(text.data(),
                                                                    text.data() + text.size(), "");
    StatementBuilder builder(file, handler);
    peg::parse<grammar::SceneText, Action, Control>(input, builder);
}

}  // namespace lxs
