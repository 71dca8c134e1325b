// Sentences for a terminal: one line each, of bounded length, without control characters.
#pragma once

#include <QString>

namespace mapwright::app {

/// Control characters and line breaks become blanks; what is longer than `most` loses its middle.
QString oneLine(const QString& text, qsizetype most = 1'000);

}  // namespace mapwright::app
