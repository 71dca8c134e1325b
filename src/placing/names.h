// Names of waypoints: duplicates, and the next free name. Pure.
#pragma once

#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace mapwright::placing {

/// The names of a changing list. A change costs as much as there are waypoints with those two names.
class NameBook {
 public:
  void clear();
  /// Adds or renames. Empty names do not count. Adds to `touched` the keys whose twice() may have changed.
  void put(const std::string& key, const std::string& name, std::set<std::string>& touched);
  void remove(const std::string& key, std::set<std::string>& touched);
  /// Another one has the same name.
  bool twice(const std::string& key) const;

 private:
  std::unordered_map<std::string, std::string> name_of_;
  std::unordered_map<std::string, std::set<std::string>> keys_of_;
};

/// "Rack 3" -> "Rack 4", "Dock" -> "Dock 2": the next free name, which is taken then.
std::string nextName(const std::string& name, std::set<std::string>& taken);

}  // namespace mapwright::placing
