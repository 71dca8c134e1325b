// The current tap of a robot's deliveries, with a memory of earlier messages.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "robot/delivery.h"

namespace mapwright::robot::wire {

/// Thread-safe: set on one thread, called on others. Keeps the last message of every slot, since a robot
/// sends some only once; if there are too many, the most frequent ones are dropped first.
class DeliveryPlace {
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
  /// Whether anybody sits there.
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

}  // namespace mapwright::robot::wire
