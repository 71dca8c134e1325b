// A part of a bag on its way into a file, while the program does other things.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include <QObject>

#include "excerpt/excerpt.h"
#include "map/failure.h"
#include "replay/range_walk.h"
#include "replay/reading.h"
#include "robot/bag_library.h"
#include "work/workers.h"

namespace mapwright::excerpt {

/// What it ended in: `written`, or one of the others; none of them: it was cancelled. Without `written`
/// nothing has been written.
struct Ended {
  std::optional<Written> written;
  std::optional<map::Failure> not_read;  // the bag, or the range below
  std::optional<Fault> not_written;
  std::optional<TimeSpan> range;  // that could not be had
};

/// The thread of the robot. Reads for itself: whoever replays the same bag meanwhile is not disturbed.
class ExcerptJob : public QObject {
  Q_OBJECT
 public:
  struct Source {
    robot::BagLibrary* library = nullptr;  // outlives the job
    robot::BagKey key;
    std::string recording;  // the file, where it is one on this computer: parts of it are what they are there
  };
  /// Begins with start().
  ExcerptJob(Source source, Order order, std::shared_ptr<work::Workers> workers, QObject* parent = nullptr);
  /// Nothing is left of one that has not ended; waits for what is being written at the moment.
  ~ExcerptJob() override;

  void start();
  /// ended() comes all the same, later.
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
  std::shared_ptr<Writing> writing_;  // of the job under way, while there is one
  int opened_ = 0;                    // how often it was tried
  bool busy_ = false, over_ = false;
  std::atomic<bool> cancelled_ = false;
  work::Share share_;  // last: it waits for what runs
};

}  // namespace mapwright::excerpt
