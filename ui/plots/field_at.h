// Finds the field of a message at a position in its text. Pure.
#pragma once

#include <optional>

#include <QString>

#include "series/field_path.h"

namespace mapwright::window {

struct FieldAt {
  series::FieldPath path;
  qsizetype from = 0, until = 0;  // range of its value in the text
};

/// `text` is JSON formatted by prettyJson(): strings and its end may be truncated. nullopt: there is no
/// number, boolean or null at `place`, nor the key of one.
std::optional<FieldAt> fieldAt(const QString& text, qsizetype place, const QString& topic);

}  // namespace mapwright::window
