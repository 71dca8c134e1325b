// Replaces the picture of a KABAM robot's current map. On the link's thread. Source:
// docs/protocols/kabam-map-manager.md, "Pictures".
#pragma once

#include <chrono>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>

#include <QObject>
#include <QTimer>

#include "robot/picture_store.h"
#include "robot/ros/kabam_picture.h"
#include "robot/ros/kabam_requests.h"
#include "robot/ros/live_map.h"

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
  };
  KabamPictures(Means means, KabamPatience patience, QObject* parent = nullptr);

  void write(const wire::ErrandPtr& errand, const PictureChange& change, OutcomeTo<PictureReceipt> reply);

 Q_SIGNALS:
  /// The stored picture of this map may differ from what is shown here.
  void doubted(const std::string& map_id);

 private:
  struct Writing {
    PictureChange change;
    OutcomeTo<PictureReceipt> reply;
    wire::ErrandPtr errand;
    std::string name;
    std::shared_ptr<void> listening;
    std::shared_ptr<PictureArgs> args;
    bool changed_meanwhile = false;
    std::optional<map::Failure> doubt;  // the failure, unless the map shows the change
    std::chrono::milliseconds within{0};
    std::unique_ptr<QTimer> halfway, patience;
    int number = 0;  // of the errand
    map::Subject subject() const { return map::subjectOf(change.map, name); }
  };
  using WritingPtr = std::shared_ptr<Writing>;

  void readAgain(const WritingPtr& writing);
  void send(const WritingPtr& writing);
  void takeAnswer(const WritingPtr& writing, const net::rosbridge::CallAnswer& answer);
  void confirm(const WritingPtr& writing);
  void look();
  void giveUp(const WritingPtr& writing);
  bool finishConfirming(const WritingPtr& writing);
  bool shows(const std::string& fingerprint) const;
  std::optional<map::Failure> conflict(const Writing& writing) const;
  void end(const WritingPtr& writing, Outcome<PictureReceipt> outcome);

  Means means_;
  KabamPatience patience_;
  std::list<WritingPtr> confirming_;
};

}  // namespace mapwright::robot::ros
