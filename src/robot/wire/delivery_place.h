// Where whoever keeps what a robot delivers sits, and what was said before he came.
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

/// Thread-safe: set on one thread, passed through on others. Holds the last parcel of every slot, since a
/// robot says some things once; of more than fits, those go first that come most often.
class DeliveryPlace {
 public:
  static constexpr std::size_t kMostHeldBytes = std::size_t(96) << 20;
  static constexpr std::size_t kMostSlots = 512;

  struct Parcel {
    Delivery::Kind kind = Delivery::Kind::Message;
    std::string name, schema;
    const char* encoding = "";
    std::string slot;                   // the next one of the same replaces it; empty: it is not held
    std::shared_ptr<const void> keeps;  // what `bytes` look into
    std::string_view bytes;
    /// Instead of `bytes`, where finding them costs something; nullopt: there are none after all.
    std::function<std::optional<std::string_view>()> find = {};
    std::size_t held_bytes = 0;  // that holding it takes
    map::SubmapKey submap = {};
    double received_s = 0;
    std::optional<double> said_s = {};
  };

  /// Returns once the tap of before is not being called any more.
  void set(DeliveryTap tap);
  void pass(Parcel parcel);
  /// Whether anybody sits there.
  bool taken() const;
  /// Another connection: what was said on the last one is not to be had again.
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
