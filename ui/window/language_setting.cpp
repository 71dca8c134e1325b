#include "ui/window/language_setting.h"

#include "sentences/language.h"

namespace mapwright::ui {
namespace {

const QString kLanguageKey = QStringLiteral("view/language");

}  // namespace

QString languageIn(const QSettings& settings) {
  const QString kept = settings.value(kLanguageKey).toString();
  return sentences::languageCalled(kept) ? kept : kLanguageOfSystem;
}

void keepLanguage(QSettings& settings, const QString& language) {
  if (language == kLanguageOfSystem) return settings.remove(kLanguageKey);
  settings.setValue(kLanguageKey, language);
}

}  // namespace mapwright::ui
