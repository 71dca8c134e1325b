#include "app/one_line.h"

#include "words/qt_plain.h"

namespace mapwright::app {

QString oneLine(const QString& text, qsizetype most) {
  QString line = words::plainLine(text);
  if (line.size() > most) line = line.left(most / 2) + QStringLiteral(" … ") + line.right(most / 2 - 3);
  return line;
}

}  // namespace mapwright::app
