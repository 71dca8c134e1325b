#include "sentences/plural.h"

#include <algorithm>
#include <limits>

#include <QCoreApplication>
#include <QTranslator>

#include "words/figures.h"

static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace mapwright::sentences {
namespace {

/// Every program and every test speaks English. Translations that are installed later come before it.
void speakEnglish() {
  initTranslations();
  auto* const english = new QTranslator(QCoreApplication::instance());
  if (english->load(QStringLiteral(":/translations/mapwright_en.qm")))
    QCoreApplication::installTranslator(english);
}
Q_COREAPP_STARTUP_FUNCTION(speakEnglish)

}  // namespace

QString counted(const QString& translated, qint64 count) {
  return translated.arg(QString::fromStdString(words::grouped(count)));
}

int formOf(qint64 count) { return int(std::min<qint64>(count, std::numeric_limits<int>::max())); }

}  // namespace mapwright::sentences
