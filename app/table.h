// Prints tables on the standard output.
#pragma once

#include <vector>

#include <QStringList>

namespace mapwright::app {

/// Columns are as wide as their widest cell; put names into the last one, as they may have any width.
void printTable(const std::vector<QStringList>& rows);

}  // namespace mapwright::app
