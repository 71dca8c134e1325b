#include "recorder/tape.h"

#include <functional>
#include <span>

#include <QByteArray>

#include "net/rosbridge/frame.h"
#include "recorder/layout.h"
#include "recorder/ros_encode.h"

namespace mapwright::recorder {
namespace {

constexpr std::size_t kOverhead = 256;  // memory of an entry besides its bytes
constexpr std::int64_t kTryAgainNs = 1'000'000'000;

std::pair<std::size_t, std::size_t> contentOf(const Entry& entry) {
  return {entry.bytes.size(), std::hash<std::string>()(entry.bytes)};
}

using net::rosbridge::Frame;

constexpr const char* kAnyObject = R"({"type":"object"})";

QByteArray bytesOf(const std::string& text) { return {text.data(), qsizetype(text.size())}; }

std::shared_ptr<const Frame> frameOf(const Entry& message, const std::string& bytes) {
  return Frame::read(bytesOf(bytes), message.encoding == "cbor" ? Frame::Wire::Binary : Frame::Wire::Text);
}

bool isText(const Entry& message) { return message.encoding == "json" || message.encoding == "cbor"; }

}  // namespace

bool EntryQueue::put(Entry entry, std::string_view bytes) {
  const std::size_t size = bytes.size() + kOverhead;
  {
    const std::lock_guard lock(mutex_);
    if (closed_) return false;
    if (entry.kind == Entry::Kind::Message && !entry.before) entry.sequence = ++sequences_[entry.name];
    if (entry.kind == Entry::Kind::Message && entry.before) said_before_.insert(entry.name);
    // One that exceeds the limit is accepted if it is alone.
    if (held_bytes_ > 0 && held_bytes_ + size > most_bytes_) {
      ++lost_.entries;
      lost_.bytes += bytes.size();
      return false;
    }
    held_bytes_ += size;
    ++being_put_;
  }
  entry.bytes.assign(bytes);
  {
    const std::lock_guard lock(mutex_);
    --being_put_;
    entries_.push_back(std::move(entry));
  }
  came_.notify_one();
  return true;
}

bool EntryQueue::heard(const std::string& topic) const {
  const std::lock_guard lock(mutex_);
  return sequences_.contains(topic) || said_before_.contains(topic);
}

std::vector<Entry> EntryQueue::take(std::chrono::milliseconds at_most) {
  std::unique_lock lock(mutex_);
  came_.wait_for(lock, at_most, [this] { return !entries_.empty() || (closed_ && being_put_ == 0); });
  for (const Entry& entry : entries_) held_bytes_ -= entry.bytes.size() + kOverhead;
  return std::exchange(entries_, {});
}

void EntryQueue::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  came_.notify_one();
}

bool EntryQueue::over() const {
  const std::lock_guard lock(mutex_);
  return closed_ && entries_.empty() && being_put_ == 0;
}

EntryQueue::Losses EntryQueue::lost() const {
  const std::lock_guard lock(mutex_);
  return lost_;
}

bool MessageForms::ready(const Entry& message) const {
  return message.schema.empty() || definitions_.contains(message.schema);
}

void MessageForms::define(const Entry& definition) {
  Definition known;
  if (!definition.bytes.empty()) {
    known.encoding = definition.encoding;
    known.text = definition.bytes;
    if (const auto dialect = recording::rosDialect(known.encoding)) {
      auto schema = recording::parseRosSchema(definition.name, known.text, *dialect);
      if (schema) known.ros = std::move(*schema);
    }
  }
  Definition& held = definitions_[definition.name];
  if (held.encoding.empty()) held = std::move(known);
}

void MessageForms::giveUp(const std::string& type) { definitions_.try_emplace(type); }

MessageForms::Formed MessageForms::formed(const Entry& message, std::string bytes) const {
  const auto found = definitions_.find(message.schema);
  if (found == definitions_.end() || found->second.encoding.empty()) return asJson(message, std::move(bytes));
  const Definition& definition = found->second;
  Formed formed{message.encoding, message.schema, definition.encoding, definition.text, {}};
  if (message.encoding == definition.encoding) {  // "protobuf"
    formed.bytes = std::move(bytes);
    return formed;
  }
  if (!definition.ros || !isText(message)) return asJson(message, std::move(bytes));
  const bool ros2 = recording::rosDialect(definition.encoding) == recording::RosDialect::Ros2;
  const auto frame = frameOf(message, bytes);
  auto encoded =
      encodeRos(*definition.ros, ros2 ? recording::RosWire::Cdr : recording::RosWire::Ros1, frame->root());
  // A message that does not match its definition is written as received.
  if (!encoded) return asJson(message, std::move(bytes));
  formed.encoding = ros2 ? "cdr" : "ros1";
  formed.bytes = std::move(*encoded);
  return formed;
}

MessageForms::Formed MessageForms::asJson(const Entry& message, std::string bytes) {
  Formed formed{"json", message.schema.empty() ? kPlainJson : message.schema, "jsonschema", kAnyObject, {}};
  if (message.encoding == "json") {
    formed.bytes = std::move(bytes);
  } else if (message.encoding == "cbor") {
    formed.bytes = frameOf(message, bytes)->root().toWholeJson().toStdString();
  } else {
    formed.schema_name = kAxbotBinarySchema;
    formed.bytes = "{\"base64\":\"" + bytesOf(bytes).toBase64().toStdString() + "\"}";
  }
  return formed;
}

void Tape::write(Entry entry) {
  if (entry.kind == Entry::Kind::Definition) {
    forms_.define(entry);
    return writeUndefined(entry.name);
  }
  if (entry.kind == Entry::Kind::Message)
    return forms_.ready(entry) ? message(std::move(entry)) : holdUndefined(std::move(entry));
  if (entry.kind == Entry::Kind::File) {
    const auto content = contentOf(entry);
    const auto known = files_.find(entry.name);
    if (known != files_.end() && known->second == content) return;
    files_[entry.name] = content;
  }
  if (beside(entry)) wait(std::move(entry));
}

void Tape::message(Entry entry) {
  const MessageForms::Formed formed = forms_.formed(entry, std::move(entry.bytes));
  const auto channel = channelOf(entry, formed);
  if (!channel) return lose(formed.bytes.size());
  const std::uint64_t lost = writer_->progress().lost;
  const auto bytes =
      std::span(reinterpret_cast<const std::uint8_t*>(formed.bytes.data()), formed.bytes.size());
  fault_ = writer_->write(*channel, {entry.log_ns, entry.publish_ns, entry.sequence}, bytes);
  if (writer_->progress().lost != lost) lose(formed.bytes.size());
}

void Tape::holdUndefined(Entry entry) {
  if (undefined_bytes_ + entry.bytes.size() > kMostWaitingBytes) giveUp(std::nullopt);
  if (forms_.ready(entry)) return message(std::move(entry));
  undefined_bytes_ += entry.bytes.size();
  undefined_[entry.schema].messages.push_back(std::move(entry));
}

void Tape::writeUndefined(const std::string& type) {
  auto held = undefined_.extract(type);
  if (held.empty()) return;
  for (Entry& entry : held.mapped().messages) {
    undefined_bytes_ -= entry.bytes.size();
    message(std::move(entry));
  }
}

void Tape::giveUp(std::optional<std::int64_t> now_ns) {
  std::vector<std::string> over;
  for (auto& [type, held] : undefined_) {
    if (now_ns && !held.since_ns) held.since_ns = now_ns;
    // A clock that was set back must not cause a wait.
    const bool waits = now_ns && *now_ns >= *held.since_ns && *now_ns - *held.since_ns < kDefinedWithinNs;
    if (!waits) over.push_back(type);
  }
  for (const std::string& type : over) {
    forms_.giveUp(type);
    writeUndefined(type);
  }
}

std::optional<recording::ChannelId> Tape::channelOf(const Entry& entry, const MessageForms::Formed& formed) {
  Key key(entry.name, formed.encoding, formed.schema_name, formed.schema_encoding, entry.before);
  if (const auto known = channels_.find(key); known != channels_.end()) return known->second;
  recording::Channel channel;
  channel.topic = entry.name;
  channel.message_encoding = formed.encoding;
  channel.schema_name = formed.schema_name;
  channel.schema_encoding = formed.schema_encoding;
  channel.schema_data = formed.schema_data;
  if (entry.before) channel.metadata[kSaid] = kBefore;
  const auto added = writer_->addChannel(channel);
  if (added) channels_.emplace(std::move(key), *added);
  return added;
}

std::optional<disk::FileError> Tape::beside(const Entry& entry) {
  if (entry.kind == Entry::Kind::Metadata) {
    fault_ = writer_->addMetadata({entry.name, entry.values});
  } else {
    fault_ = writer_->attach({entry.name, entry.encoding, entry.log_ns, entry.publish_ns, entry.bytes});
    if (!fault_) ++files_written_;
  }
  return fault_;
}

void Tape::wait(Entry entry) {
  if (waiting_bytes_ + entry.bytes.size() > kMostWaitingBytes) {
    files_.erase(entry.name);  // it may come again
    return lose(entry.bytes.size());
  }
  waiting_bytes_ += entry.bytes.size();
  waiting_.push_back(std::move(entry));
}

void Tape::lose(std::size_t bytes) {
  ++lost_;
  lost_bytes_ += bytes;
}

void Tape::tick(std::int64_t now_ns) {
  giveUp(now_ns);
  fault_ = writer_->tick(now_ns);
  // A clock that was set back must not cause a wait.
  const bool may_try = now_ns < tried_ns_ || now_ns - tried_ns_ >= kTryAgainNs;
  if (waiting_.empty() || !may_try) return;
  tried_ns_ = now_ns;
  while (!waiting_.empty() && !beside(waiting_.front())) {
    waiting_bytes_ -= waiting_.front().bytes.size();
    waiting_.pop_front();
  }
}

std::optional<disk::FileError> Tape::finish(std::int64_t now_ns, EntryQueue::Losses elsewhere) {
  giveUp(std::nullopt);
  fault_ = writer_->flush();
  while (!waiting_.empty() && !beside(waiting_.front())) waiting_.pop_front();
  for (const Entry& entry : waiting_) lose(entry.bytes.size());
  waiting_.clear();
  recording::Metadata end;
  end.name = kEnd;
  end.values["ended_ns"] = std::to_string(now_ns);
  end.values["messages"] = std::to_string(writer_->progress().messages);
  end.values["lost"] = std::to_string(lost_ + elsewhere.entries);
  end.values["lost_bytes"] = std::to_string(lost_bytes_ + elsewhere.bytes);
  writer_->addMetadata(end);  // even if closing fails there
  fault_ = writer_->close();
  ended_ = true;
  return fault_;
}

Written Tape::written() const {
  const recording::McapWriter::Progress progress = writer_->progress();
  Written written;
  written.bytes = progress.bytes;
  written.messages = ended_ ? progress.in_chunks : progress.messages;
  written.files = files_written_;
  written.lost = lost_ + (progress.messages - written.messages);
  written.lost_bytes = lost_bytes_;
  written.fault = fault_;
  return written;
}

}  // namespace mapwright::recorder
