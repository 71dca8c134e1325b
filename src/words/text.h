// Converts texts of the core (UTF-8) to QString.
#pragma once

#include <string>

#include <QString>

namespace mapwright::words {

inline QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

}  // namespace mapwright::words
