#include "app/recording_slice.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "app/bag_mcap.h"
#include "reasons/file_reason.h"
#include "recording/append_file.h"
#include "recording/mcap_writer.h"
#include "recording/source.h"
#include "robot/recorded/recording_reasons.h"

namespace mapwright::app {
namespace {

using recording::Message;

constexpr std::int64_t kEver = std::numeric_limits<std::int64_t>::max();
constexpr std::string_view kStaticTransforms = "/tf_static", kPatches = "_updates";

using Done = tl::expected<void, map::Reason>;

class Slice {
 public:
  Slice(recording::Source& source, recording::McapWriter& writer) : source_(source), writer_(writer) {}

  Done describe() {
    for (const recording::Metadata& metadata : source_.metadata()) {
      if (auto done = checked(writer_.note(metadata)); !done) return done;
    }
    return {};
  }

  Done sayBefore(std::int64_t from_ns, const std::vector<std::string>& topics) {
    if (from_ns <= 0) return {};
    std::vector<Message> before = source_.lastBefore(from_ns - 1, topics);
    std::vector<Message> more;
    for (const Message& message : before) {
      const std::string& topic = message.channel->topic;
      if (topic == kStaticTransforms) {
        readInto(more, {.first_ns = 0, .last_ns = from_ns - 1, .topics = {topic}});
      } else if (topic.size() > kPatches.size() && topic.ends_with(kPatches)) {
        // They change the grid that came before them, whether or not anybody asked for that.
        const auto whole = std::find_if(before.begin(), before.end(), [&](const Message& other) {
          return topic.compare(0, topic.size() - kPatches.size(), other.channel->topic) == 0;
        });
        const std::int64_t since_ns = whole == before.end() ? 0 : whole->log_time_ns;
        readInto(more, {.first_ns = since_ns, .last_ns = from_ns - 1, .topics = {topic}});
      } else {
        more.push_back(message);
      }
    }
    std::stable_sort(more.begin(), more.end(),
                     [](const Message& a, const Message& b) { return a.log_time_ns < b.log_time_ns; });
    for (const Message& message : more) {
      recording::Channel channel = *message.channel;
      channel.metadata["said"] = "before";
      if (auto done = write(channel, from_ns, 0, message); !done) return done;
    }
    done_.said_before = std::int64_t(more.size());
    return {};
  }

  Done copy(std::int64_t from_ns, std::int64_t to_ns, const std::vector<std::string>& topics) {
    const auto cursor = source_.messages({.first_ns = from_ns, .last_ns = to_ns, .topics = topics});
    while (const auto message = cursor->next()) {
      if (auto done = write(*message->channel, message->log_time_ns, message->sequence, *message); !done)
        return done;
      ++done_.messages;
    }
    return {};
  }

  Done attach(std::int64_t from_ns, std::int64_t to_ns) {
    // Of what was fetched only later the first one counts (recorder/layout.h).
    std::map<std::string, const recording::AttachmentPlace*> first_of;
    for (const recording::AttachmentPlace& place : source_.attachments()) {
      const auto [first, is_new] = first_of.try_emplace(place.name, &place);
      if (!is_new && place.log_time_ns < first->second->log_time_ns) first->second = &place;
    }
    for (const recording::AttachmentPlace& place : source_.attachments()) {
      if (place.log_time_ns > to_ns && first_of.at(place.name) != &place) continue;
      auto attachment = source_.attachment(place);
      if (!attachment) continue;  // it is not sound, and of no use there either
      attachment->log_time_ns = std::clamp(attachment->log_time_ns, from_ns, std::max(from_ns, to_ns));
      if (auto done = checked(writer_.attach(*attachment)); !done) return done;
      ++done_.attachments;
    }
    return {};
  }

  SlicedRecording done() const {
    SlicedRecording done = done_;
    for (const recording::Note& note : source_.summary().notes) {
      if (robot::recorded::isLoss(note.code)) done.losses.push_back(robot::recorded::reasonOf(note));
    }
    return done;
  }

 private:
  static Done checked(const std::optional<disk::Fault>& fault) {
    if (fault) return tl::make_unexpected(reasons::notWritten(*fault));
    return {};
  }
  void readInto(std::vector<Message>& messages, const recording::Query& query) {
    const auto cursor = source_.messages(query);
    while (auto message = cursor->next()) messages.push_back(std::move(*message));
  }
  Done write(const recording::Channel& channel, std::int64_t log_ns, std::uint32_t sequence,
             const Message& message) {
    const auto id = writer_.addChannel(channel);
    if (!id) return checked(disk::systemFault(channel.topic, ENOSPC));
    return checked(writer_.write(*id, {log_ns, message.publish_time_ns, sequence}, message.bytes));
  }

  recording::Source& source_;
  recording::McapWriter& writer_;
  SlicedRecording done_;
};

}  // namespace

tl::expected<SlicedRecording, map::Reason> sliceRecording(const std::string& path, const std::string& output,
                                                          const TimeSpan& span, const std::string& topic) {
  auto source = recording::openRecording(path);
  if (!source) return tl::make_unexpected(robot::recorded::reasonOf(source.error()));
  const std::string aside = output + ".part";
  auto target = recording::appendFile(aside, recording::Existing::Replace);
  if (!target) return tl::make_unexpected(reasons::notWritten(target.error()));
  auto writer = recording::McapWriter::create(std::move(*target), {.profile = (*source)->summary().profile});
  if (!writer) return tl::make_unexpected(reasons::notWritten(writer.error()));

  const std::int64_t from_ns = span.from_s ? nanosecondsOf(*span.from_s) : 0;
  const std::int64_t to_ns = span.to_s ? nanosecondsOf(*span.to_s) : kEver;
  const std::vector<std::string> topics = topic.empty() ? std::vector<std::string>() : std::vector{topic};
  Slice slice(**source, **writer);
  const Done done = slice.describe()
                        .and_then([&] { return slice.sayBefore(from_ns, topics); })
                        .and_then([&] { return slice.copy(from_ns, to_ns, topics); })
                        .and_then([&] { return slice.attach(from_ns, to_ns); })
                        .and_then([&]() -> Done {
                          if (const auto fault = (*writer)->close())
                            return tl::make_unexpected(reasons::notWritten(*fault));
                          if (std::rename(aside.c_str(), output.c_str()) != 0)
                            return tl::make_unexpected(reasons::notWritten(disk::systemFault(output, errno)));
                          return {};
                        });
  if (done) return slice.done();
  writer->reset();
  std::error_code nothing_more_to_do;
  std::filesystem::remove(aside, nothing_more_to_do);
  return tl::make_unexpected(done.error());
}

}  // namespace mapwright::app
