// The picture of a map in the form that KABAM's update_map_image expects. Source:
// docs/protocols/kabam-map-manager.md, "Pictures", ROS map_server (its gray levels for free, occupied and
// unknown).
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QCryptographicHash>
#include <QObject>
#include <QTimer>

#include "grids/grid_pyramid.h"
#include "net/rosbridge/requests.h"
#include "robot/picture_store.h"
#include "robot/ros/kabam_messages.h"
#include "robot/ros/kabam_requests.h"
#include "robot/ros/live_map.h"
#include "robot/wire/task.h"

namespace mapwright::robot::ros {

/// The gray of a cell of CellCode::Occupancy: 254 free, 0 occupied, 205 unknown, which map_server reads the
/// same in all its modes. nullopt: a value in between, whose gray would be read differently by each mode.
std::optional<std::uint8_t> shadeOf(std::uint8_t cell);

/// The arguments of update_map_image, one band of rows after the other, so that neither the picture nor its
/// text is ever in memory as a whole. One thread.
class PictureArgs : public net::rosbridge::ArgsSource {
 public:
  /// `cells`: complete, of CellCode::Occupancy. `wanted` is called before each band: false ends it.
  PictureArgs(const KabamMap& map, std::shared_ptr<const grids::GridPyramid> cells,
              std::function<bool()> wanted);

  qint64 bytes() const override;
  std::optional<QByteArray> next() override;

  /// The cell without a gray level that ended it; nullopt: none.
  std::optional<std::uint8_t> cellBetween() const { return between_; }
  /// Once all has been handed out: wire::fingerprint of pgmOf() of these cells, as a topic brings them.
  const std::string& fingerprint() const { return fingerprint_; }

 private:
  bool makeBand();

  std::shared_ptr<const grids::GridPyramid> cells_;
  std::function<bool()> wanted_;
  QByteArray head_, shades_;  // shades_ waits for a third one: base64 takes three at a time
  int row_ = 0;
  bool began_ = false;
  std::optional<std::uint8_t> between_;
  QCryptographicHash hash_{QCryptographicHash::Sha1};
  std::string fingerprint_;
};

/// How many cells of a PGM from pgmOf() differ from these; nullopt: another size, or not a PGM.
std::optional<std::int64_t> differingCells(const grids::GridPyramid& cells, const std::string& pgm);

/// Reads the picture again, compares it with the version that was edited, sends the new one and reads it
/// back, all through the map's topic. There is no locking, so a change by others in between is only found
/// afterwards.
class KabamPictures : public QObject {
  Q_OBJECT
 public:
  /// All of them outlive this. `ask_again`: requests the map's topic once more.
  struct Parts {
    net::rosbridge::Client& client;
    KabamRequests& requests;
    LiveMap& live_map;
    std::function<void()> ask_again;
    std::function<bool()> known;  // what the robot has, on this connection
  };
  /// Which map a picture is of is told by another topic, before it or after it: after `settles` both have
  /// come.
  KabamPictures(Parts parts, KabamTimeouts timeouts, std::chrono::milliseconds settles);

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
  void onAnswer(const WritingPtr& writing, const net::rosbridge::CallAnswer& answer);
  void confirm(const WritingPtr& writing);
  void giveUp(const WritingPtr& writing);
  void doubt(const std::string& map_id);
  void compare();
  bool shows(const std::string& fingerprint) const;
  std::optional<map::Failure> conflict(const Writing& writing) const;
  void end(const WritingPtr& writing, Outcome<PictureReceipt> outcome);

  Parts of_;
  KabamTimeouts timeouts_;
  wire::WaitList waits_;
  QTimer settle_;
  std::map<std::string, std::string> seen_;  // fingerprints, by map
  std::set<std::string> doubted_;            // maps whose picture is to be looked at anew
};

}  // namespace mapwright::robot::ros
