// Writes a part of a bag to a file in the background.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include <QObject>

#include "excerpt/excerpt.h"
#include "map/failure.h"
#include "replay/reading.h"
#include "robot/bag_library.h"
#include "work/workers.h"

namespace mapwright::excerpt {

/// The result: `written`, or one of the others; none of them: cancelled. Without `written` there is no file.
struct Ended {
  std::optional<Written> written;
  std::optional<map::Failure> not_read;  // the bag or the range could not be read
  std::optional<Fault> not_written;
  std::optional<TimeSpan> range;         // that is missing
  std::vector<replay::Hole> holes = {};  // what is missing in what was written
};

/// Lives on the robot's thread. Reads on its own, so it does not disturb a replay of the same bag.
class ExcerptJob : public QObject {
  Q_OBJECT
 public:
  struct Source {
    robot::BagLibrary* library = nullptr;  // outlives the job
    robot::BagKey key;
    std::string recording;  // the file, for a recording on this computer: its parts are read from it directly
  };
  /// Does nothing before start().
  ExcerptJob(Source source, Order order, std::shared_ptr<work::Workers> workers, QObject* parent = nullptr);
  /// Cancels and removes the file if it has not finished; waits for the write in progress.
  ~ExcerptJob() override;

  void start();
  /// Emits ended() later all the same.
  void cancel();

 Q_SIGNALS:
  void progressed(double share);  // 0..1
  void ended(const mapwright::excerpt::Ended& ended);

 private:
  void slice();
  void begun();
  void proceed();
  void work(const replay::ChunkPtr& chunk);
  void worked(const std::optional<disk::FileError>& fault, const std::optional<Written>& written);
  void end(Ended ended);

  Source source_;
  Order order_;
  std::unique_ptr<replay::Reading> reading_;
  std::optional<replay::RangeWalk> walk_;
  std::shared_ptr<Writing> writing_;  // of the running job
  int opened_ = 0;                    // number of attempts
  bool busy_ = false, over_ = false;
  std::atomic<bool> cancelled_ = false;
  work::Tasks share_;  // last member: waits for running work
};

}  // namespace mapwright::excerpt
