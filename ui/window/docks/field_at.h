// Which field of a message a place in its text is about. Pure.
#pragma once

#include <optional>

#include <QString>

#include "series/field_path.h"

namespace mapwright::window {

struct FieldAt {
  series::FieldPath path;
  qsizetype from = 0, until = 0;  // where its value stands in the text
};

/// `text` is JSON as prettyJson() lays it out: strings may be cut, and so may be its end. nullopt: there is
/// no number, no true or false and no null at `place`, nor a key of one.
std::optional<FieldAt> fieldAt(const QString& text, qsizetype place, const QString& topic);

}  // namespace mapwright::window
