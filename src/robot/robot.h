// The port: everything mapwright can ask of any robot. Adapters are in src/robot/<backend>/.
// A robot is a set of capabilities (docs/decisions/0003-one-port-for-all-robots.md), each an object owned by
// the robot. A missing capability is a null pointer; unavailableReason() gives the reason, for a tooltip.
// Capabilities may appear and disappear while connected: get the pointers again after capabilitiesChanged().
// All members are called on the thread that made the robot (the GUI thread, or the command line's main
// thread), all signals and callbacks arrive there; adapters do their network work on their own threads. Every
// request returns a Call and ends exactly once, later: with a value, or with a map::Failure that gives its
// kind and, for a change, whether it was applied (robot/call.h). tests/robot/contract checks what every
// adapter must fulfil.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QByteArray>
#include <QDateTime>
#include <QObject>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "map/catalogue.h"
#include "map/problem.h"
#include "map/stream.h"
#include "map/submap.h"
#include "map/waypoint.h"
#include "robot/call.h"

namespace mapwright::map {
struct StampedMessage;
}

namespace mapwright::robot {

/// What robots can be asked for. The room `sentences` makes the texts for why one cannot.
enum class Capability {
  Submaps,          // SubmapSource
  Catalogue,        // MapCatalogue
  WholeMaps,        // WholeMapSource
  Overview,         // OverviewSource
  Waypoints,        // WaypointSource
  WaypointEditing,  // WaypointStore
  Live,             // LiveTopics
  Administration,   // MapAdministration
  PictureEditing,   // PictureStore
  OverlayEditing,   // OverlayStore
  Bags,             // BagLibrary
  Dispatch,         // MapDispatch
  Localization,     // Localization
  MapTransfer,      // MapTransfer
  PoseGraph,        // PoseGraphSource
};

/// Why a robot lacks a capability.
struct Absence {
  enum class Reason {
    NotOfThisKind,  // robots of this kind never have it
    ReadOnly,       // the maker's interface is read-only; arguments[0] is the maker
    NotYetHere,     // robots of this kind have it, but this version of the program does not support it
    FirmwareLacks,  // this one answered that it does not support it; arguments[0] is its answer
    NotToldYet,     // it was asked whether it has it, and has not answered; it is asked again
    LocalFiles,     // there is no robot
    NoService,      // others of the kind run a service for it; arguments[0] is what is missing here
  };
  Reason reason = Reason::NotOfThisKind;
  std::vector<std::string> arguments = {};
  bool operator==(const Absence&) const = default;
};

enum class ConnectionPhase {
  Offline,      // not asked to connect, or told to stop
  Connecting,   // first attempt in progress
  Online,       // live messages can arrive
  Interrupted,  // was online or failed to connect; retries automatically
  Refused,      // does not retry automatically (bad secret, not such a robot)
};

/// A rejected certificate, for the user to decide. Names in it are untrusted plain text.
struct UntrustedCertificate {
  QString host;            // "10.0.0.7:8443"
  std::vector<Fault> why;  // "it is self-signed", "it expired on 2024-05-01"
  QString sha256;          // "AB:CD:…"
  QString pinned_sha256;   // of the one trusted so far; empty = none
  QString subject, issuer;
  QDateTime from, until;
  bool trustable = false;  // the user may trust it anyway
  bool operator==(const UntrustedCertificate&) const = default;
};

/// The state of the connection, always visible to the user.
struct ConnectionState {
  ConnectionPhase phase = ConnectionPhase::Offline;
  Fault reason;                      // why it is not online; None if online
  int attempt = 0;                   // attempts since it was last online
  std::optional<int> retry_in_ms;    // while Interrupted: time until the next attempt (as of now)
  std::optional<int> round_trip_ms;  // last measured ping
  map::FailureKind failure = map::FailureKind::None;     // the kind of reason; None if online
  std::optional<UntrustedCertificate> certificate = {};  // of FailureKind::Certificate
  bool operator==(const ConnectionState&) const = default;
};

/// What a robot says about itself; empty if it says nothing. Untrusted plain text.
struct RobotIdentity {
  QString model, serial, name, version;
  bool operator==(const RobotIdentity&) const = default;
};

/// Capability: textures of submaps, on demand.
class SubmapSource {
 public:
  using Reply = std::function<void(map::SubmapAnswer)>;
  virtual ~SubmapSource() = default;
  /// Requests one submap. `reply` is called exactly once, later, never from within fetch(); never after the
  /// robot is gone. If cancelled, with Outcome::Cancelled.
  virtual Call fetch(const map::SubmapKey& key, Reply reply) = 0;
  /// The same as cancelling all calls, or those of one key.
  virtual void cancelAll() = 0;
  virtual void cancel(const map::SubmapKey& key) = 0;
  /// The answer for `key`, with `answered_version`, cannot be decoded: it is not cached, and the next fetch
  /// of the key asks the robot itself.
  virtual void discard(const map::SubmapKey& /*key*/, std::int32_t /*answered_version*/) {}
};

/// Capability: the maps stored on the robot. Requests change nothing on the robot.
class MapCatalogue {
 public:
  virtual ~MapCatalogue() = default;
  /// All maps and mapping results, with the current one marked. If a part fails (such as the mappings)
  /// problemFound() is emitted, and the answer contains the rest.
  virtual Call list(OutcomeTo<std::vector<map::CatalogueEntry>> reply) = 0;
  /// More about one map: grid, dates, versions.
  virtual Call describe(const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) = 0;
  /// A thumbnail (PNG).
  virtual Call thumbnail(const map::MapKey& key, OutcomeTo<std::string> reply) = 0;
  /// That picture cannot be decoded: do not cache it.
  virtual void discardThumbnail(const map::MapKey& /*key*/) {}
};

/// Capability: whole maps as pictures.
class WholeMapSource {
 public:
  virtual ~WholeMapSource() = default;
  /// A stored map, a mapping result or the file, complete. MapKind::Live comes as a topic (map::GridMessage).
  virtual Call fetch(const map::MapKey& key, OutcomeTo<map::WholeMap> reply) = 0;
  /// The picture with this fingerprint, of a map or a topic, is damaged: do not cache it, and ask the robot
  /// itself the next time.
  virtual void discardPicture(const std::string& /*fingerprint*/) {}
};

/// Capability: the present SLAM map as one picture, at any resolution (metres per cell).
class OverviewSource {
 public:
  virtual ~OverviewSource() = default;
  virtual Call fetchOverview(double resolution_m, OutcomeTo<map::WholeMap> reply) = 0;
};

/// Capability: the waypoints of a map (read-only).
class WaypointSource {
 public:
  virtual ~WaypointSource() = default;
  virtual Call waypoints(const map::MapKey& key, OutcomeTo<map::WaypointList> reply) = 0;
};

/// One message as received, for the raw-message inspector.
struct RawMessage {
  QString topic;
  QDateTime received;
  qint64 bytes = 0;  // on the wire
  bool binary = false;
  QByteArray text;  // JSON as sent; binary messages as readable JSON if known, otherwise as a hex dump;
                    // truncated at kMaxRawText
};
inline constexpr qsizetype kMaxRawText = qsizetype(1) << 20;

/// A frame as received, before it is parsed, dropped or replaced by a newer one.
struct RawFrame {
  std::string_view bytes;  // valid during the call only
  bool binary = false;
  double received_s = 0;  // seconds since the epoch
};
/// Called on a thread of the adapter, for one frame after the other.
using FrameTap = std::function<void(const RawFrame&)>;

/// Capability: data that the robot sends by itself. Messages arrive by Robot::topicReceived with their
/// stamps.
/// Layers and panels request kinds of data (map::Stream); the adapter chooses the topics, including the names
/// used by older firmware if the newer ones stay silent. Topic names are the robot's own: callers only show
/// and compare them.
class LiveTopics {
 public:
  virtual ~LiveTopics() = default;
  /// Topics that this adapter can parse, for completion.
  virtual QStringList known() const = 0;
  /// All topics that can carry `stream`, the usual one first; none = it is not available.
  virtual QStringList topicsOf(map::Stream stream) const = 0;
  /// Subscribes to exactly these streams and topics (any names, known or not), besides the basics. Kept
  /// across reconnects.
  virtual void setWanted(const map::Streams& streams, const QStringList& topics) = 0;
  /// What else to subscribe to: commands that show none of it can do without.
  struct Basics {
    bool submaps = true;  // the submap list
    bool pose = true;     // the pose and the footprint
    bool state = true;    // the state of localization
    bool operator==(const Basics&) const = default;
  };
  /// Call it before connecting; by default all basics are subscribed.
  virtual void setBasics(const Basics&) {}
  /// While on, every message (also of unknown topics) is reported by Robot::rawReceived.
  virtual void setWatching(bool on) = 0;
  /// From now on every frame goes to `tap` first; an empty one ends it. After this returns the previous tap
  /// is no longer called. Not to be called from within a tap.
  virtual void setTap(FrameTap tap) = 0;
};

class BagLibrary;         // robot/bag_library.h
class Localization;       // robot/localization.h
class MapAdministration;  // robot/map_administration.h
class MapDispatch;        // robot/map_dispatch.h
class MapTransfer;        // robot/map_transfer.h
class OverlayStore;       // robot/overlay_store.h
class PictureStore;       // robot/picture_store.h
class PoseGraphSource;    // robot/pose_graph_source.h
class WaypointStore;      // robot/waypoint_store.h

class Robot : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  virtual QString address() const = 0;  // can be typed again by the user; never contains a secret
  /// It consists of local files: problems are about these, and there is nobody to refuse anything.
  virtual bool isLocal() const { return false; }
  virtual void connectToRobot() = 0;  // also "retry now" while interrupted
  virtual void disconnectFromRobot() = 0;
  /// From now on only the certificate with this SHA-256 ("AB:CD:…") is accepted; connects. Robots without
  /// certificates ignore it.
  virtual void trustCertificate(const QString& /*sha256*/) {}
  virtual ConnectionState connection() const = 0;
  /// When the robot was last heard, if that is unusually long ago, even while Online, or while the connection
  /// is lost; invalid: all is well, it was never heard, or silence is not measured. connectionChanged()
  /// reports changes, before the loss itself.
  virtual QDateTime silentSince() const { return {}; }
  virtual RobotIdentity identity() const = 0;

  // Owned by the robot; null = absent.
  virtual SubmapSource* submapSource() { return nullptr; }
  virtual MapCatalogue* mapCatalogue() { return nullptr; }
  virtual WholeMapSource* wholeMapSource() { return nullptr; }
  virtual OverviewSource* overviewSource() { return nullptr; }
  virtual WaypointSource* waypointSource() { return nullptr; }
  virtual WaypointStore* waypointStore() { return nullptr; }
  virtual LiveTopics* liveTopics() { return nullptr; }
  virtual MapAdministration* mapAdministration() { return nullptr; }
  virtual PictureStore* pictureStore() { return nullptr; }
  virtual OverlayStore* overlayStore() { return nullptr; }
  virtual BagLibrary* bagLibrary() { return nullptr; }
  virtual MapDispatch* mapDispatch() { return nullptr; }
  virtual Localization* localization() { return nullptr; }
  virtual MapTransfer* mapTransfer() { return nullptr; }
  virtual PoseGraphSource* poseGraphSource() { return nullptr; }

  /// Why a capability is missing. Meaningless for one that exists.
  virtual Absence unavailableReason(Capability) const { return {}; }
  /// It is there, but only third parties tell of it: the robot's maker does not.
  virtual bool isUnconfirmed(Capability) const { return false; }

 Q_SIGNALS:
  void connectionChanged();
  void identityChanged();
  /// A capability has appeared or disappeared, or is missing for another reason.
  void capabilitiesChanged();
  void topicReceived(const mapwright::map::StampedMessage& message);
  void problemFound(const mapwright::map::Problem& problem);
  /// A problem reported by problemFound() is resolved.
  void recovered(const mapwright::map::Recovery& recovery);
  void rawReceived(const mapwright::robot::RawMessage& message);
  /// The list of maps, the current one, or the content of a local file may have changed: request them again.
  void mapsChanged();
};

/// nullopt: invalid, as above.
inline std::optional<QDateTime> silentSince(const Robot& robot) {
  const QDateTime since = robot.silentSince();
  return since.isValid() ? std::optional(since) : std::nullopt;
}

}  // namespace mapwright::robot
