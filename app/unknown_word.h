// What is said of a word on the command line that no command knows, with the nearest one that there is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>

namespace CLI {
class App;
}

namespace mapwright::app {

/// The one of `known` that `word` was probably meant to be: the rest of what was begun, or the fewest letters
/// added, left out, replaced or exchanged, of at most a third of the word. nullopt: none is near.
std::optional<std::string> nearestOf(const std::string& word, const std::vector<std::string>& known);

/// The names of the subcommands of `command`.
std::vector<std::string> subcommandsOf(const CLI::App& command);

/// After `program` could not parse its arguments: a sentence about the first word that it does not know, or
/// about a subcommand that is missing; nullopt = neither is the cause.
std::optional<QString> sentenceOnUnknownWord(const CLI::App& program);

/// `program` and the subcommands that were parsed, outermost first.
std::vector<const CLI::App*> parsedChain(const CLI::App& program);
/// "mapwright overlays get": the command that was parsed last, as it was called.
QString parsedCommand(const CLI::App& program);

}  // namespace mapwright::app
