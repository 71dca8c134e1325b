// Looks which robots answer at a host: every kind at once, within a bounded time. Without a secret, and
// nothing is changed.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include <QObject>
#include <QTimer>

#include "robot/probe.h"

namespace mapwright::jobs {

class RobotSearch : public QObject {
  Q_OBJECT
 public:
  /// One server that is asked for one kind.
  struct Row {
    QString title;
    QUrl server;
    std::optional<robot::ProbeAnswer> answer;  // nullopt: not yet
  };

  /// Begins at once; destroying it ends it, and tells nothing more.
  RobotSearch(std::vector<robot::Probe> probes, std::chrono::milliseconds within, QObject* parent = nullptr);

  const std::vector<Row>& rows() const { return rows_; }
  bool over() const { return waits_for_ == 0; }
  /// In the order in which kinds were asked for, not in that of their answers.
  std::vector<robot::FoundRobot> found() const;
  /// Of those where there is no robot, the one that says most: something else answers there, or else the
  /// reason that most have. Null: nothing has said why.
  const Row* mostTelling() const;

 Q_SIGNALS:
  void changed();  // something answered
  void ended();    // everything did, or the time is over

 private:
  void onAnswer(std::size_t row, robot::ProbeAnswer answer);
  void giveUp(std::chrono::milliseconds within);

  std::vector<Row> rows_;
  std::size_t waits_for_;
  QTimer deadline_;
  QObject* asking_;  // a child; owns all that is in progress
};

}  // namespace mapwright::jobs
