#include "jobs/robot_search.h"

#include <utility>

#include "jobs/faults.h"

namespace mapwright::jobs {

RobotSearch::RobotSearch(std::vector<robot::Probe> probes, std::chrono::milliseconds within, QObject* parent)
    : QObject(parent), waits_for_(probes.size()), asking_(new QObject(this)) {
  for (const robot::Probe& probe : probes) rows_.push_back({probe.title, probe.server, std::nullopt});
  deadline_.setSingleShot(true);
  connect(&deadline_, &QTimer::timeout, this, [this, within] { giveUp(within); });
  deadline_.start(within);
  for (std::size_t row = 0; row < probes.size(); ++row)
    probes[row].ask(asking_, within,
                    [this, row](robot::ProbeAnswer answer) { take(row, std::move(answer)); });
  if (probes.empty()) QMetaObject::invokeMethod(this, &RobotSearch::ended, Qt::QueuedConnection);
}

std::vector<robot::FoundRobot> RobotSearch::found() const {
  std::vector<robot::FoundRobot> all;
  for (const Row& row : rows_) {
    if (row.answer) all.insert(all.end(), row.answer->found.begin(), row.answer->found.end());
  }
  return all;
}

void RobotSearch::take(std::size_t row, robot::ProbeAnswer answer) {
  if (rows_[row].answer) return;
  rows_[row].answer = std::move(answer);
  --waits_for_;
  if (waits_for_ == 0) deadline_.stop();
  Q_EMIT changed();
  if (waits_for_ == 0) Q_EMIT ended();
}

void RobotSearch::giveUp(std::chrono::milliseconds within) {
  delete std::exchange(asking_, nullptr);
  const std::string seconds = QString::number(double(within.count()) / 1000).toStdString();
  for (Row& row : rows_) {
    if (!row.answer) row.answer = robot::ProbeAnswer{{}, {fault::NothingWithin, {seconds}}};
  }
  waits_for_ = 0;
  Q_EMIT changed();
  Q_EMIT ended();
}

}  // namespace mapwright::jobs

#include "moc_robot_search.cpp"
