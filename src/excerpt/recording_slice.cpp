#include "excerpt/recording_slice.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "excerpt/whole_target.h"
#include "recorder/layout.h"
#include "robot/recorded/earlier_messages.h"

namespace mapwright::excerpt {
namespace {

using recording::Message;

constexpr std::int64_t kLookEvery = 256;  // messages
constexpr int kLookedAtOnce = 4096;
constexpr std::int64_t kEver = std::numeric_limits<std::int64_t>::max();

using Done = tl::expected<void, Fault>;

class Slice {
 public:
  Slice(recording::Source& source, robot::recorded::EarlierMessages& earlier, WholeMcap& file,
        const GoesOn& goes_on)
      : source_(source), earlier_(earlier), file_(file), goes_on_(goes_on) {}

  bool ended() const { return ended_; }

  Done describe() {
    for (const recording::Metadata& metadata : source_.metadata()) {
      if (auto done = checked(file_.writer().addMetadata(metadata)); !done) return done;
    }
    return {};
  }

  Done sayBefore(std::int64_t from_ns, const std::vector<std::string>& topics) {
    if (from_ns <= 0) return {};
    if (!source_.summary().start_ns || from_ns <= *source_.summary().start_ns) return {};
    while (!earlier_.reach(from_ns, kLookedAtOnce)) {
      ended_ = goes_on_ && !goes_on_(0);
      if (ended_) return {};
    }
    for (const Message& message : earlier_.before(from_ns)) {
      if (!isOneOf(topics, message.channel->topic)) continue;
      recording::Channel channel = *message.channel;
      channel.metadata[recorder::kSaid] = recorder::kBefore;
      channel.metadata[recorder::kSaidAt] = recorder::kPublishTime;
      const recording::Stamp stamp{from_ns, robot::recorded::saidNs(message), 0};
      if (auto done = checked(file_.write(channel, stamp, message.bytes)); !done) return done;
      ++done_.said_before;
      done_.topics.insert(message.channel->topic);
    }
    return {};
  }

  Done copy(std::int64_t from_ns, std::int64_t to_ns, const std::vector<std::string>& topics) {
    if (ended_) return {};
    const double first_ns = double(std::max(from_ns, source_.summary().start_ns.value_or(from_ns)));
    const double all_ns = double(std::min(to_ns, source_.summary().end_ns.value_or(to_ns))) - first_ns;
    const auto cursor = source_.messages({.first_ns = from_ns, .last_ns = to_ns, .topics = topics});
    while (const auto message = cursor->next()) {
      if (auto done = write(*message->channel, message->log_time_ns, message->sequence, *message); !done)
        return done;
      done_.topics.insert(message->channel->topic);
      if (++done_.messages % kLookEvery != 0 || !goes_on_) continue;
      const double share = all_ns > 0 ? (double(message->log_time_ns) - first_ns) / all_ns : 1;
      ended_ = !goes_on_(std::clamp(share, 0.0, 1.0));
      if (ended_) break;
    }
    return {};
  }

  /// With their own times in every part, so that duplicates in two parts can be recognised.
  Done attach(std::int64_t to_ns) {
    if (ended_) return {};
    // Of attachments fetched only later the first one counts (recorder/layout.h).
    std::map<std::string, const recording::AttachmentLocation*> first_of;
    for (const recording::AttachmentLocation& location : source_.attachments()) {
      const auto [first, is_new] = first_of.try_emplace(location.name, &location);
      if (!is_new && location.log_time_ns < first->second->log_time_ns) first->second = &location;
    }
    for (const recording::AttachmentLocation& location : source_.attachments()) {
      if (location.log_time_ns > to_ns && first_of.at(location.name) != &location) continue;
      const auto attachment = source_.attachment(location);
      if (!attachment) continue;  // it is damaged, and useless there
      if (auto done = checked(file_.writer().attach(*attachment)); !done) return done;
      ++done_.attachments;
    }
    return {};
  }

  /// The interruption comes after the last message, so it does not apply to parts that end earlier.
  Done markEnd(std::int64_t to_ns, bool repair) {
    const std::int64_t last_ns = source_.summary().end_ns.value_or(0);
    cut_short_ = robot::recorded::isInterrupted(source_) && to_ns >= last_ns;
    if (ended_ || !robot::recorded::isInterrupted(source_)) return {};
    if (cut_short_)
      return repair ? checked(file_.writer().addMetadata(robot::recorded::repairMark(source_.summary())))
                    : Done();
    return checked(file_.writer().addMetadata({recorder::kEnd, {{"ended_ns", std::to_string(to_ns)}}}));
  }

  Written done() const {
    Written done = done_;
    addLosses(done, source_, cut_short_);
    return done;
  }

 private:
  static Done checked(const std::optional<disk::FileError>& fault) {
    if (fault) return tl::make_unexpected(disk::notWritten(*fault));
    return {};
  }
  Done write(const recording::Channel& channel, std::int64_t log_ns, std::uint32_t sequence,
             const Message& message) {
    return checked(file_.write(channel, {log_ns, message.publish_time_ns, sequence}, message.bytes));
  }

  recording::Source& source_;
  robot::recorded::EarlierMessages& earlier_;
  WholeMcap& file_;
  const GoesOn& goes_on_;
  Written done_;
  bool ended_ = false, cut_short_ = false;
};

}  // namespace

struct Slicing::Parts {
  explicit Parts(std::unique_ptr<recording::Source> opened) : source(std::move(opened)), earlier(*source) {}
  std::unique_ptr<recording::Source> source;
  robot::recorded::EarlierMessages earlier;
};

Slicing::Slicing(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Slicing::Slicing(Slicing&&) noexcept = default;
Slicing::~Slicing() = default;

recording::Source& Slicing::source() const { return *parts_->source; }

tl::expected<Slicing, Fault> Slicing::open(const std::string& path) {
  auto source = recording::openRecording(path);
  if (!source) return tl::make_unexpected(robot::recorded::reasonOf(source.error()));
  return Slicing(std::make_unique<Parts>(std::move(*source)));
}

tl::expected<std::optional<Written>, Fault> Slicing::slice(const Order& order, const GoesOn& goes_on) {
  recording::Source& source = *parts_->source;
  auto file = WholeMcap::create(order, source.summary().profile);
  if (!file) return tl::make_unexpected(disk::notWritten(file.error()));

  const std::int64_t from_ns =
      order.first_ns.value_or(order.span.from_s ? firstNanosecondsOf(*order.span.from_s) : 0);
  const std::int64_t to_ns =
      order.last_ns.value_or(order.span.to_s ? lastNanosecondsOf(*order.span.to_s) : kEver);
  const std::vector<std::string>& topics = order.topics;
  Slice slice(source, parts_->earlier, *file, goes_on);
  const Done done = slice.describe()
                        .and_then([&] { return slice.sayBefore(from_ns, topics); })
                        .and_then([&] { return slice.copy(from_ns, to_ns, topics); })
                        .and_then([&] { return slice.attach(to_ns); })
                        .and_then([&] { return slice.markEnd(to_ns, order.repair); });
  if (!done) return tl::make_unexpected(done.error());
  if (slice.ended()) return std::nullopt;
  if (const auto fault = file->finish()) return tl::make_unexpected(disk::notWritten(*fault));
  return slice.done();
}

tl::expected<std::optional<Written>, Fault> sliceRecording(const std::string& path, const Order& order,
                                                           const GoesOn& goes_on) {
  auto slicing = Slicing::open(path);
  if (!slicing) return tl::make_unexpected(slicing.error());
  return slicing->slice(order, goes_on);
}

}  // namespace mapwright::excerpt
