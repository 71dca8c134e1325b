// Shows one of several submaps at a time, and gives back what the user had.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include <QPointer>

#include "map/submap.h"
#include "session/session.h"

namespace mapwright::ui {

class SubmapStepper {
 public:
  /// Not owned; null = none. What was hidden in the session before is given back.
  void setSession(session::Session* session);
  /// The same ids mean other submaps from now on: nothing is given back.
  void forget() { held_.clear(); }
  /// Of these submaps, only the one with this index is shown; the others of the map stay as they are.
  void showOnly(const std::vector<map::SubmapId>& ids, std::size_t shown);
  /// All as before, except what the user has shown or hidden since.
  void giveBack();
  bool steps() const { return !held_.empty(); }
  /// Whether the user wants it shown, if it is `visible` now.
  bool wanted(map::SubmapId id, bool visible) const;

 private:
  struct Held {
    bool before = true, now = true;
  };
  void setVisible(const std::map<map::SubmapId, bool>& visible);

  QPointer<session::Session> session_;
  std::map<map::SubmapId, Held> held_;
};

}  // namespace mapwright::ui
