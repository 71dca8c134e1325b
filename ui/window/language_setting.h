// Which language the window is in, stored in the settings.
#pragma once

#include <QSettings>
#include <QString>

namespace mapwright::ui {

inline const QString kLanguageOfSystem = QStringLiteral("system");

/// "zh_CN", or "system" where none that there is was chosen.
QString languageIn(const QSettings& settings);
void keepLanguage(QSettings& settings, const QString& language);

}  // namespace mapwright::ui
