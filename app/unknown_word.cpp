#include "app/unknown_word.h"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <QStringList>

#include "app/command_text.h"
#include "words/listed.h"
#include "words/plain.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

/// Damerau-Levenshtein: exchanging two neighbours is one step.
std::size_t stepsBetween(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> steps(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        steps[i][j] = i + j;
        continue;
      }
      steps[i][j] = std::min(
          {steps[i - 1][j] + 1, steps[i][j - 1] + 1, steps[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        steps[i][j] = std::min(steps[i][j], steps[i - 2][j - 2] + 1);
    }
  }
  return steps[a.size()][b.size()];
}

std::vector<std::string> optionsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

QString shown(const std::string& word) {
  return QString::fromStdString(words::plainLine(std::string_view(word)));
}

QString withNearest(const QString& sentence, const std::optional<std::string>& nearest) {
  return nearest ? Text::tr("%1 Did you mean %2?").arg(sentence, shown(*nearest)) : sentence;
}

QString calledAs(const std::vector<const CLI::App*>& chain, std::size_t from) {
  QStringList names;
  for (std::size_t i = from; i < chain.size(); ++i) names << QString::fromStdString(chain[i]->get_name());
  return names.join(QLatin1Char(' '));
}

}  // namespace

std::vector<const CLI::App*> parsedChain(const CLI::App& program) {
  std::vector<const CLI::App*> chain{&program};
  while (!chain.back()->get_subcommands().empty()) chain.push_back(chain.back()->get_subcommands().front());
  return chain;
}

std::optional<std::string> nearestOf(const std::string& word, const std::vector<std::string>& known) {
  std::optional<std::string> nearest;
  std::size_t fewest = (word.size() + 2) / 3 + 1;
  for (const std::string& each : known) {
    const bool begun = word.size() > 1 && word.find_first_not_of('-') != word.npos && each.starts_with(word);
    const std::size_t steps = begun ? 0 : std::max<std::size_t>(1, stepsBetween(word, each));
    if (steps >= fewest) continue;
    fewest = steps;
    nearest = each;
  }
  return nearest;
}

std::vector<std::string> subcommandsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  return names;
}

std::optional<QString> sentenceOnUnknownWord(const CLI::App& program) {
  const auto chain = parsedChain(program);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const CLI::App& command = *chain[i];
    const std::vector<std::string> unknown = command.remaining();
    if (unknown.empty()) continue;
    const std::vector<const CLI::App*> until(chain.begin(), chain.begin() + std::ptrdiff_t(i) + 1);
    const QString name = calledAs(until, i == 0 ? 0 : 1);
    const std::string word = unknown.front().substr(0, unknown.front().find('='));
    if (word.size() > 1 && word.front() == '-') {
      return withNearest(Text::tr("%1: no such option of %2.").arg(shown(word), name),
                         nearestOf(word, optionsOf(command)));
    }
    if (const auto known = subcommandsOf(command); !known.empty()) {
      return withNearest(Text::tr("%1: no such subcommand of %2.").arg(shown(unknown.front()), name),
                         nearestOf(unknown.front(), known));
    }
    if (unknown.front().find("://") != std::string::npos && command.get_option_no_throw("--robot"))
      return Text::tr("%1 is an address: put --robot in front of it.").arg(shown(unknown.front()));
    return Text::tr("%1: one word too many for %2. Quote a name that has blanks in it.")
        .arg(shown(unknown.front()), name);
  }
  if (chain.size() > 1 && !subcommandsOf(*chain.back()).empty()) {
    QStringList known;
    for (const std::string& each : subcommandsOf(*chain.back())) known << QString::fromStdString(each);
    return Text::tr("%1 needs a subcommand: %2.").arg(calledAs(chain, 1), words::listed(known));
  }
  return std::nullopt;
}

QString parsedCommand(const CLI::App& program) { return calledAs(parsedChain(program), 0); }

}  // namespace mapwright::app
