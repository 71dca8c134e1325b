#include "placing/names.h"

#include <cstddef>
#include <cstdint>

namespace mapwright::placing {
namespace {
constexpr std::size_t kLongestNumber = 9;
}

void NameBook::clear() {
  name_of_.clear();
  keys_of_.clear();
}

void NameBook::remove(const std::string& key, std::set<std::string>& touched) {
  const auto known = name_of_.find(key);
  if (known == name_of_.end()) return;
  const auto keys = keys_of_.find(known->second);
  keys->second.erase(key);
  touched.insert(key);
  // With two or more left nothing changes for them.
  if (keys->second.size() == 1) touched.insert(*keys->second.begin());
  if (keys->second.empty()) keys_of_.erase(keys);
  name_of_.erase(known);
}

void NameBook::put(const std::string& key, const std::string& name, std::set<std::string>& touched) {
  const auto known = name_of_.find(key);
  if (known != name_of_.end() && known->second == name) return;
  remove(key, touched);
  if (name.empty()) return;
  std::set<std::string>& keys = keys_of_[name];
  if (keys.size() == 1) touched.insert(*keys.begin());
  keys.insert(key);
  name_of_.emplace(key, name);
  touched.insert(key);
}

bool NameBook::twice(const std::string& key) const {
  const auto known = name_of_.find(key);
  return known != name_of_.end() && keys_of_.at(known->second).size() > 1;
}

std::string nextName(const std::string& name, std::set<std::string>& taken) {
  std::size_t digits = name.size();
  while (digits > 0 && name.size() - digits < kLongestNumber && name[digits - 1] >= '0' &&
         name[digits - 1] <= '9')
    --digits;
  const bool numbered = digits < name.size() && digits > 0 && name[digits - 1] == ' ';
  const std::string stem = numbered ? name.substr(0, digits) : name + " ";
  std::int64_t number = numbered ? std::stoll(name.substr(digits)) : 1;
  std::string next;
  do {
    next = stem + std::to_string(++number);
  } while (!taken.insert(next).second);
  return next;
}

}  // namespace mapwright::placing
