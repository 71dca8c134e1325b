// A copy of a Cartographer state file with something left out.
#pragma once

#include <functional>

#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "map/graph_parts.h"

namespace mapwright::pbstream {
struct DropReceipt;
}

namespace mapwright::jobs {

/// Writes `to`, where nothing may be, and compares it with `from`. The error is a sentence. Blocks; any
/// thread.
tl::expected<pbstream::DropReceipt, QString> leaveOut(const QString& from, const map::GraphParts& what,
                                                      const QString& to,
                                                      const std::function<bool()>& cancelled = {},
                                                      const std::function<void(double)>& progressed = {});
/// What has become of it: sentences.
QStringList leftOutSentences(const pbstream::DropReceipt& receipt, const QString& to);
/// What was copied although it is damaged: sentences.
QStringList damageSentences(const pbstream::DropReceipt& receipt);

/// Leaves out, and says what has become of it: both of these.
tl::expected<QStringList, QString> leaveOutSaying(const QString& from, const map::GraphParts& what,
                                                  const QString& to, const std::function<bool()>& cancelled,
                                                  const std::function<void(double)>& progressed);

}  // namespace mapwright::jobs
