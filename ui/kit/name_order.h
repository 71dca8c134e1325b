// The order of names, as people count: "Rack 2" stands before "Rack 10".
#pragma once

#include <QCollator>
#include <QLocale>

namespace mapwright::ui {

inline QCollator nameOrder() {
  QCollator order;
  // The C locale always compares bytes.
  if (order.locale().language() == QLocale::C)
    order.setLocale(QLocale(QLocale::English, QLocale::UnitedStates));
  order.setNumericMode(true);
  order.setCaseSensitivity(Qt::CaseInsensitive);
  return order;
}

}  // namespace mapwright::ui
