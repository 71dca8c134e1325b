// Names of waypoints: which are taken more than once, and which one is free. Pure.
#pragma once

#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace mapwright::placing {

/// The names of a list while it changes. A change costs as much as there are waypoints of those two names.
class NameBook {
 public:
  void clear();
  /// Adds, or calls otherwise. Empty names are none. What is added to `touched`: keys whose twice() may be
  /// another one now.
  void put(const std::string& key, const std::string& name, std::set<std::string>& touched);
  void remove(const std::string& key, std::set<std::string>& touched);
  /// Another one bears its name.
  bool twice(const std::string& key) const;

 private:
  std::unordered_map<std::string, std::string> name_of_;
  std::unordered_map<std::string, std::set<std::string>> keys_of_;
};

/// "Rack 3" -> "Rack 4", "Dock" -> "Dock 2": the next one that is not taken. It is taken then.
std::string nextName(const std::string& name, std::set<std::string>& taken);

}  // namespace mapwright::placing
