// What answers at a host: looked for beside the form that asks which robot to connect to.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QWidget>

#include "jobs/robot_search.h"
#include "robot/address.h"

class QLabel;
class QListWidget;
class QPlainTextEdit;
class QToolButton;

namespace mapwright::ui {

class FoundRobots : public QWidget {
  Q_OBJECT
 public:
  /// `addresses` must outlive this.
  explicit FoundRobots(const robot::Addresses& addresses, QWidget* parent = nullptr);
  ~FoundRobots() override;

  /// `called`: the host as it was typed.
  void look(const QString& called, std::vector<robot::Probe> probes);
  void stop();
  bool looking() const;
  /// Of the selected row.
  std::optional<robot::FoundRobot> chosen() const;
  QListWidget* list() const { return list_; }

 Q_SIGNALS:
  /// Looking has begun or ended, or another row is selected.
  void changed();
  void wanted(const mapwright::robot::FoundRobot& robot);  // Enter, double-click

 private:
  void refresh();
  void fill();
  QString noneReason() const;

  const robot::Addresses& addresses_;
  QLabel* state_;
  QListWidget* list_;
  QToolButton* details_;
  QPlainTextEdit* reasons_;
  QString called_;
  bool stopped_ = false;
  std::vector<robot::FoundRobot> found_;
  std::unique_ptr<jobs::RobotSearch> search_;  // goes first: it tells the others
};

}  // namespace mapwright::ui
