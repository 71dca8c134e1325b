// A bag while it is read: asks for its ranges, holds what is near, and tells the world of any time. One
// thread, that of the robot it comes from.
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
#include "replay/prefix_index.h"
#include "replay/world_at.h"
#include "robot/bag_library.h"

namespace mapwright::replay {

/// How far the world of a time is known.
enum class Knowledge {
  Buffering,    // its range is not here yet
  LookingBack,  // what is near, and what the robot added; what came before is still being read
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
    /// Milliseconds that only go forward: retries wait by it. None = the system's.
    std::function<Millis()> now = {};
    /// A file may be written while it is read: it is looked at again so often; 0 = never.
    int look_again_ms = 0;
    /// The texts of messages are wanted uncut, for whatever they cost.
    bool whole_texts = false;
  };
  /// `library` outlives it. Begins with open().
  Reading(robot::BagLibrary& library, robot::BagKey key, Options options, QObject* parent = nullptr);
  ~Reading() override;

  /// Asks for the bag's times; ends in opened() or failed().
  void open();
  const robot::BagKey& key() const { return key_; }
  const std::optional<robot::BagInfo>& info() const { return info_; }
  /// Once opened.
  const Chunks& chunks() const { return *chunks_; }
  const PrefixIndex& index() const { return index_; }

  /// Where the world is wanted from now on; changed() tells when more of it is known.
  void want(double at_s);
  /// Read what lies after the wanted time as well, when nothing else is to do.
  void setWhole(bool whole);
  /// Ranges that were read: chunkRead() tells their messages once more, when nothing else is to do. Those
  /// that are held are in chunkAt().
  void readAgain(const std::vector<Tick>& ranges);
  void retryNow();
  /// All that was read is not what its messages are read as any more.
  void readAnew();
  /// Whether a file holds more by now: its axis is longer then, and what lies at its old end is read again. A
  /// bag of a robot is not asked.
  void lookAgain();

  /// The world of the wanted time, as far as it is known now. May ask for what is missing in it. In a gap (a
  /// range that failed) nothing happens: there it is what was before, and never Exact.
  Moment moment();
  /// The chunk of a range; null while it is not held.
  ChunkPtr chunkAt(Tick from) const;

 Q_SIGNALS:
  void opened();
  void failed(const mapwright::map::Failure& failure);  // to be opened
  void changed();                                       // a range was read, failed or let go
  /// All that lies in a range. It may be let go right after.
  void chunkRead(const mapwright::replay::ChunkPtr& chunk);
  /// A range that had been read before turned out to hold more.
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
  const map::TopicMessage* contentAt(Tick from, std::uint32_t place) const;
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
    std::uint64_t number = 0;  // tells it from one for the same range that was cancelled before
    robot::Call call;
  };
  std::map<Tick, Asked> asked_;
  std::uint64_t last_number_ = 0;
  robot::Call opening_, looking_;
  bool looks_ = false;  // looking_ is under way
  QTimer wake_, look_again_;
  QThreadPool making_;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  // replies outlive this object
};

}  // namespace mapwright::replay
