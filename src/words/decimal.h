// Numbers with as many decimals as they need, for people: never with an exponent.
#pragma once

#include <QString>

#include "words/fixed.h"

namespace mapwright::words {

/// "0.05", "5572094.155411", "12". At most `decimals` of them.
inline QString decimal(double value, int decimals = 6) {
  QString text = fixed(value, decimals);
  if (!text.contains(QLatin1Char('.'))) return text;
  while (text.endsWith(QLatin1Char('0'))) text.chop(1);
  if (text.endsWith(QLatin1Char('.'))) text.chop(1);
  return text;
}

}  // namespace mapwright::words
