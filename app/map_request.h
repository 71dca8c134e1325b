// The whole map that a command asked for: opened in its session, and never mistaken for another one.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>

#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "app/commands.h"
#include "map/map_part.h"
#include "render/sample_grid.h"
#include "robot/call.h"
#include "session/session_options.h"

namespace mapwright::map {
struct MapInfo;
}

namespace mapwright::app {

/// --region: "X,Y,LX,LY", the centre and the side lengths in metres. The error is a sentence.
tl::expected<map::GridRegion, QString> gridRegionFrom(const std::string& typed);

/// The map that messages name, if it is not available itself; empty: none.
QStringList namedMapSentence(const std::optional<map::MapInfo>& named);
/// States that there is no map, and which one the messages name.
QString noMapSentence(const std::optional<map::MapInfo>& named);

/// The session must not open maps by itself (session::Session::Options::maps).
class MapRequest {
 public:
  /// `id`: as typed; "" = the live map, or else the current one. `with_points`: also waits for its waypoints.
  MapRequest(session::Session& session, QString id, bool with_points);

  enum class State { Waiting, Here, Failed };
  /// Takes the next step. Call it while online, whenever something may have changed.
  State look(double online_for_s);
  /// How long to wait for a live map before the current stored one is drawn: this, or the usual time if that
  /// is shorter.
  void setLiveTimeout(double seconds) { live_within_s_ = std::min(live_within_s_, seconds); }
  /// Allows fetching the whole map of a robot that sends its map by region, whatever its size; otherwise that
  /// is a failure that suggests --region.
  void agreeToWhole() { whole_agreed_ = true; }
  /// Why the state is Failed.
  const CommandFailure& failure() const { return failure_; }

  /// Which map it is, as soon as that is known.
  const std::optional<map::MapKey>& key() const { return key_; }
  /// The cells of that map read so far; nullopt while there are none, or if another map is open.
  std::optional<render::PlacedGrid> grid() const;
  /// It has been read completely, and it is the requested one.
  bool complete() const;
  /// Known problems of the live map: sentences, most severe first.
  QStringList liveTroubles() const;
  /// Remarks to print along with the picture.
  const QStringList& notes() const { return notes_; }

 private:
  void choose();
  /// Chooses the robot's current map, or its only one.
  void chooseCurrent();
  void chooseInsteadOfLive();
  QString noMapNow() const;
  void open(const map::MapKey& key);
  /// From a dispatcher; fails unless agreeToWhole() was called.
  void askForWhole();
  void onWhole(const robot::Outcome<map::GridPart>& outcome);
  /// Requests the catalogue; false while it has not arrived, or cannot be loaded.
  bool catalogueIn();
  void fail(int exit_code, const QString& sentence);
  void failWithoutLive(const QString& sentence);
  bool shown() const;
  bool local() const;
  bool sendsMaps() const { return session_.robot().liveTopics() != nullptr; }

  session::Session& session_;
  QString id_;
  bool with_points_;
  std::optional<map::MapKey> key_;
  bool failed_ = false, live_broken_ = false, whole_agreed_ = false;
  bool asked_for_whole_ = false;         // from a dispatcher: no time limit for the live map then
  std::shared_ptr<const bool> present_;  // lives as long as this object
  double live_within_s_ = 8;
  CommandFailure failure_;
  QStringList notes_;
};

}  // namespace mapwright::app
