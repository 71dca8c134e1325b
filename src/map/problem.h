// What went wrong, as a value: who it concerns, what happened, what to do. Plain text, never markup.
#pragma once

#include <string>

namespace mapwright::map {

enum class Severity { Info, Warning, Error };

/// A problem as reported by whoever found it.
struct Problem {
  Severity severity = Severity::Error;
  std::string subject;   // "Submap 1-593 v70", "robot 192.0.2.7:8090"
  std::string sentence;  // "3,200 bytes where 51,200 were expected. Shown without it."
  bool operator==(const Problem&) const = default;
};

}  // namespace mapwright::map
