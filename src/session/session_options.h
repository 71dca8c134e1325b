// What a session is opened with.
#pragma once

#include <functional>
#include <memory>

#include <QDateTime>
#include <QString>

#include "robot/robot.h"
#include "session/session.h"
#include "submap/fetch_scheduler.h"
#include "work/budgets.h"
#include "work/workers.h"

namespace mapwright::session {

struct Session::Options {
  submap::SchedulerOptions scheduler;
  std::shared_ptr<work::Workers> workers = {};  // null = a thread pool of its own
  /// For finished pyramids of large maps (empty = no cache), and for submaps that do not fit into memory
  /// while the program runs.
  QString sidecar_folder = {};
  work::Budgets budgets = work::budgetsFrom();  // it uses `textures` and `unpacked`
  bool overview = true;  // request a picture of the whole SLAM map while submaps are still loading
  /// What is subscribed in any case. Without `submaps` none are listed or fetched.
  robot::LiveTopics::Basics basics = {};
  bool maps = true;         // requests the catalogue and opens the first whole map automatically
  bool log_safety = false;  // problems of the robot itself are logged, too
  /// The time of day for arriving messages and for problems.
  std::function<QDateTime()> wall = [] { return QDateTime::currentDateTime(); };
  /// How long to wait for a live map before the current stored one is shown.
  int live_map_within_ms = 5'000;
};

}  // namespace mapwright::session
