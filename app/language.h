// --language: which language the texts are in. Known before the options are, because these have texts, too.
#pragma once

#include <optional>
#include <string>

#include <QString>
#include <tl/expected.hpp>

namespace CLI {
class App;
}

namespace mapwright::app {

/// --language for the program and each of its commands.
void addLanguage(CLI::App& program, std::string& language);
/// The headings of --help in the language that is spoken.
void translateHeadings(CLI::App& program);

/// The code of what is typed behind --language, wherever it stands; nullopt: it is not given, or without a
/// value, which is refused later. The error is a sentence.
tl::expected<std::optional<QString>, QString> languageTyped(int argc, const char* const* argv);

/// Speaks it, also while there is no application: then one of its own is there for the texts.
void startSpeaking(const QString& code);

/// Texts are translated only while there is an application. A command makes its own when it knows what it
/// needs, and stands behind this, which takes that of startSpeaking() away meanwhile.
class InPlaceOfSpeaker {
 public:
  InPlaceOfSpeaker();
  ~InPlaceOfSpeaker();
  InPlaceOfSpeaker(const InPlaceOfSpeaker&) = delete;
  InPlaceOfSpeaker& operator=(const InPlaceOfSpeaker&) = delete;
};

}  // namespace mapwright::app
