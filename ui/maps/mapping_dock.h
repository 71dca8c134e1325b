// The mapping of the robot while it lasts: what it tells of it, and what can be done with it.
#pragma once

#include <optional>

#include <QDockWidget>
#include <QString>

class QAction;
class QFormLayout;
class QLabel;

namespace mapwright::ui {

class PlainLabel;

/// What is known of a mapping.
struct MappingState {
  enum class Phase { None, Unknown, Running, Away };
  Phase phase = Phase::None;           // Away: it was running when the connection was lost
  std::optional<double> lasts_s = {};  // by the robot's own clock
  double seen_s = 0;                   // otherwise: since it was noticed
  QString extends = {};                // the map that is extended; empty = a new one, or not known
  int submaps = 0;
  double width_m = 0, height_m = 0;  // of what is mapped; 0 = not known
  QString trouble = {};              // why the robot tells nothing
  QString manager = {};              // what its map manager calls its state; empty = it does not say
  bool operator==(const MappingState&) const = default;
};

class MappingDock : public QDockWidget {
  Q_OBJECT
 public:
  /// The buttons are those of the actions, in this order.
  explicit MappingDock(const QList<QAction*>& actions, QWidget* parent = nullptr);
  void setState(const MappingState& state);
  /// A remark on what the buttons do; empty = none.
  void setUnconfirmed(const QString& remark);
  const MappingState& state() const { return state_; }
  QString said() const;

 private:
  MappingState state_;
  QLabel *said_, *trouble_, *unconfirmed_;
  PlainLabel *lasts_, *submaps_, *size_;
};

}  // namespace mapwright::ui
