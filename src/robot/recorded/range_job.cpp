#include "robot/recorded/range_job.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "recorder/layout.h"
#include "robot/axbot/faults.h"
#include "robot/axbot/parse_topics.h"
#include "robot/recorded/faults.h"

namespace mapwright::robot::recorded {
namespace {

constexpr std::int64_t kRoundingNs = 2'000;  // the precision of a double for seconds since 1970
constexpr double kShortestS = 1.0 / 64;      // of ranges that can be shortened (replay::Tick)
constexpr std::size_t kMostAtAll = std::size_t(1) << 30;
constexpr std::size_t kMostUnknown = std::size_t(64) << 10;  // larger useless ones are not parsed for display
constexpr std::size_t kMostProblems = 200;
constexpr int kMostAtOnce = 4000;  // earlier messages that are looked at before others have their turn
constexpr std::int64_t kMostLast = std::int64_t(16) << 20;  // of the initial state before a range

/// Approximate memory besides its text.
struct Weight {
  std::size_t operator()(const map::GridMessage& grid) const { return grid.png ? grid.png->size() : 0; }
  std::size_t operator()(const map::PointCloudMessage& cloud) const {
    return cloud.points ? cloud.points->size() * sizeof(map::CloudPoint) : 0;
  }
  std::size_t operator()(const map::PathMessage& path) const { return path.points.size() * 16; }
  std::size_t operator()(const map::LocalPathMessage& path) const { return path.points.size() * 16; }
  std::size_t operator()(const map::SeenObjectsMessage& seen) const {
    std::size_t bytes = seen.objects.size() * sizeof(map::GroundBox);
    for (const map::GroundDrawing& drawing : seen.drawings)
      bytes += sizeof(drawing) + drawing.points.size() * 16 + drawing.colors.size() * 4;
    return bytes;
  }
  template <typename Other>
  std::size_t operator()(const Other&) const {
    return 0;
  }
};

std::size_t weightOf(const map::TopicMessage& message) { return std::visit(Weight(), message); }

}  // namespace

RangeJob::RangeJob(BagKey key, BagRange range)
    : key_(std::move(key)),
      range_(range),
      next_ns_(recording::nanosecondsOf(range.from_s) - kRoundingNs),
      last_ns_(recording::nanosecondsOf(range.until_s) + kRoundingNs) {
  chunk_->from_s = range_.from_s;
  chunk_->until_s = range_.until_s;
  chunk_->from_cache = true;
}

RangeJob::Step RangeJob::step(const Parts& parts) {
  if (range_.back_fill && !last_) {
    findLast(parts);
    return Step::More;
  }
  if (last_ && !last_->empty()) {
    finishLast(parts);
    return Step::More;
  }
  auto block = nextBlock(parts);
  if (!parts.shape.markers.empty()) {
    // What is shown changes without a message where a lifetime ends.
    const std::int64_t from_ns = BlockPlacing::blockOf(next_ns_);
    if (!knowsEarlier(parts, from_ns)) return Step::More;
    const std::int64_t last_ns = std::min(last_ns_, parts.file.summary().end_ns.value_or(last_ns_));
    const auto end_ns = parts.lasting.nextMarkerEnd();
    const auto ending =
        end_ns && *end_ns <= last_ns ? std::optional(BlockPlacing::blockOf(*end_ns)) : std::nullopt;
    if (ending && *ending < block.value_or(*ending + 1)) block = std::max(*ending, from_ns);
  }
  if (!block) return Step::Done;
  if (!knowsEarlier(parts, *block)) return Step::More;
  const std::int64_t block_ns = *block, end_ns = block_ns + BlockPlacing::kBlockNs;
  const std::int64_t from_ns = std::max(next_ns_, block_ns);
  recording::Query query;
  query.first_ns = from_ns;
  query.last_ns = std::min(last_ns_, end_ns - 1);
  const auto cursor = parts.file.messages(query);
  std::optional<BlockPlacing> placing;
  if (parts.shape.any()) {
    placing.emplace(parts, block_ns, from_ns, last_ns_);
  }
  while (const auto message = cursor->next()) {
    if (placing) addResults(placing->before(saidNs(*message)), nullptr);
    onMessage(parts, *message, placing ? &*placing : nullptr);
    const bool too_long = bytes_ > std::size_t(std::max<std::int64_t>(range_.max_bytes, 0));
    if (too_long && range_.until_s - range_.from_s > kShortestS) return Step::TooLong;
    if (bytes_ > kMostAtAll) {
      addProblem({}, map::ProblemCode::Unreadable, {fault::AnswerTooLong, {std::int64_t(kMostAtAll)}});
      return Step::Done;
    }
  }
  if (placing) {
    const std::int64_t last_ns = parts.file.summary().end_ns.value_or(end_ns);
    addResults(placing->before(std::min({end_ns - 1, last_ns_, last_ns})), nullptr);
  }
  next_ns_ = end_ns;
  return end_ns > last_ns_ ? Step::Done : Step::More;
}

void RangeJob::findLast(const Parts& parts) {
  last_ = parts.file.lastBefore(next_ns_ - 1, {});
  std::sort(last_->begin(), last_->end(),
            [](const auto& a, const auto& b) { return a.log_time_ns > b.log_time_ns; });
  // In reverse order. If there are too many, the latest, without large ones.
  std::size_t bytes = 0;
  const auto most = std::size_t(std::clamp<std::int64_t>(range_.max_bytes / 4, 0, kMostLast));
  std::erase_if(*last_, [&](const recording::Message& message) {
    const bool too_many = message.bytes.size() > most - bytes;
    bytes += too_many ? 0 : message.bytes.size();
    return too_many;
  });
}

bool RangeJob::knowsEarlier(const Parts& parts, std::int64_t block_ns) {
  return !parts.shape.any() || parts.lasting.reach(block_ns, kMostAtOnce);
}

void RangeJob::finishLast(const Parts& parts) {
  const std::int64_t at_ns = last_->back().log_time_ns;
  const recording::Channel& channel = *last_->back().channel;
  const bool placed = parts.shape.isRos(channel) && parts.shape.by_topic.contains(channel.topic);
  if (placed && !knowsEarlier(parts, BlockPlacing::blockOf(at_ns))) return;
  const recording::Message message = std::move(last_->back());
  last_->pop_back();
  std::optional<BlockPlacing> placing;
  if (placed) {
    placing.emplace(parts, BlockPlacing::blockOf(at_ns), at_ns, at_ns);
  }
  // It is not part of the request: neither its length nor its errors count here.
  const std::size_t bytes = bytes_, unreadable = chunk_->unreadable;
  adding_last_ = true;
  onMessage(parts, message, placing ? &*placing : nullptr);
  adding_last_ = false;
  bytes_ = bytes;
  chunk_->unreadable = unreadable;
}

std::optional<std::int64_t> RangeJob::nextBlock(const Parts& parts) const {
  recording::Query query;
  query.first_ns = next_ns_;
  query.last_ns = last_ns_;
  if (!parts.shape.markers.empty()) {
    // Visible markers may change without a message, wherever in a block the range begins and ends.
    query.first_ns = BlockPlacing::blockOf(next_ns_);
    query.last_ns = BlockPlacing::blockOf(last_ns_) + BlockPlacing::kBlockNs - 1;
  }
  const auto first = parts.file.messages(query)->next();
  return first ? std::optional(BlockPlacing::blockOf(first->log_time_ns)) : std::nullopt;
}

BagChunkPtr RangeJob::chunk(std::size_t untimed) {
  chunk_->without_stamp += untimed;
  chunk_->text = std::make_shared<const std::string>(std::move(text_));
  return chunk_;
}

void RangeJob::add(BagMessage told, std::string_view text) {
  if (!takes(told.message.received_s)) return;
  told.at = text_.size();
  told.size = text.size();
  text_.append(text).push_back('\n');
  const std::size_t weight = weightOf(told.message.message);
  chunk_->value_bytes += weight;
  bytes_ += weight + text.size();
  chunk_->messages.push_back(std::move(told));
}

void RangeJob::keepLastPose() {
  BagMessage& now = chunk_->messages.back();
  if (!std::holds_alternative<map::TrackedPose>(now.message.message)) return;
  const std::size_t index = chunk_->messages.size() - 1;
  if (const auto last = std::exchange(last_pose_, index)) {
    BagMessage& before = chunk_->messages[*last];
    if (before.message.received_s != now.message.received_s) return;
    before.known = false;
    before.message.message = map::UnreadableMessage{before.message.topic, {}};
  }
}

void RangeJob::reportUndecoded(const std::string& topic, Fault reason) {
  if (range_.whole_texts) return addProblem(topic, map::ProblemCode::Unreadable, std::move(reason));
  addProblem(topic, map::ProblemCode::Odd, std::move(reason), map::Severity::Info);
}

void RangeJob::addProblem(const std::string& topic, map::ProblemCode code, Fault reason,
                          map::Severity severity) {
  if (problems_.size() >= kMostProblems) return;
  map::Problem problem{severity, map::Subject(map::SubjectKind::Topic, topic), std::move(reason), code};
  if (topic.empty()) problem.subject = subjectOf(key_);
  const bool known = std::any_of(problems_.begin(), problems_.end(), [&](const map::Problem& one) {
    return one.subject == problem.subject && one.code == code && one.reason.code == problem.reason.code;
  });
  if (!known) problems_.push_back(std::move(problem));
}

void RangeJob::addResults(ros::WorldResults results, BagMessage* told) {
  for (ros::WorldResult& result : results) {
    const bool within = takes(result.received_s);
    if (within && result.unplaced) addProblem(result.topic, map::ProblemCode::Unplaced, *result.unplaced);
    for (const Fault& note : within ? result.notes : std::vector<Fault>())
      addProblem(result.topic, map::ProblemCode::Odd, note);
    const bool own = told != nullptr && result.topic == told->message.topic && !told->known;
    if (result.unreadable && own) {
      told->known = true;
      told->message.message = map::UnreadableMessage{result.topic, *result.unreadable};
      continue;
    }
    // Derived results were not recorded.
    if (!result.message || (range_.whole_texts && !own)) continue;
    if (own) {
      told->known = true;
      told->message.message = std::move(*result.message);
      told->message.recorded_s = result.recorded_s;
      continue;
    }
    BagMessage more;
    more.known = true;
    more.message = {std::move(*result.message), result.received_s, result.recorded_s, result.topic};
    add(std::move(more), {});
  }
}

void RangeJob::onFrame(const Parts& parts, const wire::Json& root, const recording::Message& message,
                       BagMessage& told) {
  axbot::TextFrame frame = axbot::readFrameOn(message.channel->topic, root);
  told.message.recorded_s = wire::epochSeconds(root, {"stamp"});
  told.known = frame.message || frame.grid_to_fetch;
  if (frame.message) {
    told.message.message = std::move(*frame.message);
  } else if (frame.grid_to_fetch) {
    told.message.message = std::move(frame.grid_to_fetch->grid);
    told.picture_url = parts.kept.pictureName(frame.grid_to_fetch->data_url, message.log_time_ns);
  }
}

void RangeJob::onMessage(const Parts& parts, const recording::Message& message, BlockPlacing* placing) {
  const recording::Channel& channel = *message.channel;
  const double stamp_s = recording::secondsOf(message.log_time_ns);
  BagMessage told;
  told.message.received_s = stamp_s;
  told.message.topic = channel.topic;
  told.message.message = map::UnreadableMessage{channel.topic, {}};
  const bool placed =
      placing != nullptr && parts.shape.isRos(channel) && parts.shape.by_topic.contains(channel.topic);
  // One outside the range is read if the next ones depend on it.
  if (!placed && !takes(stamp_s)) return;
  bytes_ += message.bytes.size();
  const MessageText texts(message,
                          range_.whole_texts ? MessageText::For::Programs : MessageText::For::People);
  std::string text;
  if (parts.shape.isRos(channel)) {
    const bool read = placed || range_.whole_texts || message.bytes.size() <= kMostUnknown;
    const auto frame = read ? parts.fields.read(message) : tl::unexpected(Fault());
    if (frame && parts.fields.beyond() > 0)
      reportUndecoded(channel.topic, {fault::RosMessageLonger, {std::int64_t(parts.fields.beyond())}});
    text = texts.ofRos(frame, parts.fields);
    if (frame) {
      if (placed) addResults(placing->add(message, *frame), &told);
    } else if (placed && frame.error().any()) {
      told.known = true;
      told.message.message = map::UnreadableMessage{channel.topic, frame.error()};
    }
    if (!frame && frame.error().any()) {
      if (range_.whole_texts || !placed) reportUndecoded(channel.topic, frame.error());
      // One outside the range is counted in its own.
      if (!range_.whole_texts && placed && takes(stamp_s)) ++chunk_->unreadable;
    }
  } else if (channel.message_encoding == "json" && channel.schema_name == recorder::kAxbotBinarySchema) {
    // One that could not be unpacked during recording.
    const auto root = json_.read(texts.bytes());
    told.known = root.has_value();
    if (root) {
      const QByteArray frame =
          QByteArray::fromBase64(QByteArray::fromStdString(wire::text(*root, {"base64"})));
      const auto read = axbot::parseBinaryFrame({frame.constData(), std::size_t(frame.size())});
      if (read) told.message.message = *read;
    }
    text = texts.ofBytes();
  } else if (channel.message_encoding == "json") {
    const auto root = json_.read(texts.bytes());
    if (root && root->is_object()) {
      onFrame(parts, *root, message, told);
      text = texts.ofFrame(*root);
    } else {
      addProblem(channel.topic, map::ProblemCode::Unreadable,
                 {robot::axbot::fault::MessageNotJson, {std::int64_t(texts.bytes().size())}});
      if (!range_.whole_texts) {
        ++chunk_->unreadable;
        return;
      }
      text = texts.ofBytes();
    }
  } else if (channel.schema_name == recorder::kAxbotBinarySchema) {
    if (auto read = axbot::parseBinaryFrame(texts.bytes())) {
      told.known = true;
      told.message.message = std::move(*read);
    }
    text = texts.ofBinaryFrame();
  } else {
    if (channel.message_encoding == "protobuf" && channel.schema_name == axbot::kBinaryType) {
      if (auto read = axbot::parseBinaryBody(channel.topic, texts.bytes())) {
        told.known = true;
        told.message.message = std::move(*read);
      }
    }
    // Large ones are not parsed just for display.
    const bool read = range_.whole_texts || message.bytes.size() <= kMostUnknown;
    const auto frame = read ? parts.fields.readOther(message) : tl::unexpected(Fault());
    text = texts.ofOther(frame);
    if (!frame && frame.error().any()) reportUndecoded(channel.topic, frame.error());
  }
  const std::size_t before = chunk_->messages.size();
  add(std::move(told), text);
  if (placed && chunk_->messages.size() > before) keepLastPose();
}

}  // namespace mapwright::robot::recorded
