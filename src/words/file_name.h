// Names of others as names of files.
#pragma once

#include "words/qt_plain.h"

namespace mapwright::words {

/// A name that every system takes, and that leads nowhere else: without control characters, separators and a
/// dot in front. `otherwise`, where nothing is left of it.
inline QString fileName(const QString& name, const QString& otherwise) {
  QString file = plainName(name);
  for (QChar& letter : file) {
    if (QStringLiteral("/\\:*?\"<>|").contains(letter)) letter = QLatin1Char('-');
  }
  while (file.startsWith(QLatin1Char('.'))) file.remove(0, 1);
  return file.isEmpty() ? otherwise : file;
}

}  // namespace mapwright::words
