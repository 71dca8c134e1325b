// The languages that mapwright speaks: English, which is in the sources, and those of
// resources/mapwright_*.ts.
#pragma once

#include <optional>
#include <vector>

#include <QString>
#include <QStringList>

namespace mapwright::sentences {

struct Language {
  QString code;  // "zh_CN", as in the name of its file
  QString name;  // in itself
};

/// English first.
const std::vector<Language>& languages();
/// The one that the system asks for first of those that there are; else English. Its code, as below.
QString languageOfSystem();
/// What "system" or a code means; nullopt = there is no such language.
std::optional<QString> languageCalled(const QString& typed);
/// "en, zh_CN and system"
QString languagesTyped();

/// From now on all texts are in it, in this application and in those that are made later. On the GUI thread.
void speak(const QString& code);
/// English until speak() is called.
QString spokenLanguage();
/// The English texts that were spoken as this one so far: short ones, such as names of commands. Empty while
/// English is spoken.
QStringList sourcesOf(const QString& translated);
/// For each new application; plural.cpp has Qt call it.
void installTranslations();

/// While there is one, texts on this thread are in English: for pictures that are compared with others.
class InEnglish {
 public:
  InEnglish();
  ~InEnglish();
  InEnglish(const InEnglish&) = delete;
  InEnglish& operator=(const InEnglish&) = delete;
};

}  // namespace mapwright::sentences
