// A bag being read: requests ranges, keeps those nearby in memory, and gives the world at any time. One
// thread, that of its robot.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include "map/failure.h"
#include "replay/chunks.h"
#include "replay/digest.h"
#include "replay/world_at.h"
#include "robot/bag_library.h"

namespace mapwright::replay {

/// How much of the state at a time is known.
enum class Knowledge {
  Buffering,    // its range is not here yet
  LookingBack,  // the nearby data, with the robot's back-fill; earlier data is still being read
  Exact,
};

struct Moment {
  Knowledge knowledge = Knowledge::Buffering;
  WorldAt at;                            // empty while buffering
  std::map<std::string, double> topics;  // with the stamps of their last messages
};

class Reading : public QObject {
  Q_OBJECT
 public:
  struct Options {
    ChunksOptions chunks;
    /// A monotonic clock in milliseconds, for retries. None = the system's.
    std::function<Millis()> now = {};
    /// How often to check a file that may still be written; 0 = never.
    int look_again_ms = 0;
    /// Messages need their complete texts, at any cost.
    bool whole_texts = false;
  };
  /// `library` outlives it. Does nothing before open().
  Reading(robot::BagLibrary& library, robot::BagKey key, Options options, QObject* parent = nullptr);
  ~Reading() override;

  /// Requests the bag's times; ends in opened() or failed().
  void open();
  const robot::BagKey& key() const { return key_; }
  const std::optional<robot::BagInfo>& info() const { return info_; }
  /// After opened().
  const Chunks& chunks() const { return *chunks_; }
  const PrefixIndex& index() const { return index_; }

  /// The time whose state is wanted from now on; changed() tells when more of it is known.
  void want(double at_s);
  /// Also read everything after the wanted time, with low priority.
  void setWhole(bool whole);
  /// Reads these ranges again with low priority: chunkRead() delivers their messages. Those in memory are in
  /// chunkAt().
  void readAgain(const std::vector<Tick>& ranges);
  void retryNow();
  /// Everything has to be read again because the messages are interpreted differently now.
  void readAnew();
  /// Checks whether a file has grown: extends its axis and reads its old end again. Does nothing for a
  /// robot's bag.
  void lookAgain();

  /// The state at the wanted time, as far as it is known. May request missing data. In a gap (a failed range)
  /// the state stays as before, and is not Exact unless the gap is lost for good.
  Moment moment();
  /// The chunk of a range; null if it is not in memory.
  ChunkPtr chunkAt(Tick from) const;

 Q_SIGNALS:
  void opened();
  void failed(const mapwright::map::Failure& failure);  // to be opened
  void changed();                                       // a range was read, failed or was dropped
  /// The content of a range. It may be dropped right afterwards.
  void chunkRead(const mapwright::replay::ChunkPtr& chunk);
  /// A range that was read before turned out to contain more.
  void replaced(mapwright::replay::Tick from);

 private:
  void proceed();
  void lengthen(const robot::BagInfo& info);
  void ask(Tick from);
  struct Made {
    ChunkPtr chunk;
    Digest digest;
  };
  static Made made(robot::BagChunkPtr answer);
  /// On a thread of its own: a long range would cost a frame.
  void make(Tick from, std::uint64_t number, const robot::BagChunkPtr& answer);
  bool isAwaited(Tick from, std::uint64_t number);
  void hold(Tick from, Made made);
  void miss(Tick from, const map::Failure& failure);
  const map::TopicMessage* contentAt(Tick from, std::uint32_t index) const;
  Millis now() const { return options_.now ? options_.now() : clock_.elapsed(); }

  robot::BagLibrary& library_;
  robot::BagKey key_;
  Options options_;
  QElapsedTimer clock_;
  std::optional<robot::BagInfo> info_;
  std::optional<Chunks> chunks_;
  PrefixIndex index_;
  std::map<Tick, ChunkPtr> held_;
  struct Asked {
    std::uint64_t number = 0;  // distinguishes it from an earlier, cancelled request for the same range
    robot::Call call;
  };
  std::map<Tick, Asked> asked_;
  std::uint64_t last_number_ = 0;
  robot::Call opening_, looking_;
  bool looks_ = false;  // looking_ is in progress
  QTimer wake_, look_again_;
  QThreadPool making_;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  // replies may outlive this object
};

/// Iterates over the ranges of a bag in order, each as soon as it has been read: for a single pass over a
/// part of it. Requests nothing else. Passes over what is lost (Chunks::holes), so that it may be over after
/// next() returned null.
class RangeWalk {
 public:
  /// The ranges that overlap `from_s` to `to_s`; without limits all of them, whatever times are stated.
  /// `reading` is open, used by nobody else (and does not look back), and outlives this.
  RangeWalk(Reading& reading, std::optional<double> from_s, std::optional<double> to_s);

  /// All ranges were returned.
  bool over() const { return !next_s_; }
  /// The next one; null until it has been read. Reading::changed() tells when to ask again.
  ChunkPtr next();
  /// The range it is waiting for, with its failure if there is one. nullptr: over.
  const Cell* waitsFor() const;
  /// The share of the part returned so far, 0..1.
  double share() const;

 private:
  void wantNext(const Cell* cell);
  void wantAfter(const Cell& cell);

  Reading& reading_;
  std::optional<double> from_s_, to_s_, next_s_;
};

}  // namespace mapwright::replay
