// The one whole map that a command was asked for: brought onto its session, and no other taken for it.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>

#include <QString>
#include <QStringList>

#include "app/command_failure.h"
#include "map/map_part.h"
#include "render/sample_grid.h"
#include "robot/call.h"
#include "session/session.h"

namespace mapwright::app {

/// Which map messages name, where it is not there itself; empty: none.
QStringList namedMapSentence(const std::optional<map::MapInfo>& named);
/// That there is no map, and which one is named.
QString noMapSentence(const std::optional<map::MapInfo>& named);

/// The session must not open maps by itself (session::Session::Options::maps).
class MapWish {
 public:
  /// `id`: as people type it; "" = the map that the robot sends, else its current one. `with_points`: its
  /// waypoints are waited for too.
  MapWish(session::Session& session, QString id, bool with_points);

  enum class State { Waiting, Here, Failed };
  /// Takes the next step that is due. To be called, while online, whenever something may have changed.
  State look(double online_for_s);
  /// How long a robot that can send its map may take for it before its current stored one is drawn: this, or
  /// the usual time where that is shorter.
  void setPatience(double seconds) { live_within_s_ = std::min(live_within_s_, seconds); }
  /// Of a robot that gives its map by regions all of it is asked for at once, however large; without this,
  /// that is a failure that names the regions.
  void agreeToWhole() { whole_agreed_ = true; }
  /// Why it Failed.
  const CommandFailure& failure() const { return failure_; }

  /// Which map it is, once that is known.
  const std::optional<map::MapKey>& key() const { return key_; }
  /// The cells of that map as far as they have been read; nullopt while there are none, or those of another.
  std::optional<render::PlacedGrid> grid() const;
  /// It is read to its end, and is what was to be had.
  bool complete() const;
  /// What is known to be wrong with the map that the robot sends: sentences, the gravest first.
  QStringList liveTroubles() const;
  /// What is to be said beside the picture.
  const QStringList& notes() const { return notes_; }

 private:
  void choose();
  /// The robot's current map, or its only one.
  void chooseCurrent();
  void chooseInsteadOfLive();
  QString noMapNow() const;
  void open(const map::MapKey& key);
  /// Of a dispatcher; fails where nobody has agreed to that.
  void askForWhole();
  void takeWhole(const robot::Outcome<map::GridPart>& outcome);
  /// Asks for the catalogue; false while it is on its way, or cannot be had.
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
  bool asked_for_whole_ = false;         // of a dispatcher: there is nothing to be patient about
  std::shared_ptr<const bool> present_;  // as long as this is
  double live_within_s_ = 8;
  CommandFailure failure_;
  QStringList notes_;
};

}  // namespace mapwright::app
