// A copy of a Cartographer state file with something left out.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include <QObject>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "map/graph_parts.h"
#include "work/workers.h"

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

struct LeaveOutResult {
  QString path;      // of the new file
  QStringList said;  // leftOutSentences(), damageSentences()
  QString error;     // a sentence; empty: it is done
  bool cancelled = false;
};

/// The same on a thread of its own, one at a time.
class LeaveOutJob : public QObject {
  Q_OBJECT
 public:
  explicit LeaveOutJob(const std::shared_ptr<work::Workers>& workers, QObject* parent = nullptr);
  ~LeaveOutJob() override;
  void start(const QString& from, const map::GraphParts& what, const QString& to);
  void cancel() { cancelled_->store(true); }
  bool running() const { return running_; }

 Q_SIGNALS:
  void progressed(double done);  // 0 to 1
  void finished(const mapwright::jobs::LeaveOutResult& result);

 private:
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  bool running_ = false;
  work::Tasks share_;  // last member: waits for running work
};

}  // namespace mapwright::jobs
