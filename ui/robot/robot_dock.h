// The state of the robot: connection, battery, wheels, localization, plan, alerts.
#pragma once

#include <vector>

#include <QDockWidget>
#include <QPointer>
#include <QTimer>

#include "session/session.h"
#include "ui/robot/robot_status.h"

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace mapwright::ui {

class PlainLabel;
class StateLabel;
class ThinBar;

class RobotDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit RobotDock(QWidget* parent = nullptr);
  void setSession(session::Session* session);

  /// Everything shown, one line each, for the clipboard and for tests.
  QString shownText() const;
  bool greyed() const { return greyed_; }
  QString limitsShown() const;
  void refresh();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  /// Where it is and where it goes is told here, too: its topics say little else.
  bool ofTopics() const;
  void showSections(std::vector<StatusSection> sections);
  void showAlerts(std::vector<AlertLine> lines, bool known);
  QWidget* alertRow(const AlertLine& line);

  QPointer<session::Session> session_;
  QTimer refresh_timer_;
  QTimer tick_;  // updates the time since the last message
  bool greyed_ = false;
  bool alerts_known_ = false;
  std::optional<bool> drawn_alerts_known_;
  std::vector<StatusSection> sections_;
  std::vector<AlertLine> alerts_;
  StateLabel* link_;
  PlainLabel* stale_;
  QLabel* limits_;
  QWidget *fields_, *alert_box_;
  QGridLayout* grid_;
  QVBoxLayout* alert_column_;
  struct Cells {
    StateLabel* value;
    ThinBar* bar;  // null where there is none
  };
  std::vector<Cells> cells_;
};

}  // namespace mapwright::ui
