// Numbers with a fixed count of decimals, for people.
#pragma once

#include <QString>

namespace mapwright::words {

/// "1.50". What is rounded to zero has no sign: "-0.0" would look like a fault.
inline QString fixed(double value, int decimals) {
  const QString text = QString::number(value, 'f', decimals);
  return text.startsWith(QLatin1Char('-')) && text.toDouble() == 0 ? text.mid(1) : text;
}

}  // namespace mapwright::words
