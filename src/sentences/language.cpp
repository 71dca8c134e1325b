#include "sentences/language.h"

#include <algorithm>
#include <mutex>
#include <shared_mutex>

#include <QCoreApplication>
#include <QHash>
#include <QLibraryInfo>
#include <QLocale>
#include <QStringList>
#include <QTranslator>

#include "words/listed.h"

static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace mapwright::sentences {
namespace {

const QString kEnglish = QStringLiteral("en"), kSystem = QStringLiteral("system");

/// Translators belong to one application, and the program makes several, one after the other.
QString& chosenLanguage() {
  static QString code = kEnglish;
  return code;
}

thread_local int english_only = 0;

/// Which short texts were spoken. Any thread.
struct Spoken {
  std::shared_mutex mutex;
  QHash<QString, QStringList> sources;
};
Spoken& spokenTexts() {
  static Spoken all;
  return all;
}

constexpr qsizetype kLongestRemembered = 60;

class ChosenTranslator : public QTranslator {
 public:
  using QTranslator::QTranslator;
  QString translate(const char* context, const char* text, const char* comment, int n) const override {
    if (english_only > 0 || chosenLanguage() == kEnglish) return {};
    const QString translated = QTranslator::translate(context, text, comment, n);
    if (!translated.isEmpty() && translated.size() <= kLongestRemembered) remember(translated, text);
    return translated;
  }

 private:
  static void remember(const QString& translated, const char* text) {
    Spoken& spoken = spokenTexts();
    {
      const std::shared_lock reading(spoken.mutex);
      const auto known = spoken.sources.constFind(translated);
      if (known != spoken.sources.cend() && known->contains(QString::fromUtf8(text))) return;
    }
    const std::unique_lock writing(spoken.mutex);
    QStringList& sources = spoken.sources[translated];
    if (const QString source = QString::fromUtf8(text); !sources.contains(source)) sources << source;
  }
};

template <typename Translator>
void installFrom(const QString& file, const QString& folder) {
  auto* const translator = new Translator(QCoreApplication::instance());
  if (translator->load(file, folder)) {
    QCoreApplication::installTranslator(translator);
  } else {
    delete translator;
  }
}

/// Those that are installed later are asked first. Qt's own texts that the program does not have come from
/// Qt's files, where these are installed.
void installChosen() {
  const QString code = chosenLanguage();
  if (code == kEnglish) return;
  installFrom<ChosenTranslator>(QStringLiteral("qtbase_") + code,
                                QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  installFrom<ChosenTranslator>(QStringLiteral("mapwright_") + code, QStringLiteral(":/translations"));
}

}  // namespace

const std::vector<Language>& languages() {
  static const std::vector<Language> all{{kEnglish, QStringLiteral("English")},
                                         {QStringLiteral("zh_CN"), QStringLiteral("简体中文")}};
  return all;
}

QString languageOfSystem() {
  for (const QString& wanted : QLocale::system().uiLanguages()) {
    const QLocale locale(wanted);
    for (const Language& each : languages()) {
      const QLocale ours(each.code);
      // The script, too: traditional Chinese is no simplified one.
      if (locale.language() == ours.language() && locale.script() == ours.script()) return each.code;
    }
  }
  return kEnglish;
}

std::optional<QString> languageCalled(const QString& typed) {
  if (typed == kSystem) return languageOfSystem();
  const auto known = std::find_if(languages().begin(), languages().end(), [&](const Language& each) {
    return typed == each.code || typed == each.code.section(QLatin1Char('_'), 0, 0);
  });
  return known == languages().end() ? std::nullopt : std::optional(known->code);
}

QString languagesTyped() {
  QStringList codes;
  for (const Language& each : languages()) codes << each.code;
  return QCoreApplication::translate("Language", "%1 and %2").arg(words::listed(codes), kSystem);
}

void speak(const QString& code) {
  const bool other = code != chosenLanguage();
  chosenLanguage() = code;
  if (other && QCoreApplication::instance()) installChosen();
}

QString spokenLanguage() { return chosenLanguage(); }

QStringList sourcesOf(const QString& translated) {
  Spoken& spoken = spokenTexts();
  const std::shared_lock reading(spoken.mutex);
  return spoken.sources.value(translated);
}

void installTranslations() {
  initTranslations();
  installFrom<QTranslator>(QStringLiteral("mapwright_en"), QStringLiteral(":/translations"));
  installChosen();
}

InEnglish::InEnglish() { ++english_only; }
InEnglish::~InEnglish() { --english_only; }

}  // namespace mapwright::sentences
