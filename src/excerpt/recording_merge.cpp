#include "excerpt/recording_merge.h"

#include <algorithm>
#include <cerrno>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "excerpt/whole_target.h"
#include "reasons/file_reason.h"
#include "recording/mcap_writer.h"
#include "recording/source.h"
#include "robot/recorded/interruption.h"
#include "robot/recorded/recording_reasons.h"

namespace mapwright::excerpt {
namespace {

constexpr const char* kEndMark = "mapwright.end";

using SourcePtr = std::unique_ptr<recording::Source>;

class Merge {
 public:
  Merge(const std::vector<SourcePtr>& sources, recording::McapWriter& writer)
      : sources_(sources), writer_(writer) {}

  std::optional<disk::Fault> describe() {
    // The whole has an end only where all of them have.
    const bool whole = std::none_of(sources_.begin(), sources_.end(), [](const SourcePtr& one) {
      return robot::recorded::isInterrupted(*one);
    });
    for (const SourcePtr& source : sources_) {
      for (const recording::Metadata& metadata : source->metadata()) {
        if (!whole && metadata.name == kEndMark) continue;
        if (auto fault = writer_.note(metadata)) return fault;
      }
    }
    return std::nullopt;
  }

  std::optional<disk::Fault> copy(const recording::Query& query) {
    std::vector<std::unique_ptr<recording::Cursor>> cursors;
    std::vector<std::optional<recording::Message>> heads;
    for (const SourcePtr& source : sources_) {
      cursors.push_back(source->messages(query));
      heads.push_back(cursors.back()->next());
    }
    while (true) {
      const auto next = std::min_element(heads.begin(), heads.end(), [](const auto& a, const auto& b) {
        return a && (!b || a->log_time_ns < b->log_time_ns);
      });
      if (next == heads.end() || !*next) return std::nullopt;
      const recording::Message& message = **next;
      const auto id = writer_.addChannel(*message.channel);
      if (!id) return disk::systemFault(message.channel->topic, ENOSPC);
      if (auto fault = writer_.write(*id, {message.log_time_ns, message.publish_time_ns, message.sequence},
                                     message.bytes))
        return fault;
      ++done_.messages;
      *next = cursors[std::size_t(next - heads.begin())]->next();
    }
  }

  std::optional<disk::Fault> attach() {
    for (const SourcePtr& source : sources_) {
      for (const recording::AttachmentPlace& place : source->attachments()) {
        const auto attachment = source->attachment(place);
        if (!attachment) continue;  // it is not sound, and of no use there either
        if (auto fault = writer_.attach(*attachment)) return fault;
        ++done_.attachments;
      }
    }
    return std::nullopt;
  }

  Written done() const {
    Written done = done_;
    for (const SourcePtr& source : sources_) {
      if (robot::recorded::isInterrupted(*source))
        done.losses.push_back(robot::recorded::interruptionOf(source->summary()));
      for (const recording::Note& note : source->summary().notes) {
        if (robot::recorded::isLoss(note.code)) done.losses.push_back(robot::recorded::reasonOf(note));
      }
    }
    return done;
  }

 private:
  const std::vector<SourcePtr>& sources_;
  recording::McapWriter& writer_;
  Written done_;
};

}  // namespace

tl::expected<Written, map::Reason> mergeRecordings(const std::vector<std::string>& paths,
                                                   const Order& order) {
  std::vector<SourcePtr> sources;
  for (const std::string& path : paths) {
    auto source = recording::openRecording(path);
    if (!source) {
      const map::Reason why = robot::recorded::reasonOf(source.error());
      if (why.code == map::ReasonCode::RecordingNotOpened) return tl::make_unexpected(why);
      return tl::make_unexpected(map::Reason(map::ReasonCode::RecordingNotOpened, {path}, {why}));
    }
    sources.push_back(std::move(*source));
  }
  std::string profile = sources.empty() ? std::string() : sources.front()->summary().profile;
  for (const SourcePtr& source : sources) {
    if (source->summary().profile != profile) profile.clear();
  }
  auto made = std::make_unique<WholeTarget>(order.path);
  WholeTarget& target = *made;
  auto writer = recording::McapWriter::create(std::move(made), wholeFileOptions(profile));
  if (!writer) return tl::make_unexpected(reasons::notWritten(writer.error()));
  recording::Query query;
  if (order.span.from_s) query.first_ns = nanosecondsOf(*order.span.from_s);
  if (order.span.to_s) query.last_ns = nanosecondsOf(*order.span.to_s);
  query.topics = order.topics;
  Merge merge(sources, **writer);
  std::optional<disk::Fault> fault = merge.describe();
  if (!fault) fault = merge.copy(query);
  if (!fault) fault = merge.attach();
  if (!fault) fault = (*writer)->close();
  if (!fault) fault = target.place();
  if (fault) return tl::make_unexpected(reasons::notWritten(*fault));
  return merge.done();
}

}  // namespace mapwright::excerpt
