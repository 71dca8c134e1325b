// Limits for threads and memory, stored in the settings.
#pragma once

#include <QSettings>
#include <QString>
#include <QStringList>

#include "work/budgets.h"

namespace mapwright::ui {

/// 0 = default: one thread per processor, work::kUsualBudget.
struct WorkSettings {
  int threads = 0;
  int budget_mb = 0;

  static constexpr int kMostThreads = 256;
  static constexpr int kLeastMb = int(work::kLeastBudget >> 20), kUsualMb = int(work::kUsualBudget >> 20),
                       kMostMb = 1 << 20;

  work::Budgets budgets() const;
  bool operator==(const WorkSettings&) const = default;
};

/// The stored settings. Invalid ones get their defaults, with a sentence about it.
struct KeptWorkSettings {
  WorkSettings settings;
  QStringList nonsense;
};
KeptWorkSettings workSettingsIn(const QSettings& settings);
void keepWorkSettings(QSettings& settings, const WorkSettings& wanted);

}  // namespace mapwright::ui
