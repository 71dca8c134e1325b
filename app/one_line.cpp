#include "app/one_line.h"

namespace mapwright::app {

QString oneLine(const QString& text, qsizetype most) {
  QString line = text;
  for (QChar& c : line) {
    if (c.category() == QChar::Other_Control || c == QChar::LineSeparator || c == QChar::ParagraphSeparator)
      c = QLatin1Char(' ');
  }
  if (line.size() > most) line = line.left(most / 2) + QStringLiteral(" … ") + line.right(most / 2 - 3);
  return line;
}

}  // namespace mapwright::app
