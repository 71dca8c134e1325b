// What the network halves of all robots have in common.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <QDateTime>
#include <QElapsedTimer>
#include <QLoggingCategory>
#include <QObject>
#include <QUrl>

#include "map/live_topics.h"
#include "robot/delivery.h"
#include "robot/robot.h"
#include "robot/wire/unsaid.h"

namespace mapwright::robot::wire {

/// Keeps the latest message of each topic until it is taken: messages that arrive faster than they are shown
/// replace each other. Thread-safe.
class TopicMailbox {
 public:
  static constexpr std::size_t kTopics = 64;  // further topics are dropped

  /// Whether messages of this kind use the mailbox: large, and useless once there is a newer one.
  static bool takes(const map::TopicMessage& message);

  /// True if the box was empty: the receiver has to be woken.
  bool put(map::StampedMessage message);
  /// Empties the box.
  std::vector<map::StampedMessage> take();
  /// How many were replaced before they were taken.
  std::size_t replaced() const;

 private:
  mutable std::mutex mutex_;
  std::size_t replaced_ = 0;
  std::map<std::string, map::StampedMessage> latest_;  // by topic
};

/// The present tap of the frames. Thread-safe: set on one thread, called on another.
class TapSlot {
 public:
  /// Returns when the previous tap is no longer being called.
  void set(FrameTap tap) {
    const std::lock_guard lock(mutex_);
    tap_ = std::move(tap);
  }
  void pass(const RawFrame& frame) const {
    const std::lock_guard lock(mutex_);
    if (tap_) tap_(frame);
  }

 private:
  mutable std::mutex mutex_;
  FrameTap tap_;
};

/// Limits raw messages that are shown in a window: at most kMessages and kBytes per second.
class RawLimit {
 public:
  static constexpr int kMessages = 200;
  static constexpr qint64 kBytes = qint64(32) << 20;
  /// Whether a message of this size may pass at `now_ms` of any monotonic clock.
  bool allow(qint64 now_ms, qint64 bytes) {
    if (now_ms / 1000 != second_) {
      second_ = now_ms / 1000;
      messages_ = 0;
      bytes_ = 0;
    }
    if (messages_ >= kMessages || bytes_ >= kBytes) return false;
    ++messages_;
    bytes_ += std::min<qint64>(bytes, kMaxRawText);
    return true;
  }

 private:
  qint64 second_ = -1;
  int messages_ = 0;
  qint64 bytes_ = 0;
};

/// The present tap of deliveries. Thread-safe: set on one thread, called on others. Keeps the last message of
/// every slot, since a robot sends some only once; if there are too many, the most frequent ones are dropped
/// first.
class DeliveryTapSlot {
 public:
  static constexpr std::size_t kMostHeldBytes = std::size_t(96) << 20;
  static constexpr std::size_t kMostSlots = 512;

  struct Parcel {
    Delivery::Kind kind = Delivery::Kind::Message;
    std::string name, schema;
    const char* encoding = "";
    std::string slot;                   // the next one with the same slot replaces it; empty: it is not kept
    std::shared_ptr<const void> keeps;  // what `bytes` look into
    std::string_view bytes;
    /// Instead of `bytes`, if getting them is expensive; nullopt: there are none after all.
    std::function<std::optional<std::string_view>()> find = {};
    std::size_t held_bytes = 0;  // memory for keeping it
    map::SubmapKey submap = {};
    double received_s = 0;
    std::optional<double> said_s = {};
  };

  /// Returns when the previous tap is no longer being called.
  void set(DeliveryTap tap);
  void pass(Parcel parcel);
  /// Whether there is a tap.
  bool taken() const;
  /// A new connection: drops the messages of the last one.
  void forget();

 private:
  struct Held {
    Parcel parcel;
    std::uint64_t times = 0;
  };
  static void hand(const DeliveryTap& tap, const Parcel& parcel, bool before);
  void hold(Parcel parcel);

  mutable std::mutex mutex_;
  DeliveryTap tap_;
  std::map<std::string, Held> held_;  // by slot
  std::size_t held_bytes_ = 0;
};

/// What becomes of a connection, in the log: one line for each change; what is measured all the time (round
/// trips, seconds until the next try) is none.
class LinkLog {
 public:
  /// `category` outlives this. `who`: the robot, "10.0.0.7:8090", or a file.
  LinkLog(const QLoggingCategory& category, std::string who) : category_(category), who_(std::move(who)) {}
  void record(const ConnectionState& state);
  void record(const Fault& fault);

 private:
  const QLoggingCategory& category_;
  std::string who_;
  ConnectionState last_;
};

/// By the system's clock: seconds since the epoch. Any thread.
double secondsOfDay();
/// "192.0.2.7:8090"
std::string hostOf(const QUrl& url);

/// What a robot shares with its link. Thread-safe: each of them for itself.
struct LinkOutputs {
  TopicMailbox mailbox;        // large messages
  TapSlot tap;                 // frames
  DeliveryTapSlot deliveries;  // all that comes
};

/// The network half of a robot. Lives on a thread of its own; values go in and out by queued calls.
class RobotLink : public QObject {
  Q_OBJECT
 public:
  /// `log` outlives this. `secret` is never repeated of what the robot says.
  RobotLink(const QLoggingCategory& log, const QUrl& server, const QByteArray& secret = {});
  const Unsaid& unsaid() const { return unsaid_; }
  const std::shared_ptr<LinkOutputs>& outputs() const { return outputs_; }

  virtual void open() = 0;
  virtual void close() = 0;
  virtual void trust(const QByteArray& pinned_sha256) = 0;  // from now on, and connects
  void setWatching(bool on) { watching_ = on; }             // raw messages are told

 Q_SIGNALS:
  void stateChanged(const mapwright::robot::ConnectionState& state);
  void silenceChanged(const QDateTime& since);  // as Robot::silentSince() says; comes before stateChanged()
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
  static DeliveryTapSlot::Parcel parcelOf(std::string name, std::shared_ptr<const std::string> body,
                                          double received_s);

  const std::string server_;  // its host and port: whom problems are about
  const Unsaid unsaid_;
  LinkLog link_log_;
  const std::shared_ptr<LinkOutputs> outputs_ = std::make_shared<LinkOutputs>();

 private:
  bool watching_ = false;
  RawLimit raw_limit_;
  QElapsedTimer clock_;
};

}  // namespace mapwright::robot::wire
