// Requests for an Autoxing robot's bags. Lives on the link's thread. Source: docs/protocols/autoxing.md,
// "Bags".
#pragma once

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
  explicit BagRequests(RobotServer server);
  ~BagRequests();

  void list(const Task& task, OutcomeTo<std::vector<BagEntry>> reply);
  void info(const Task& task, const BagKey& key, OutcomeTo<BagInfo> reply);
  /// The answer is parsed on another thread: it may be long, and live messages need this one.
  void messages(const Task& task, const BagKey& key, const BagRange& range, OutcomeTo<BagChunkPtr> reply);
  void picture(const Task& task, const std::string& topic, const std::string& url,
               OutcomeTo<std::shared_ptr<const std::string>> reply);
  void record(const Task& task, const BagOrder& order, OutcomeTo<BagEntry> reply);
  void remove(const Task& task, const BagKey& key, OutcomeTo<BagKey> reply);
  /// First to `path`.part, which stays after an interruption: the next attempt resumes there if the robot
  /// supports it (206) and the file is the same by its ETag, or by its row in the last result of list() (size
  /// and end); otherwise it starts over (200, 416).
  void download(const Task& task, const BagKey& key, const QString& path, OutcomeTo<BagDownload> reply);

 private:
  struct Listing;
  /// What it lists tells whether a bag that was deleted is gone.
  static Outcome<BagKey> goneFrom(const net::HttpAnswer& list, const BagKey& key);
  void addRows(Listing& listing, const net::HttpAnswer& answer, BagKind kind);

  const RobotServer server_;
  QObject context_;  // results return to its thread
  QThreadPool reading_;
  std::vector<BagEntry> listed_;  // the last list
};

}  // namespace mapwright::robot::axbot
