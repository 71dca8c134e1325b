// The port: what a robot's link delivers, raw, for whoever keeps it (src/recorder/layout.h says how).
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "map/submap.h"
#include "robot/robot.h"

namespace mapwright::robot {

/// One thing as it came, losslessly. All views are valid during the call only. Texts are untrusted.
struct Delivery {
  enum class Kind {
    Message,  // of a topic, or an answer that is as good as one
    Submap,   // the body of an answer about `submap`, whose version is the one that the answer says
    Picture,  // what a message only names: `name` is the address as the message has it
    /// What messages of the type `name` (Delivery::schema) are made of, as `encoding` writes it: "ros1msg",
    /// "ros2msg", "protobuf". No bytes: nobody can tell. Of each type that was named, before or after its
    /// first message.
    Definition,
  };
  Kind kind = Kind::Message;
  std::string_view name;  // of a message: its topic; empty where a frame names none
  /// Of a message: "json", "cbor", "protobuf", or "axbot" (a binary frame that cannot be unpacked); else the
  /// media type, empty: unknown.
  std::string_view encoding;
  std::string_view schema;  // the type of a message as the robot calls it; empty: it does not say
  map::SubmapKey submap;
  std::string_view bytes;
  double received_s = 0;         // seconds since the epoch
  std::optional<double> said_s;  // the robot's own stamp, likewise
  bool before = false;           // it came before the tap was set
};

/// Called for one delivery after the other, on threads of the adapter; within setDeliveryTap() on the
/// caller's.
using DeliveryTap = std::function<void(const Delivery&)>;

/// What a robot whose link can be tapped is besides; ask deliversOf().
class Delivers {
 public:
  virtual ~Delivers() = default;
  /// From now on all that is delivered goes to `tap` as well, nothing left out; an empty one ends it. First
  /// and at once it gets the last message of every topic, and the last picture that was named, of this
  /// connection, as far as they are still held. Once this has returned the tap of before is not called any
  /// more. Not to be called from within a tap.
  virtual void setDeliveryTap(DeliveryTap tap) = 0;
};

/// Null: it delivers nothing (files).
inline Delivers* deliversOf(Robot& robot) { return dynamic_cast<Delivers*>(&robot); }

}  // namespace mapwright::robot
