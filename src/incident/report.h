// What a bag tells of one moment, and the report that people read. Pure: the same values give the same bytes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QByteArray>
#include <QIODevice>
#include <QJsonObject>
#include <QSize>
#include <QString>
#include <QStringList>

#include "incident/conditions.h"
#include "incident/curves.h"
#include "incident/on_the_way.h"
#include "map/live_state.h"
#include "replay/events.h"
#include "robot/bag_library.h"

namespace mapwright::incident {

/// One run at its moment.
struct Run {
  std::string name;  // of the bag; untrusted
  double at_s = 0;   // seconds since the epoch
  robot::BagInfo info;
  map::LiveState live;
  Conditions conditions;                      // what the robot says of its safety
  std::vector<map::OverlayFeature> overlays;  // of the map
  std::string map_name;                       // untrusted; empty: none is known
  bool map_of_now = false;                    // the map drawn is the robot's present one, not of the bag
  std::map<std::string, double> topics;       // the stamp of the last message of each until then
  std::map<std::size_t, double> first_s;      // by kind of message (map::topicIndex): the bag's first
  std::vector<replay::Event> events;          // of the bag until the end of the minute
  std::vector<Curve> curves;
  /// The last messages of topics about bumpers and stops that are not understood, as sent.
  std::map<std::string, std::string> said;
  QByteArray picture;  // a PNG of the map around the robot; empty: there is nothing to draw
  QSize picture_px;
  QStringList remarks;  // what is not complete about it: sentences
};

struct Report {
  Run run;
  std::optional<Run> against;       // another run to compare with
  std::optional<double> against_m;  // how far its robot was from the place; nullopt: not known
  bool nearest = false;             // its moment is that at which it was nearest
};

/// What is older than this at the moment is listed with its age.
inline constexpr double kOldS = 5;

/// A jump of the position that the report names: never a later one.
struct NamedJump {
  double at_s = 0, metres = 0;
  bool with_loss = false;  // it came when localization became poor, which it still is
  bool operator==(const NamedJump&) const = default;
};
/// The one that came with the loss, and the last of the half minute before the moment; by time.
std::vector<NamedJump> namedJumps(const Run& run);

/// "2024-06-03 09:00:00.250", UTC.
QString utcText(double epoch_s);
/// A sentence if this time is outside of the bag. `rounded`: robots leave out the parts of seconds.
QString notWithinReason(const std::string& name, const robot::BagInfo& info, double at_s, bool rounded);
/// What the bag does not tell of the moment: sentences.
QStringList notKnown(const Run& run);
/// What fits together, in the words "consistent with"; what the robot says itself.
QStringList consistent(const Run& run);
/// "Virtual wall W17".
QString nameOf(const OnTheWay& thing);

/// False: `out` has not taken everything.
bool writeReport(QIODevice& out, const Report& report);
/// The same as values (docs/json.md).
QJsonObject reportJson(const Report& report);

}  // namespace mapwright::incident
