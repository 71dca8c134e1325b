// Makes file names from untrusted names.
#pragma once

#include <QRegularExpression>

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

/// The same of letters, digits, blanks, '-', '_' and '.' only, at most 60 of them.
inline QString shortFileName(const QString& name, const QString& otherwise) {
  static const QRegularExpression odd(QStringLiteral("[^\\w\\-. ]"),
                                      QRegularExpression::UseUnicodePropertiesOption);
  QString file = plainName(name).replace(odd, QStringLiteral("_")).left(60).trimmed();
  while (file.startsWith(QLatin1Char('.'))) file.remove(0, 1);
  return file.isEmpty() ? otherwise : file;
}

}  // namespace mapwright::words
