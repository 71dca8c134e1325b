// Records what a robot sends to a file (layout.h) until it is stopped. GUI-thread object; the robot's
// connection puts data into a bounded queue and never waits, and a thread of the recorder packs and writes
// it.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <tl/expected.hpp>

#include "recorder/fetches.h"
#include "recorder/tape.h"
#include "recording/append_file.h"
#include "recording/mcap_writer.h"
#include "robot/robot.h"

namespace mapwright::recorder {

/// All kinds of data that a robot can send.
map::Streams everyStream();

class Recorder : public QObject {
  Q_OBJECT
 public:
  struct Options {
    std::string kind;                       // of the robot: the scheme of its address, "axbot"
    std::string recorded_by = "mapwright";  // with its version
    SubmapRequests::Which submaps = SubmapRequests::Which::Listed;
    std::size_t most_waiting_bytes = std::size_t(256) << 20;  // waiting to be written
    recording::WriterOptions writer;
    std::function<std::int64_t()> now_ns;  // since 1970, on any thread; null = the system's clock
  };
  /// Starts at once, including messages already received on this connection. If `robot` is destroyed first,
  /// no more data comes. The error: not even the start could be written.
  static tl::expected<std::unique_ptr<Recorder>, disk::FileError> start(
      robot::Robot& robot, std::unique_ptr<recording::AppendTarget> target, Options options);
  /// Finishes the file and waits for that.
  ~Recorder() override;

  /// Accepts no more data; emits finished() when the file is complete.
  void stop();
  /// The same, and waits.
  void finish();
  bool stopped() const { return stopped_; }

  struct Progress {
    Written written;     // including losses on the way to the disk
    double seconds = 0;  // since the start
    bool finished = false;
    std::optional<disk::FileError> end_fault;  // why the file has no end; it is still readable
  };
  Progress progress() const;
  /// Whether any message of this topic has arrived.
  bool heard(const std::string& topic) const { return queue_->heard(topic); }
  Fetches& fetches() { return *fetches_; }

 Q_SIGNALS:
  void progressed();  // a few times a second
  void finished();
  void notHad(const mapwright::map::Failure& failure);

 private:
  Recorder(robot::Robot& robot, std::unique_ptr<recording::McapWriter> writer, Options options);
  void begin();
  void recordIdentity();
  void putMetadata(const char* name, recording::Values values);
  /// Records when the connection was lost and restored.
  void onLink();
  void run();
  void publish();

  QPointer<robot::Robot> robot_;
  Options options_;
  std::int64_t started_ns_ = 0;
  std::shared_ptr<EntryQueue> queue_;  // shared with the tap
  Tape tape_;                          // of the thread
  std::unique_ptr<Fetches> fetches_;
  QTimer timer_;
  bool stopped_ = false;
  bool was_online_ = false;
  std::optional<std::int64_t> lost_ns_;  // while the link is away
  mutable std::mutex mutex_;
  Progress progress_;
  std::thread thread_;
};

}  // namespace mapwright::recorder
