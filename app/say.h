// Sentences on standard error, a line each.
#pragma once

#include <cstdio>

#include <QString>

#include "app/one_line.h"

namespace mapwright::app {

inline void say(const QString& sentence) { std::fprintf(stderr, "%s\n", qUtf8Printable(oneLine(sentence))); }
/// Prints why nothing was done. Returns the exit code.
inline int refuse(int exit_code, const QString& sentence) {
  say(sentence);
  return exit_code;
}

}  // namespace mapwright::app
