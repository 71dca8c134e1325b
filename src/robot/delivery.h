// The port: raw data as delivered by a robot's connection, for recording (see src/recorder/layout.h).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "map/submap.h"
#include "robot/robot.h"

namespace mapwright::robot {

/// One piece of data as received, losslessly. All views are valid during the call only. Texts are untrusted.
struct Delivery {
  enum class Kind {
    Message,  // of a topic, or an equivalent answer
    Submap,   // the body of an answer about `submap`, with the version stated in the answer
    Picture,  // given only by address in a message: `name` is that address
    /// The definition of the message type `name` (Delivery::schema) in the format `encoding`: "ros1msg",
    /// "ros2msg", "protobuf". No bytes: not available. Sent for each type, before or after its first message.
    Definition,
  };
  Kind kind = Kind::Message;
  std::string_view name;  // of a message: its topic; empty if the frame has none
  /// Of a message: "json", "cbor", "protobuf", or "axbot" (a binary frame that cannot be unpacked); otherwise
  /// the media type, empty: unknown.
  std::string_view encoding;
  std::string_view schema;  // the robot's name for the message type; empty: not stated
  map::SubmapKey submap;
  std::string_view bytes;
  double received_s = 0;         // seconds since the epoch
  std::optional<double> said_s;  // the robot's own stamp, likewise
  bool before = false;           // it arrived before the tap was set
};

/// Called for one delivery after the other, on threads of the adapter; within setDeliveryTap() on the
/// caller's.
using DeliveryTap = std::function<void(const Delivery&)>;

/// Interface of a robot whose connection can be tapped; get it with deliversOf().
class Delivers {
 public:
  virtual ~Delivers() = default;
  /// From now on everything delivered also goes to `tap`; an empty one ends it. It first gets the last
  /// message of every topic, and the last picture given by address, of this connection, as far as they are
  /// still in memory. After this returns the previous tap is no longer called. Not to be called from within a
  /// tap.
  virtual void setDeliveryTap(DeliveryTap tap) = 0;
  /// The content of a binary message as one JSON text; nullopt: its type is not known. On any thread.
  virtual std::optional<std::string> jsonOf(const Delivery&) const { return std::nullopt; }
};

/// Null: it delivers nothing (files).
inline Delivers* deliversOf(Robot& robot) { return dynamic_cast<Delivers*>(&robot); }

}  // namespace mapwright::robot
