#include "sentences/plural.h"

#include <algorithm>
#include <limits>

#include <QCoreApplication>

#include "sentences/language.h"
#include "words/figures.h"

namespace mapwright::sentences {
// Every program and every test speaks English; and another language, once it is chosen.
Q_COREAPP_STARTUP_FUNCTION(installTranslations)

QString counted(const QString& translated, qint64 count) {
  return translated.arg(QString::fromStdString(words::grouped(count)));
}

int formOf(qint64 count) { return int(std::min<qint64>(count, std::numeric_limits<int>::max())); }

}  // namespace mapwright::sentences
