// Texts of others that may be of any length.
#pragma once

#include <QString>

namespace mapwright::words {

/// At most this many letters; what was cut off shows as "…".
inline QString shortened(const QString& text, qsizetype most) {
  if (text.size() <= most) return text;
  QString kept = text.left(most - 1);
  if (!kept.isEmpty() && kept.back().isHighSurrogate()) kept.chop(1);
  return kept + QChar(0x2026);
}

}  // namespace mapwright::words
