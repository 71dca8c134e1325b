// A temporary name that a swap of names has left behind, and what can be done about it. Pure.
#pragma once

#include <optional>
#include <set>
#include <string>

#include <QString>

#include "edit/waypoint_fields.h"

namespace mapwright::window {

struct LeftName {
  enum class Remedy {
    SendRest,  // what is not saved ends it
    CallItSo,  // `permanent`, which nobody else is called
    Ask,       // for a name
  };
  edit::Key key;
  Remedy remedy = Remedy::Ask;
  std::string permanent;
  QString sentence, offer;  // what to say, and on the button
};
/// The first one; not those of `accepted`, which may be called so.
std::optional<LeftName> leftName(const edit::WaypointDocument& document, const std::set<edit::Key>& accepted);

}  // namespace mapwright::window
