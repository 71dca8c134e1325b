// Replaces the picture of a KABAM robot's current map. On the link's thread. Source:
// docs/protocols/kabam-map-manager.md, "Pictures".
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <QObject>
#include <QTimer>

#include "robot/picture_store.h"
#include "robot/ros/kabam_picture.h"
#include "robot/ros/kabam_requests.h"
#include "robot/ros/live_map.h"
#include "robot/wire/task.h"

namespace mapwright::robot::ros {

/// Reads the picture again, compares it with the version that was edited, sends the new one and reads it
/// back, all through the map's topic. There is no locking, so a change by others in between is only found
/// afterwards.
class KabamPictures : public QObject {
  Q_OBJECT
 public:
  /// What it uses; all of it outlives this. `ask_again`: requests the map's topic once more.
  struct Means {
    net::rosbridge::Client& client;
    KabamRequests& requests;
    LiveMap& live_map;
    std::function<void()> ask_again;
    std::function<bool()> known;  // what the robot has, on this connection
  };
  /// Which map a picture is of is told by another topic, before it or after it: after `settles` both have
  /// come.
  KabamPictures(Means means, KabamPatience patience, std::chrono::milliseconds settles);

  void write(const wire::TaskPtr& task, const PictureChange& change, OutcomeTo<PictureReceipt> reply);

  /// A picture has come, or which map it is of was told.
  void sawMap() { settle_.start(); }

 Q_SIGNALS:
  /// The picture of this map is another one, or may not be what somebody here takes it for.
  void changed(const QString& map_id);

 private:
  struct Writing {
    PictureChange change;
    OutcomeTo<PictureReceipt> reply;
    wire::TaskPtr task;
    std::string name;
    std::shared_ptr<void> listening;
    std::shared_ptr<PictureArgs> args;
    bool changed_meanwhile = false;
    std::optional<map::Failure> doubt;  // the failure, unless the map shows the change
    std::chrono::milliseconds within{0};
    bool confirming = false;
    map::Subject subject() const { return map::subjectOf(change.map, name); }
  };
  using WritingPtr = std::shared_ptr<Writing>;

  void readAgain(const WritingPtr& writing);
  void send(const WritingPtr& writing);
  void takeAnswer(const WritingPtr& writing, const net::rosbridge::CallAnswer& answer);
  void confirm(const WritingPtr& writing);
  void giveUp(const WritingPtr& writing);
  void doubt(const std::string& map_id);
  void compare();
  bool shows(const std::string& fingerprint) const;
  std::optional<map::Failure> conflict(const Writing& writing) const;
  void end(const WritingPtr& writing, Outcome<PictureReceipt> outcome);

  Means means_;
  KabamPatience patience_;
  wire::WaitList waits_;
  QTimer settle_;
  std::map<std::string, std::string> seen_;  // fingerprints, by map
  std::set<std::string> doubted_;            // maps whose picture is to be looked at anew
};

}  // namespace mapwright::robot::ros
