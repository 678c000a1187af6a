// Grammar of scene files: words, strings, numbers, lists, comments. What a statement takes is
// checked later, so that messages can name the statement.
#pragma once

#include <tao/pegtl.hpp>

namespace lxs::grammar {

namespace peg = tao::pegtl;

struct Comment : peg::seq<peg::one<'#'>, peg::star<peg::not_one<'\n'>>> {};
struct Blank : peg::one<' ', '\t', '\r', '\n', '\f', '\v'> {};
struct Gap : peg::star<peg::sor<Blank, Comment>> {};

struct WordCharacter : peg::identifier_other {};
struct Word : peg::identifier {};

struct Sign : peg::one<'+', '-'> {};
struct Digits : peg::plus<peg::digit> {};
struct Mantissa : peg::sor<peg::seq<Digits, peg::opt<peg::one<'.'>, peg::star<peg::digit>>>,
                           peg::seq<peg::one<'.'>, Digits>> {};
struct Exponent : peg::seq<peg::one<'e', 'E'>, peg::opt<Sign>, Digits> {};
struct Number : peg::seq<peg::opt<Sign>, Mantissa, peg::opt<Exponent>> {};
struct Microsoft  // what follows "1." where an old Microsoft library prints infinity or NaN
    : peg::seq<peg::one<'#'>, peg::sor<TAO_PEGTL_ISTRING("inf"), TAO_PEGTL_ISTRING("ind"),
                                       TAO_PEGTL_ISTRING("qnan"), TAO_PEGTL_ISTRING("snan")>> {};
struct FiniteNumber : peg::seq<Number, peg::not_at<Microsoft>> {};
struct NumberEnd : peg::not_at<peg::sor<WordCharacter, peg::one<'.', '+', '-'>>> {};
/// As programs print it: "nan", "-inf", "-nan(ind)", "1.#QNAN0".
struct NotFinite
    : peg::seq<peg::opt<Sign>,
               peg::sor<peg::seq<TAO_PEGTL_ISTRING("nan"),
                                 peg::opt<peg::one<'('>, peg::star<WordCharacter>, peg::one<')'>>>,
                        TAO_PEGTL_ISTRING("infinity"), TAO_PEGTL_ISTRING("inf"),
                        peg::seq<Digits, peg::one<'.'>, Microsoft, peg::star<peg::digit>>>,
               peg::not_at<WordCharacter>> {};
struct NumberStart : peg::at<peg::sor<Sign, peg::one<'.'>, peg::digit>> {};
struct NotANumber {};  // names the error, see Control::raise
struct NumberToken : peg::sor<peg::seq<FiniteNumber, peg::must<NumberEnd>>, NotFinite,
                              peg::seq<NumberStart, peg::raise<NotANumber>>> {};

/// No control characters but the tab; a backslash takes the next character along.
struct PlainCharacter : peg::sor<peg::one<'\t'>, peg::not_range<'\x00', '\x1f'>> {};
struct EscapedCharacter : peg::seq<peg::one<'\\'>, PlainCharacter> {};
struct StringCharacter
    : peg::sor<EscapedCharacter, peg::seq<peg::not_at<peg::one<'"'>>, PlainCharacter>> {};
struct StringBegin : peg::one<'"'> {};
struct StringText : peg::star<StringCharacter> {};
struct StringEnd : peg::one<'"'> {};
struct String : peg::seq<StringBegin, StringText, peg::must<StringEnd>> {};

/// Bools are strings in LuxRender; bare words are taken too.
struct Bool : peg::seq<peg::sor<TAO_PEGTL_STRING("true"), TAO_PEGTL_STRING("false")>,
                       peg::not_at<WordCharacter>> {};

struct Element : peg::sor<NumberToken, String, Bool> {};
struct ListBegin : peg::one<'['> {};
struct ListEnd : peg::one<']'> {};
/// Many numbers at once, once a list has become long: the grammar's own way costs more than reading
/// them (docs/measured/big-scenes.md). Matches nothing that Element would not.
struct NumberRun {
    using rule_t = NumberRun;
    using subs_t = peg::empty_list;
    template <peg::apply_mode, peg::rewind_mode, template <class...> class,
              template <class...> class, class Input, class Builder>
    static bool match(Input& in, Builder& builder) {
        const char* behind = builder.add_number_run(in.current(), in.end());
        if (behind == in.current()) return false;
        in.bump(static_cast<std::size_t>(behind - in.current()));
        return true;
    }
};

struct List : peg::seq<ListBegin, Gap,
                       peg::star<peg::sor<peg::seq<NumberRun, Gap>, peg::seq<Element, Gap>>>,
                       peg::must<ListEnd>> {};

struct StatementArguments : peg::star<peg::sor<List, Element>, Gap> {};
struct StatementText : peg::seq<Word, Gap, StatementArguments> {};
struct EndOfFile : peg::eof {};
struct SceneText
    : peg::seq<peg::opt<peg::utf8::bom>, Gap, peg::star<StatementText>, peg::must<EndOfFile>> {};

}  // namespace lxs::grammar
