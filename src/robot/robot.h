// The port: what mapwright can ask of any robot. Adapters live in src/robot/<backend>/.
//
// A robot is a set of capabilities (architecture, decision 1). A capability that a robot lacks is a null
// pointer; whyNot() says why, for a tooltip. All members are called on the thread that made the object (the
// GUI thread, or the command line's main thread), all signals and callbacks arrive there; adapters do their
// network work on threads of their own.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QByteArray>
#include <QDateTime>
#include <QMetaType>
#include <QObject>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "map/catalogue.h"
#include "map/live_topics.h"
#include "map/problem.h"
#include "map/submap.h"
#include "map/waypoint.h"

namespace mapwright::robot {

enum class ConnectionPhase {
  Offline,      // not asked to connect, or told to stop
  Connecting,   // first attempt under way
  Online,       // live messages can arrive
  Interrupted,  // was online or failed to get there; will try again by itself
  Refused,      // will not try again by itself (bad secret, not such a robot)
};

/// A certificate that is not accepted, for people to decide on. Names in it are untrusted plain text.
struct UntrustedCertificate {
  QString host;           // "10.0.0.7:8443"
  QString why;            // "it is self-signed; it has expired on 2024-05-01"
  QString sha256;         // "AB:CD:…"
  QString pinned_sha256;  // of the one that was trusted so far; empty = none
  QString subject, issuer;
  QDateTime from, until;
  bool trustable = false;  // it may be trusted all the same
  bool operator==(const UntrustedCertificate&) const = default;
};

/// The state of the link, to be visible at all times.
struct ConnectionState {
  ConnectionPhase phase = ConnectionPhase::Offline;
  QString reason;                    // plain text, why it is not online; empty when online
  int attempt = 0;                   // tries since it was last online
  std::optional<int> retry_in_ms;    // while Interrupted: how long until the next try (as of now)
  std::optional<int> round_trip_ms;  // last measured ping
  map::FailureKind failure = map::FailureKind::None;     // what kind of reason it is; None when online
  std::optional<UntrustedCertificate> certificate = {};  // of FailureKind::Certificate
  bool operator==(const ConnectionState&) const = default;
};

/// What a robot says of itself; empty where it said nothing. Untrusted plain text.
struct RobotIdentity {
  QString model, serial, name, version;
  bool operator==(const RobotIdentity&) const = default;
};

/// Capability: textures of submaps, on demand.
class SubmapSource {
 public:
  using Reply = std::function<void(map::SubmapAnswer)>;
  virtual ~SubmapSource() = default;
  /// Asks for one submap. `reply` is called exactly once, later, never from within fetch().
  virtual void fetch(const map::SubmapKey& key, Reply reply) = 0;
  /// Aborts the fetches of all keys of `uuid`, or of one key; their replies come with Outcome::Cancelled.
  virtual void cancelAll() = 0;
  virtual void cancel(const map::SubmapKey& key) = 0;
  /// The answer for `key`, which said that it was of `answered_version`, cannot be decoded: it is kept
  /// nowhere, and the next fetch of the key asks the robot itself.
  virtual void discard(const map::SubmapKey& /*key*/, std::int32_t /*answered_version*/) {}
};

/// What an asynchronous question ended in: the answer, or what went wrong with whom.
template <typename T>
using Answer = tl::expected<T, map::Problem>;
/// Called exactly once, later, never from within the question; never after the robot is gone.
template <typename T>
using AnswerTo = std::function<void(Answer<T>)>;

/// Capability: which maps the robot keeps. Asking changes nothing on the robot.
class MapCatalogue {
 public:
  virtual ~MapCatalogue() = default;
  /// All maps and mapping results, the current one marked. A part that failed (say, the mappings) is a
  /// problemFound(); the answer holds the rest.
  virtual void list(AnswerTo<std::vector<map::CatalogueEntry>> reply) = 0;
  /// More about one: the grid, dates, versions.
  virtual void describe(const map::MapKey& key, AnswerTo<map::CatalogueEntry> reply) = 0;
  /// A small picture of it (PNG).
  virtual void thumbnail(const map::MapKey& key, AnswerTo<std::string> reply) = 0;
  /// That picture cannot be decoded: it is kept nowhere.
  virtual void discardThumbnail(const map::MapKey& /*key*/) {}
};

/// Capability: whole maps as pictures.
class WholeMapSource {
 public:
  virtual ~WholeMapSource() = default;
  /// A stored map, a mapping result or the file, whole. MapKind::Live comes as a topic (map::GridMessage).
  virtual void fetch(const map::MapKey& key, AnswerTo<map::WholeMap> reply) = 0;
  /// The present SLAM map as one picture at a resolution of the asker's choice, where offered.
  virtual bool offersOverview() const { return false; }
  virtual void fetchOverview(double resolution_m, AnswerTo<map::WholeMap> reply);
  /// The picture of this fingerprint, of a map or of a topic, cannot be read to its end: it is kept nowhere,
  /// and the robot itself is asked the next time.
  virtual void discardPicture(const std::string& /*fingerprint*/) {}
};

/// Capability: the named places of a map (read only).
class WaypointSource {
 public:
  virtual ~WaypointSource() = default;
  virtual void waypoints(const map::MapKey& key, AnswerTo<map::WaypointList> reply) = 0;
};

/// One message as it came, for the raw-message inspector.
struct RawMessage {
  QString topic;
  QDateTime received;
  qint64 bytes = 0;  // on the wire
  bool binary = false;
  QByteArray
      text;  // JSON as sent; binary ones as readable JSON where known, else a hex dump; cut at kMaxRawText
};
inline constexpr qsizetype kMaxRawText = qsizetype(1) << 20;

/// Capability: live topics. Messages come by Robot::topicReceived.
class LiveTopics {
 public:
  virtual ~LiveTopics() = default;
  /// Topics that this adapter understands, for completion and layers.
  virtual QStringList known() const = 0;
  /// Enables exactly these (any names, known or not), besides the basics. Kept over reconnects.
  virtual void setWanted(const QStringList& topics) = 0;
  /// What a robot is asked for besides: a command that shows none of it does without.
  struct Basics {
    bool submaps = true;  // the list of them
    bool pose = true;     // where it is, and its outline
    bool state = true;    // what its localisation does
    bool operator==(const Basics&) const = default;
  };
  /// To be told before connecting; without a word everything is asked for.
  virtual void setBasics(const Basics&) {}
  /// While on, every message (also of unknown topics) is reported by Robot::rawReceived.
  virtual void setWatching(bool on) = 0;
};

class Robot : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  virtual QString address() const = 0;  // as the user may type it again; never holds a secret
  virtual void connectToRobot() = 0;    // also "retry now" while interrupted
  virtual void disconnectFromRobot() = 0;
  /// From now on exactly the certificate with this SHA-256 ("AB:CD:…") is accepted, and no other; connects.
  /// Robots without certificates ignore it.
  virtual void trustCertificate(const QString& sha256);
  virtual ConnectionState connection() const = 0;
  virtual RobotIdentity identity() const = 0;

  virtual SubmapSource* submapSource() { return nullptr; }
  virtual MapCatalogue* mapCatalogue() { return nullptr; }
  virtual WholeMapSource* wholeMapSource() { return nullptr; }
  virtual WaypointSource* waypointSource() { return nullptr; }
  virtual LiveTopics* liveTopics() { return nullptr; }

  /// Why a capability is absent or limited, for the window ("This robot's maps can only be looked at: …");
  /// empty when there is nothing to say.
  virtual QString limits() const { return {}; }

 Q_SIGNALS:
  void connectionChanged();
  void identityChanged();
  void topicReceived(const mapwright::map::TopicMessage& message);
  void problemFound(const mapwright::map::Problem& problem);
  /// What problemFound() told of is well again.
  void recovered(const mapwright::map::Recovery& recovery);
  void rawReceived(const mapwright::robot::RawMessage& message);
  /// The list of maps, the current one, or a local file's content may have changed: ask again.
  void mapsChanged();
};

}  // namespace mapwright::robot

Q_DECLARE_METATYPE(mapwright::map::TopicMessage)
Q_DECLARE_METATYPE(mapwright::map::Problem)
Q_DECLARE_METATYPE(mapwright::map::Recovery)
Q_DECLARE_METATYPE(mapwright::map::SubmapAnswer)
Q_DECLARE_METATYPE(mapwright::robot::ConnectionState)
Q_DECLARE_METATYPE(mapwright::robot::RobotIdentity)
Q_DECLARE_METATYPE(mapwright::robot::RawMessage)
