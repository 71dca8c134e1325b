#include "robot/wire/delivery_place.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace mapwright::robot::wire {

void DeliveryPlace::set(DeliveryTap tap) {
  const std::lock_guard lock(mutex_);
  tap_ = std::move(tap);
  if (!tap_) return;
  std::vector<const Parcel*> parcels;
  for (const auto& [slot, held] : held_) parcels.push_back(&held.parcel);
  std::stable_sort(parcels.begin(), parcels.end(),
                   [](const Parcel* a, const Parcel* b) { return a->received_s < b->received_s; });
  for (const Parcel* parcel : parcels) hand(tap_, *parcel, true);
}

void DeliveryPlace::pass(Parcel parcel) {
  const std::lock_guard lock(mutex_);
  if (tap_) hand(tap_, parcel, false);
  if (!parcel.slot.empty()) hold(std::move(parcel));
}

bool DeliveryPlace::taken() const {
  const std::lock_guard lock(mutex_);
  return bool(tap_);
}

void DeliveryPlace::forget() {
  const std::lock_guard lock(mutex_);
  held_.clear();
  held_bytes_ = 0;
}

void DeliveryPlace::hand(const DeliveryTap& tap, const Parcel& parcel, bool before) {
  const std::optional<std::string_view> bytes = parcel.find ? parcel.find() : parcel.bytes;
  if (!bytes) return;
  Delivery delivery;
  delivery.kind = parcel.kind;
  delivery.name = parcel.name;
  delivery.encoding = parcel.encoding;
  delivery.schema = parcel.schema;
  delivery.submap = parcel.submap;
  delivery.bytes = *bytes;
  delivery.received_s = parcel.received_s;
  delivery.said_s = parcel.said_s;
  delivery.before = before;
  tap(delivery);
}

void DeliveryPlace::hold(Parcel parcel) {
  Held& held = held_[parcel.slot];
  held_bytes_ -= held.parcel.held_bytes;
  held_bytes_ += parcel.held_bytes;
  held.parcel = std::move(parcel);
  ++held.times;
  while (held_bytes_ > kMostHeldBytes || held_.size() > kMostSlots) {
    const auto first = std::max_element(held_.begin(), held_.end(), [](const auto& a, const auto& b) {
      return std::tie(a.second.times, a.second.parcel.held_bytes) <
             std::tie(b.second.times, b.second.parcel.held_bytes);
    });
    held_bytes_ -= first->second.parcel.held_bytes;
    held_.erase(first);
  }
}

}  // namespace mapwright::robot::wire
