// Reads a state file, and again when it changes. Lives on a thread of its own; submaps are decoded on more.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

#include "map/live_topics.h"
#include "pbstream/state_file.h"
#include "robot/call.h"
#include "robot/wire/task.h"
#include "work/workers.h"

namespace mapwright::robot::pbstream {

struct StateOptions {
  QString path;                           // absolute
  std::chrono::milliseconds settle{200};  // a change is read after this much time without another one
};

/// The name of a Cartographer state file, also of one that does not exist.
bool hasStateFileName(const QString& path);

/// Read by the first request. Reading ends early when the thread is asked to stop.
class StateReader : public QObject {
  Q_OBJECT
 public:
  explicit StateReader(StateOptions options);
  /// Waits for the submaps that are being decoded.
  ~StateReader() override;

  void open();  // says opened() or refused(), and watches the file from now on
  void leave();

  void submap(const wire::TaskPtr& task, const map::SubmapKey& key, OutcomeTo<map::SubmapAnswer> reply);
  Outcome<std::shared_ptr<const map::PoseGraph>> graph();

 Q_SIGNALS:
  /// `losses`: what of the file is missing.
  void opened(const std::vector<mapwright::map::StampedMessage>& messages,
              const std::vector<mapwright::Fault>& losses, bool three_d);
  void refused(const mapwright::Fault& why);

 private:
  using State = mapwright::pbstream::StateFile;
  /// Reads it unless it has been read. A change since then is for open().
  bool ready();
  void read();
  void watch();
  void compare();

  StateOptions options_;
  std::string stamp_;                   // of what was read
  std::shared_ptr<const State> state_;  // null: not read, or unreadable
  std::optional<Fault> trouble_;
  std::unique_ptr<QFileSystemWatcher> watcher_;
  std::unique_ptr<QTimer> settle_;
  work::Tasks decoding_;
};

}  // namespace mapwright::robot::pbstream
