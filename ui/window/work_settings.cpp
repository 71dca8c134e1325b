#include "ui/window/work_settings.h"

#include <QCoreApplication>
#include <QVariant>

#include "words/qt_plain.h"
#include "words/shortened.h"

namespace mapwright::ui {
namespace {

const QString kThreads = QStringLiteral("work/threads"), kBudget = QStringLiteral("memory/budget_mb");
constexpr qsizetype kLongestQuote = 40;

QString spoken(const QVariant& value) {
  return words::shortened(words::plainName(value.toString()), kLongestQuote);
}

int numberIn(const QSettings& settings, const QString& key, int least, int most, QStringList& nonsense) {
  const QVariant value = settings.value(key);
  if (!value.isValid() || value.isNull()) return 0;
  bool whole = false;
  const int number = value.toString().toInt(&whole);
  if (whole && (number == 0 || (number >= least && number <= most))) return number;
  nonsense << QCoreApplication::translate("window",
                                          "%1 in %2 is \"%3\". It must be a whole number from %4 to %5, or 0 "
                                          "for the default. The default is used.")
                  .arg(key, settings.fileName(), spoken(value))
                  .arg(least)
                  .arg(most);
  return 0;
}

void keep(QSettings& settings, const QString& key, int number) {
  if (number == 0) {
    settings.remove(key);
  } else {
    settings.setValue(key, number);
  }
}

}  // namespace

work::Budgets WorkSettings::budgets() const {
  return budget_mb == 0 ? work::budgetsFrom() : work::budgetsFrom(std::size_t(budget_mb) << 20);
}

KeptWorkSettings workSettingsIn(const QSettings& settings) {
  KeptWorkSettings kept;
  kept.settings.threads = numberIn(settings, kThreads, 1, WorkSettings::kMostThreads, kept.nonsense);
  kept.settings.budget_mb =
      numberIn(settings, kBudget, WorkSettings::kLeastMb, WorkSettings::kMostMb, kept.nonsense);
  return kept;
}

void keepWorkSettings(QSettings& settings, const WorkSettings& wanted) {
  keep(settings, kThreads, wanted.threads);
  keep(settings, kBudget, wanted.budget_mb);
}

}  // namespace mapwright::ui
