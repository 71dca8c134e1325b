// What is wrong with a command line that can be seen before any command looks at its own options.
#pragma once

#include <optional>

#include <QString>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace mapwright::app {

/// A sentence, without its stop, in the language that is spoken.
QString sentenceOf(const CLI::ParseError& error);
/// A sentence if a word that was typed is not UTF-8: a file of that name cannot be opened.
std::optional<QString> notUtf8Reason(int argc, const char* const* argv);
/// After `program` has parsed its arguments: a sentence if one of them could have no effect, as each of the
/// options that all commands have if it is given twice, and all beside --version; or if the log would be
/// written into another output.
std::optional<QString> noEffectReason(const CLI::App& program);

}  // namespace mapwright::app
