// What a map is called by whoever speaks of it. Its number on a robot may be another one tomorrow.
#pragma once

#include <string>
#include <string_view>

namespace mapwright::map {

/// Empty: not known. Names are untrusted plain text.
struct MapIdentity {
  std::string uid, name;
  auto operator<=>(const MapIdentity&) const = default;
  bool empty() const { return uid.empty() && name.empty(); }
  /// Both have a uid: then names do not count.
  bool comparable(const MapIdentity& other) const { return !uid.empty() && !other.uid.empty(); }
  /// Uids decide; where one is not known, names. The file of a map is called like it, with an ending.
  bool isSame(const MapIdentity& other) const {
    return comparable(other) ? uid == other.uid : !name.empty() && bare(name) == bare(other.name);
  }

 private:
  static std::string_view bare(std::string_view name) {
    return name.substr(0, name.size() - (name.ends_with(".yaml") ? 5 : name.ends_with(".yml") ? 4 : 0));
  }
};

}  // namespace mapwright::map
