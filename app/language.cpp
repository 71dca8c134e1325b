#include "app/language.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/command_text.h"
#include "app/commands.h"
#include "sentences/language.h"
#include "words/plain.h"

namespace mapwright::app {
namespace {

constexpr std::string_view kLanguageOption = "--language";

/// Qt takes its arguments as long as it lives. Never destroyed at the end of the program: Qt's own parts may
/// be gone by then.
struct Speaker {
  int argc = 1;
  char name[sizeof("mapwright")] = "mapwright";
  char* argv[2] = {name, nullptr};
  QCoreApplication application{argc, argv};
};
std::unique_ptr<Speaker>& speaker() {
  static auto* const one = new std::unique_ptr<Speaker>;
  return *one;
}

}  // namespace

void addLanguage(CLI::App& program, std::string& language) {
  std::string codes;
  for (const sentences::Language& each : sentences::languages()) codes += each.code.toStdString() + ',';
  program
      .add_option(std::string(kLanguageOption), language,
                  help(Text::tr("Language of all texts; without it the window has the one chosen in it, and "
                                "commands speak English")))
      ->type_name("TEXT:{" + codes + "system}");  // languageTyped() refuses others
  for (CLI::App* command : program.get_subcommands({})) addLanguage(*command, language);
}

void translateHeadings(CLI::App& program) {
  const auto formatter = program.get_formatter();
  formatter->label("Usage", help(Text::tr("Usage")));
  formatter->label("Positionals", help(Text::tr("Positionals")));
  formatter->label("REQUIRED", help(Text::tr("REQUIRED")));
  formatter->label("Env", help(Text::tr("Env")));
  formatter->label("Needs", help(Text::tr("Needs")));
  formatter->label("Excludes", help(Text::tr("Excludes")));
  for (CLI::Option* option : program.get_options()) {
    if (option->get_group() == "Options") option->group(help(Text::tr("Options")));
  }
  for (CLI::App* command : program.get_subcommands({})) {
    if (command->get_group() == "Subcommands") command->group(help(Text::tr("Subcommands")));
    translateHeadings(*command);
  }
}

tl::expected<std::optional<QString>, QString> languageTyped(int argc, const char* const* argv) {
  std::optional<QString> code;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--" || word == "bench") break;  // what comes then is for others
    std::string_view typed;
    if (word == kLanguageOption) {
      if (i + 1 < argc) typed = argv[++i];
    } else if (word.starts_with(kLanguageOption) && word.substr(kLanguageOption.size()).starts_with('=')) {
      typed = word.substr(kLanguageOption.size() + 1);
    }
    if (typed.empty()) continue;
    code = sentences::languageCalled(QString::fromUtf8(typed.data(), qsizetype(typed.size())));
    if (!code) {
      return tl::make_unexpected(
          Text::tr("--language %1: there is no such language. There are %2.")
              .arg(QString::fromStdString(words::plainLine(typed)), sentences::languagesTyped()));
    }
  }
  return code;
}

void startSpeaking(const QString& code) {
  sentences::speak(code);
  if (code != sentences::languages().front().code && !QCoreApplication::instance())
    speaker() = std::make_unique<Speaker>();
}

InPlaceOfSpeaker::InPlaceOfSpeaker() { speaker().reset(); }
InPlaceOfSpeaker::~InPlaceOfSpeaker() { startSpeaking(sentences::spokenLanguage()); }

}  // namespace mapwright::app
