// Rows for people on the standard output.
#pragma once

#include <vector>

#include <QStringList>

namespace mapwright::app {

/// Columns as wide as their widest cell; names belong into the last one, for they may be of any width.
void printTable(const std::vector<QStringList>& rows);

}  // namespace mapwright::app
