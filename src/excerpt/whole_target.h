// A recording that is written completely or not at all, and what is lost of the one that it is made from.
#pragma once

#include <cerrno>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "disk/written_file.h"
#include "excerpt/excerpt.h"
#include "fault/fault.h"
#include "recording/mcap_writer.h"
#include "recording/source.h"
#include "robot/recorded/faults.h"
#include "robot/recorded/recording_reasons.h"

namespace mapwright::excerpt {

class WholeTarget : public recording::AppendTarget {
 public:
  explicit WholeTarget(const Order& order) : file_(order.path, order.existing) {}
  /// After an error all further calls fail.
  std::optional<disk::FileError> append(std::span<const std::uint8_t> bytes) override {
    file_.write(bytes.data(), bytes.size());
    return settle();
  }
  std::optional<disk::FileError> settle() override { return file_.good() ? std::nullopt : file_.place(); }
  /// After the writer is closed: gives the file its name.
  std::optional<disk::FileError> place() { return file_.place(); }

 private:
  disk::WrittenFile file_;
};

/// One thread. finish() gives the file its name; without it nothing is left.
class WholeMcap {
 public:
  static tl::expected<WholeMcap, disk::FileError> create(const Order& order, std::string profile = {}) {
    recording::WriterOptions options;
    options.profile = std::move(profile);
    // Nobody reads it before it is complete, so chunks are closed by size only.
    options.chunk_bytes = std::size_t(4) << 20;
    options.chunk_ns = std::numeric_limits<std::int64_t>::max();
    auto target = std::make_unique<WholeTarget>(order);
    WholeTarget* const kept = target.get();
    auto writer = recording::McapWriter::create(std::move(target), std::move(options));
    if (!writer) return tl::make_unexpected(writer.error());
    return WholeMcap(*kept, std::move(*writer));
  }

  recording::McapWriter& writer() { return *writer_; }
  /// On this channel, which is described once.
  std::optional<disk::FileError> write(const recording::Channel& channel, const recording::Stamp& stamp,
                                       std::span<const std::uint8_t> bytes) {
    const auto id = writer_->addChannel(channel);
    if (!id) return disk::systemError(channel.topic, ENOSPC);  // more than MCAP can number
    return writer_->write(*id, stamp, bytes);
  }
  std::optional<disk::FileError> finish() {
    if (auto fault = writer_->close()) return fault;
    return target_->place();
  }

 private:
  WholeMcap(WholeTarget& target, std::unique_ptr<recording::McapWriter> writer)
      : target_(&target), writer_(std::move(writer)) {}
  WholeTarget* target_;  // the writer's
  std::unique_ptr<recording::McapWriter> writer_;
};

/// What is damaged in a recording; `cut_short`: its end is missing, too.
inline void addLosses(Written& done, const recording::Source& source, bool cut_short) {
  if (cut_short) done.losses.push_back(robot::recorded::interruptionOf(source.summary()));
  for (const recording::Note& note : source.summary().notes) {
    const bool untimed = note.code == recording::NoteCode::TimeUnusable;
    if (!untimed && !robot::recorded::isLoss(note.code)) continue;
    done.losses.push_back(
        untimed ? Fault(robot::recorded::fault::RecordingMessagesUntimed, {std::int64_t(note.count)})
                : robot::recorded::reasonOf(note));
    done.damaged |= note.code != recording::NoteCode::CutOff;
  }
}

}  // namespace mapwright::excerpt
