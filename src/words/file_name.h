// Makes file names from untrusted names.
#pragma once

#include "words/qt_plain.h"

namespace mapwright::words {

/// A name that is valid on every system and cannot lead to another folder: without control characters,
/// separators and a leading dot. `otherwise`, if nothing is left.
inline QString fileName(const QString& name, const QString& otherwise) {
  QString file = plainName(name);
  for (QChar& letter : file) {
    if (QStringLiteral("/\\:*?\"<>|").contains(letter)) letter = QLatin1Char('-');
  }
  while (file.startsWith(QLatin1Char('.'))) file.remove(0, 1);
  return file.isEmpty() ? otherwise : file;
}

}  // namespace mapwright::words
