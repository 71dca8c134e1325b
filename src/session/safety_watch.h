// Watches the safety conditions of a robot: reports changes, including expiry, and logs their starts and ends
// as problems.
#pragma once

#include <functional>
#include <vector>

#include <QObject>
#include <QTimer>

#include "map/safety.h"

namespace mapwright::session {

/// GUI-thread object. The live state must outlive it.
class SafetyWatch : public QObject {
  Q_OBJECT
 public:
  /// `now_s`: seconds since the epoch.
  SafetyWatch(const map::LiveState& live, std::function<double()> now_s, QObject* parent = nullptr);
  /// Current conditions, most severe first.
  const std::vector<map::SafetyCondition>& conditions() const { return conditions_; }
  /// The live state may have changed.
  void look();

 Q_SIGNALS:
  void changed();
  /// It began (again).
  void began(const mapwright::map::SafetyCondition& condition);
  /// No condition of this name is active any more.
  void ended(const mapwright::map::SafetyCondition& condition);

 private:
  const map::LiveState& live_;
  std::function<double()> now_s_;
  std::vector<map::SafetyCondition> conditions_;
  QTimer expiry_;
};

}  // namespace mapwright::session
