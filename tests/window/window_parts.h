// The docks, controllers and other parts of a window, for tests.
#pragma once

#include <QAbstractItemModel>
#include <QPixmap>
#include <QWidget>

namespace mapwright::ui {

/// The one of this class; null: there is none.
template <class Part>
Part* part(const QWidget& window) {
  return window.findChild<Part*>();
}

/// The pictures that a model makes anew each time it is asked for them, "row, column"; and all of them in
/// `seen`.
inline QStringList picturesMadeTwice(const QAbstractItemModel& model, int& seen) {
  QStringList found;
  for (int row = 0; row < model.rowCount(); ++row) {
    for (int column = 0; column < model.columnCount(); ++column) {
      const QVariant first = model.data(model.index(row, column), Qt::DecorationRole);
      const QVariant again = model.data(model.index(row, column), Qt::DecorationRole);
      if (!first.isValid()) continue;
      ++seen;
      if (first.value<QPixmap>().cacheKey() != again.value<QPixmap>().cacheKey())
        found << QStringLiteral("%1, %2").arg(row).arg(column);
    }
  }
  return found;
}

}  // namespace mapwright::ui
