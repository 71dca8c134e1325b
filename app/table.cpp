#include "app/table.h"

#include <algorithm>
#include <cstdio>

#include "app/output_paths.h"
#include "words/qt_plain.h"

namespace mapwright::app {

void printTable(const std::vector<QStringList>& rows) {
  std::vector<qsizetype> widths;
  for (const QStringList& row : rows) {
    widths.resize(std::max(widths.size(), std::size_t(row.size())));
    for (qsizetype i = 0; i < row.size(); ++i)
      widths[std::size_t(i)] = std::max(widths[std::size_t(i)], row[i].size());
  }
  for (const QStringList& row : rows) {
    QString line;
    for (qsizetype i = 0; i < row.size(); ++i) {
      line += i + 1 == row.size() ? row[i] : row[i].leftJustified(widths[std::size_t(i)] + 2);
    }
    printOut(words::plainLine(line).toStdString() + "\n");
  }
}

}  // namespace mapwright::app
