// What the network halves of all robots have in common.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QDateTime>
#include <QElapsedTimer>
#include <QObject>
#include <QUrl>

#include "robot/robot.h"
#include "robot/wire/delivery_place.h"
#include "robot/wire/link_log.h"
#include "robot/wire/raw_limit.h"
#include "robot/wire/tap_place.h"
#include "robot/wire/topic_mailbox.h"

namespace mapwright::robot::wire {

/// By the system's clock: seconds since the epoch. Any thread.
double secondsOfDay();
/// "192.0.2.7:8090"
std::string hostOf(const QUrl& url);

/// What a robot shares with its link. Thread-safe: each of them for itself.
struct Places {
  TopicMailbox mailbox;      // large messages
  TapPlace tap;              // frames
  DeliveryPlace deliveries;  // all that comes
};

/// The network half of a robot. Lives on a thread of its own; values go in and out by queued calls.
class RobotLink : public QObject {
  Q_OBJECT
 public:
  /// `log` outlives this.
  RobotLink(const QLoggingCategory& log, const QUrl& server);
  const std::shared_ptr<Places>& places() const { return places_; }

  virtual void open() = 0;
  virtual void close() = 0;
  virtual void trust(const QByteArray& pinned_sha256) = 0;  // from now on, and connects
  void setWatching(bool on) { watching_ = on; }             // raw messages are told

 Q_SIGNALS:
  void stateChanged(const mapwright::robot::ConnectionState& state);
  void silenceChanged(const QDateTime& since);  // as MeasuresSilence says; comes before stateChanged()
  void topicReceived(const mapwright::map::StampedMessage& message);
  void mailArrived();  // the mailbox was empty and is no more
  void rawReceived(const mapwright::robot::RawMessage& message);
  void problemFound(const mapwright::map::Problem& problem);
  void recovered(const mapwright::map::Recovery& recovery);

 protected:
  void report(map::Severity severity, Fault reason);
  /// Somebody watches, and can take one of this size now.
  bool passesRaw(qint64 bytes);
  /// To whoever shows it, by mail where it is large.
  void pass(map::StampedMessage message);
  /// A body that is kept as long as somebody may want it.
  static DeliveryPlace::Parcel parcelOf(std::string name, std::shared_ptr<const std::string> body,
                                        double received_s);

  const std::string server_;  // its host and port: whom problems are about
  LinkLog link_log_;
  const std::shared_ptr<Places> places_ = std::make_shared<Places>();

 private:
  bool watching_ = false;
  RawLimit raw_limit_;
  QElapsedTimer clock_;
};

}  // namespace mapwright::robot::wire
