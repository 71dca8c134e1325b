// What a map is called by whoever speaks of it. Its number on a robot may be another one tomorrow.
#pragma once

#include <string>

namespace mapwright::map {

/// Empty: not known. Names are untrusted plain text.
struct MapIdentity {
  std::string uid, name;
  auto operator<=>(const MapIdentity&) const = default;
  bool empty() const { return uid.empty() && name.empty(); }
  /// Both have a uid: then names do not count.
  bool comparable(const MapIdentity& other) const { return !uid.empty() && !other.uid.empty(); }
  /// Uids decide; where one is not known, names.
  bool isSame(const MapIdentity& other) const {
    return comparable(other) ? uid == other.uid : !name.empty() && name == other.name;
  }
};

}  // namespace mapwright::map
