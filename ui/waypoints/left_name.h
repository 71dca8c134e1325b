// A temporary name left by an interrupted swap of names, and how to fix it. Pure.
#pragma once

#include <optional>
#include <set>
#include <string>

#include <QString>

#include "edit/document.h"

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
  QString sentence, offer;  // the text, and the button
};
/// The first one; ignores those in `accepted`.
std::optional<LeftName> leftName(const edit::WaypointDocument& document, const std::set<edit::Key>& accepted);

}  // namespace mapwright::window
