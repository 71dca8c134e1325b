// The filter language of the inspector. Pure.
#pragma once

#include <vector>

#include <QString>

#include "map/submap.h"
#include "session/session.h"

namespace mapwright::ui {

/// Everything that a row of the inspector shows about one submap.
struct SubmapFacts {
  map::SubmapId id;
  int version = 0;         // as listed
  int shown_version = -1;  // on screen, -1 = none
  bool frozen = false, incremental = false, nearby = false;
  bool visible = true;  // by the user's choice
  bool shown = false;   // loaded and not hidden
  session::SubmapStatus status = session::SubmapStatus::Queued;
  bool operator==(const SubmapFacts&) const = default;
};

/// "FROZEN" or "ACTIVE", then "INC", "NEARBY" if they apply.
QStringList badges(const SubmapFacts& facts);

/// Words, all of which must match: "12-3" (trajectory and the beginning of the
/// index), "12-" (a trajectory), "592" or "#592" (the beginning of the index),
/// "v70" (version), "frozen", "active", "incremental", "nearby", "hidden",
/// "visible" or a status word; words may be abbreviated ("fro"). An unknown
/// word matches nothing.
class SubmapFilter {
 public:
  SubmapFilter() = default;
  explicit SubmapFilter(const QString& text);
  bool empty() const { return words_.empty(); }
  bool matches(const SubmapFacts& facts) const;
  bool operator==(const SubmapFilter&) const = default;

 private:
  std::vector<QString> words_;
};

}  // namespace mapwright::ui
