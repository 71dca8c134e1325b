#include "recorder/tape.h"

#include <functional>
#include <span>
#include <utility>

#include "recorder/layout.h"

namespace mapwright::recorder {
namespace {

constexpr std::int64_t kTryAgainNs = 1'000'000'000;

std::pair<std::size_t, std::size_t> contentOf(const Entry& entry) {
  return {entry.bytes.size(), std::hash<std::string>()(entry.bytes)};
}

}  // namespace

void Tape::write(Entry entry) {
  if (entry.kind == Entry::Kind::Message) return message(entry);
  if (entry.kind == Entry::Kind::File) {
    const auto content = contentOf(entry);
    const auto known = files_.find(entry.name);
    if (known != files_.end() && known->second == content) return;
    files_[entry.name] = content;
  }
  if (beside(entry)) wait(std::move(entry));
}

void Tape::message(const Entry& entry) {
  const auto channel = channelOf(entry);
  if (!channel) return lose(entry);
  const std::uint64_t lost = writer_->progress().lost;
  const auto bytes = std::span(reinterpret_cast<const std::uint8_t*>(entry.bytes.data()), entry.bytes.size());
  fault_ = writer_->write(*channel, {entry.log_ns, entry.publish_ns, entry.sequence}, bytes);
  if (writer_->progress().lost != lost) lose(entry);
}

std::optional<recording::ChannelId> Tape::channelOf(const Entry& entry) {
  Key key(entry.name, entry.encoding, entry.schema, entry.before);
  if (const auto known = channels_.find(key); known != channels_.end()) return known->second;
  recording::Channel channel;
  channel.topic = entry.name;
  channel.message_encoding = entry.encoding;
  channel.schema_name = entry.schema;
  if (entry.before) channel.metadata[kSaid] = kBefore;
  const auto added = writer_->addChannel(channel);
  if (added) channels_.emplace(std::move(key), *added);
  return added;
}

std::optional<disk::Fault> Tape::beside(const Entry& entry) {
  if (entry.kind == Entry::Kind::Words) {
    fault_ = writer_->note({entry.name, entry.words});
  } else {
    fault_ = writer_->attach({entry.name, entry.encoding, entry.log_ns, entry.publish_ns, entry.bytes});
    if (!fault_) ++files_written_;
  }
  return fault_;
}

void Tape::wait(Entry entry) {
  if (waiting_bytes_ + entry.bytes.size() > kMostWaitingBytes) {
    files_.erase(entry.name);  // it may come again
    return lose(entry);
  }
  waiting_bytes_ += entry.bytes.size();
  waiting_.push_back(std::move(entry));
}

void Tape::lose(const Entry& entry) {
  ++lost_;
  lost_bytes_ += entry.bytes.size();
}

void Tape::tick(std::int64_t now_ns) {
  fault_ = writer_->tick(now_ns);
  // A clock that was set back must not make anybody wait.
  const bool may_try = now_ns < tried_ns_ || now_ns - tried_ns_ >= kTryAgainNs;
  if (waiting_.empty() || !may_try) return;
  tried_ns_ = now_ns;
  while (!waiting_.empty() && !beside(waiting_.front())) {
    waiting_bytes_ -= waiting_.front().bytes.size();
    waiting_.pop_front();
  }
}

std::optional<disk::Fault> Tape::finish(std::int64_t now_ns, EntryQueue::Losses elsewhere) {
  fault_ = writer_->flush();
  while (!waiting_.empty() && !beside(waiting_.front())) waiting_.pop_front();
  for (const Entry& entry : waiting_) lose(entry);
  waiting_.clear();
  recording::Metadata end;
  end.name = kEnd;
  end.words["ended_ns"] = std::to_string(now_ns);
  end.words["messages"] = std::to_string(writer_->progress().messages);
  end.words["lost"] = std::to_string(lost_ + elsewhere.entries);
  end.words["lost_bytes"] = std::to_string(lost_bytes_ + elsewhere.bytes);
  writer_->note(end);  // where that fails closing does, too
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
