// Sentences for a terminal: one line each, of bounded length, without control characters.
#pragma once

#include <QString>

namespace mapwright::app {

/// Replaces control characters and line breaks with blanks; texts longer than `most` lose their middle.
QString oneLine(const QString& text, qsizetype most = 1'000);

}  // namespace mapwright::app
