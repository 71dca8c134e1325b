// The port: what mapwright can ask of any robot. Adapters live in src/robot/<backend>/.
//
// A robot is a set of capabilities (architecture, decision 1). A capability that a robot lacks is a null
// pointer; whyNot() says why, for a tooltip. All members are called on the thread that made the object (the
// GUI thread, or the command line's main thread), all signals and callbacks arrive there; adapters do their
// network work on threads of their own.
#pragma once

#include <functional>
#include <optional>

#include <QMetaType>
#include <QObject>
#include <QString>

#include "map/live_state.h"
#include "map/problem.h"
#include "map/submap.h"

namespace mapwright::robot {

enum class ConnectionPhase {
  Offline,      // not asked to connect, or told to stop
  Connecting,   // first attempt under way
  Online,       // live messages can arrive
  Interrupted,  // was online or failed to get there; will try again by itself
  Refused,      // will not try again by itself (bad secret, not such a robot)
};

/// The state of the link, to be visible at all times.
struct ConnectionState {
  ConnectionPhase phase = ConnectionPhase::Offline;
  QString reason;                    // plain text, why it is not online; empty when online
  int attempt = 0;                   // tries since it was last online
  std::optional<int> retry_in_ms;    // while Interrupted: how long until the next try (as of now)
  std::optional<int> round_trip_ms;  // last measured ping
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
};

class Robot : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  virtual QString address() const = 0;  // as the user may type it again; never holds a secret
  virtual void connectToRobot() = 0;    // also "retry now" while interrupted
  virtual void disconnectFromRobot() = 0;
  virtual ConnectionState connection() const = 0;
  virtual RobotIdentity identity() const = 0;

  virtual SubmapSource* submapSource() { return nullptr; }

 Q_SIGNALS:
  void connectionChanged();
  void identityChanged();
  void topicReceived(const mapwright::map::TopicMessage& message);
  void problemFound(const mapwright::map::Problem& problem);
};

}  // namespace mapwright::robot

Q_DECLARE_METATYPE(mapwright::map::TopicMessage)
Q_DECLARE_METATYPE(mapwright::map::Problem)
Q_DECLARE_METATYPE(mapwright::map::SubmapAnswer)
Q_DECLARE_METATYPE(mapwright::robot::ConnectionState)
Q_DECLARE_METATYPE(mapwright::robot::RobotIdentity)
