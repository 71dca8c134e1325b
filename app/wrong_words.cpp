#include "app/wrong_words.h"

#include <algorithm>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <QRegularExpression>
#include <QStringList>

#include "app/command_text.h"
#include "app/output.h"
#include "app/unknown_word.h"
#include "words/listed.h"
#include "words/plain.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

/// "0.000000" -> "0".
QString withoutZeros(QString number) {
  if (number.contains(QLatin1Char('.'))) number.remove(QRegularExpression(QStringLiteral("\\.?0+$")));
  return number;
}

/// "{a,b}", and "{a->0,b->1}" of those that stand for numbers.
QString listedOf(const QString& set) {
  QStringList words = set.split(QLatin1Char(','));
  for (QString& word : words) word = word.section(QLatin1String("->"), 0, 0);
  return words::listed(words);
}

bool isFromEnvironment(const CLI::Option& option) {
  const std::string name = option.get_envname();
  return !name.empty() && option.results().size() == 1 &&
         qgetenv(name.c_str()) == option.results().front().c_str();
}

/// Given beside --version, which ends the program; empty = nothing is.
std::string givenBesideVersion(const CLI::App& program) {
  for (const CLI::Option* option : program.get_options()) {
    const std::string name = option->get_name();
    const bool fits = name == "--version" || name == "--json" || name == "--language";
    if (!fits && option->count() > 0 && !isFromEnvironment(*option)) return name;
  }
  return program.get_subcommands().empty() ? std::string() : program.get_subcommands().front()->get_name();
}

}  // namespace

QString sentenceOf(const CLI::ParseError& error) {
  const QString words = QString::fromStdString(words::plainLine(std::string_view(error.what())));
  struct Kind {
    const char* said;
    QString (*sentence)(const QStringList&);
  };
  using Parts = const QStringList&;
  static const Kind kinds[] = {
      {"^(.+) is required$", [](Parts of) { return Text::tr("%1 is required").arg(of[1]); }},
      {"^(.+): 1 required .* missing$", [](Parts of) { return Text::tr("%1 needs a value").arg(of[1]); }},
      {"^(.+): \\d+ required (.+) missing$",
       [](Parts of) { return Text::tr("%1 needs %2").arg(of[1], of[2]); }},
      {"^(.+): At Most 1 required but received",
       [](Parts of) { return Text::tr("%1 is given more than once").arg(of[1]); }},
      {"^(.+): At Most (\\d+) required but received (\\d+)",
       [](Parts of) { return Text::tr("%1 is given %2 values: at most %3").arg(of[1], of[3], of[2]); }},
      {"^(.+): At least (\\d+) required but received (\\d+)",
       [](Parts of) { return Text::tr("%1 is given %2 values: at least %3").arg(of[1], of[3], of[2]); }},
      {"^(\\S+) requires (\\S+)$",
       [](Parts of) { return Text::tr("%1 goes only with %2").arg(of[1], of[2]); }},
      {"^(\\S+) excludes (\\S+)$",
       [](Parts of) { return Text::tr("%1 does not go with %2").arg(of[1], of[2]); }},
      {"^Could not convert: (\\S+) = (.*)$",
       [](Parts of) { return Text::tr("%1: %2 is not a number that fits").arg(of[1], of[2]); }},
      // "0 to 10", and "[0 - 10]" since CLI11 2.4.
      {"^(.+): Value (.*) not in range \\[?(\\S+) (?:to|-) ([^\\s\\]]+)\\]?$",
       [](Parts of) {
         bool number = false;
         of[2].toDouble(&number);
         if (!number) return Text::tr("%1: \"%2\" is not a number").arg(of[1], of[2]);
         return Text::tr("%1: %2 is not between %3 and %4")
             .arg(of[1], of[2], withoutZeros(of[3]), withoutZeros(of[4]));
       }},
      {"^(.+): Value (.*) could not be converted to .*$",
       [](Parts of) { return Text::tr("%1: \"%2\" is not a number").arg(of[1], of[2]); }},
      {"^(.+): (.*) unit not recognized\\. Allowed values: \\{(.*)\\}$",
       [](Parts of) { return Text::tr("%1: %2 is not one of %3").arg(of[1], of[2], listedOf(of[3])); }},
      {"^([^:]+): (?:Check )?(.*?) (?:not|value) in \\{(.*?)\\}.*$",
       [](Parts of) { return Text::tr("%1: %2 is not one of %3").arg(of[1], of[2], listedOf(of[3])); }},
  };
  for (const Kind& kind : kinds) {
    const auto match = QRegularExpression(QLatin1String(kind.said)).match(words);
    if (match.hasMatch()) return kind.sentence(match.capturedTexts());
  }
  return words;
}

std::optional<QString> notUtf8Reason(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const QByteArray word(argv[i]);
    const QString text = QString::fromUtf8(word);
    if (text.toUtf8() == word) continue;
    return Text::tr(
               "%1 is not in UTF-8, and a file of that name cannot be opened. Rename it, for example "
               "with convmv.")
        .arg(words::plainName(text));
  }
  return std::nullopt;
}

std::optional<QString> noEffectReason(const CLI::App& program) {
  const auto chain = parsedChain(program);
  std::string log;
  for (const char* name : {"--log", "--log-file", "--language"}) {
    std::size_t times = 0;
    for (const CLI::App* command : chain) {
      const CLI::Option* const option = command->get_option_no_throw(name);
      if (!option || option->count() == 0) continue;
      times += option->count();
      if (option->get_name() == "--log-file") log = option->results().back();
    }
    if (times > 1) return Text::tr("%1 is given more than once.").arg(QLatin1String(name));
  }
  if (program.count("--version") > 0) {
    const std::string other = givenBesideVersion(program);
    if (other.empty()) return std::nullopt;
    return Text::tr("%1 has no effect beside --version, which only prints the version.")
        .arg(QString::fromStdString(other));
  }
  if (log.empty()) return std::nullopt;
  const QString file = QString::fromStdString(log);
  if (isStandardOutput(file))
    return Text::tr("--log-file needs the name of a file. Without it, --log all writes to standard error.");
  for (const CLI::App* command : chain) {
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_name() == "--log-file" || option->get_type_name().find("FILE") == std::string::npos)
        continue;
      for (const std::string& word : option->results()) {
        if (const auto why = notTogetherReason({QString::fromStdString(word), file})) return why;
      }
    }
  }
  return std::nullopt;
}

}  // namespace mapwright::app
