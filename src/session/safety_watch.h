// Looks after what is dangerous or wrong with a robot: tells when that changes, also when it only expires,
// and puts beginnings and ends into the list of problems.
#pragma once

#include <functional>
#include <vector>

#include <QObject>
#include <QTimer>

#include "map/live_state.h"

namespace mapwright::session {

/// GUI-thread object. The live state must outlive it.
class SafetyWatch : public QObject {
  Q_OBJECT
 public:
  /// `now_s`: seconds since the epoch.
  SafetyWatch(const map::LiveState& live, std::function<double()> now_s, QObject* parent = nullptr);
  /// What holds now, the gravest first.
  const std::vector<map::SafetyCondition>& conditions() const { return conditions_; }
  /// The live state may have changed.
  void look();

 Q_SIGNALS:
  void changed();
  /// It began (again).
  void began(const mapwright::map::SafetyCondition& condition);
  /// Nothing of this name holds any more.
  void ended(const mapwright::map::SafetyCondition& condition);

 private:
  const map::LiveState& live_;
  std::function<double()> now_s_;
  std::vector<map::SafetyCondition> conditions_;
  QTimer expiry_;
};

}  // namespace mapwright::session
