// Requests for an Autoxing robot's bags. Lives on the link's thread. Source: docs/protocols/autoxing.md,
// "Bags".
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QObject>
#include <QThreadPool>

#include "robot/axbot/robot_urls.h"
#include "robot/bag_library.h"
#include "robot/wire/task.h"

namespace mapwright::robot::axbot {

class BagRequests {
 public:
  using Task = wire::TaskPtr;
  /// `recording_patience`: how long a new recording may take to be listed.
  BagRequests(RobotServer server, std::chrono::milliseconds recording_patience);
  ~BagRequests();

  void list(const Task& task, OutcomeTo<std::vector<BagEntry>> reply);
  void info(const Task& task, const BagKey& key, OutcomeTo<BagInfo> reply);
  /// The answer is parsed on another thread: it may be long, and live messages need this one.
  void messages(const Task& task, const BagKey& key, const BagRange& range, OutcomeTo<BagChunkPtr> reply);
  void picture(const Task& task, const std::string& topic, const std::string& url,
               OutcomeTo<std::shared_ptr<const std::string>> reply);
  /// Sent once; then it has to be listed, whatever the robot answered. Else it is Applied::Maybe.
  void record(const Task& task, const BagOrder& order, OutcomeTo<BagEntry> reply);
  /// Only what the robot lists is deleted; then it must no longer be listed, whatever the robot answered.
  void remove(const Task& task, const BagKey& key, OutcomeTo<BagKey> reply);
  /// First to `path`.part, which stays after an interruption: the next attempt resumes there if the robot
  /// supports it (206) and the file is the same by its ETag, or by its row in the last result of list() (size
  /// and end); otherwise it starts over (200, 416).
  void download(const Task& task, const BagKey& key, const QString& path, OutcomeTo<BagDownload> reply);

 private:
  struct Recording;
  struct BothRows {
    std::vector<BagEntry> all;  // bags, then recordings
    std::vector<map::Failure> failures;
  };
  void rows(const Task& task, BagKind kind, OutcomeTo<std::vector<BagEntry>> reply);
  void bothRows(const Task& task, std::function<void(BothRows)> reply);
  void send(const std::shared_ptr<Recording>& recording, const BagOrder& order);
  void look(const std::shared_ptr<Recording>& recording);
  void removeListed(const Task& task, const BagKey& key, OutcomeTo<BagKey> reply);

  const RobotServer server_;
  const std::chrono::milliseconds recording_patience_;
  QObject context_;  // results return to its thread
  QThreadPool reading_;
  std::vector<BagEntry> listed_;  // the last list
};

}  // namespace mapwright::robot::axbot
