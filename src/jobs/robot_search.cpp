#include "jobs/robot_search.h"

#include <map>
#include <string>
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
                    [this, row](robot::ProbeAnswer answer) { onAnswer(row, std::move(answer)); });
  if (probes.empty()) QMetaObject::invokeMethod(this, &RobotSearch::ended, Qt::QueuedConnection);
}

std::vector<robot::FoundRobot> RobotSearch::found() const {
  std::vector<robot::FoundRobot> all;
  for (const Row& row : rows_) {
    if (row.answer) all.insert(all.end(), row.answer->found.begin(), row.answer->found.end());
  }
  return all;
}

const RobotSearch::Row* RobotSearch::mostTelling() const {
  const Row* best = nullptr;
  std::map<std::string, int> as_often;
  const auto weight = [&](const Row& row) {
    return row.answer->somebody ? int(rows_.size()) + 1 : as_often[patternOf(row.answer->reason)];
  };
  const auto says = [](const Row& row) { return row.answer && row.answer->reason.any(); };
  for (const Row& row : rows_) {
    if (says(row)) ++as_often[patternOf(row.answer->reason)];
  }
  for (const Row& row : rows_) {
    if (says(row) && (!best || weight(row) > weight(*best))) best = &row;
  }
  return best;
}

void RobotSearch::onAnswer(std::size_t row, robot::ProbeAnswer answer) {
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
    if (!row.answer)
      row.answer = robot::ProbeAnswer{{}, {faultText("jobs", "no answer within %1 s"), {seconds}}};
  }
  waits_for_ = 0;
  Q_EMIT changed();
  Q_EMIT ended();
}

}  // namespace mapwright::jobs

#include "moc_robot_search.cpp"
