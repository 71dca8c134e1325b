#include "excerpt/recording_merge.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <QByteArray>
#include <QCryptographicHash>

#include "excerpt/whole_target.h"
#include "recorder/layout.h"
#include "robot/recorded/earlier_messages.h"
#include "robot/recorded/faults.h"

namespace mapwright::excerpt {
namespace {

using SourcePtr = std::unique_ptr<recording::Source>;

std::string digestOf(const void* bytes, std::size_t size) {
  const auto* const chars = static_cast<const char*>(bytes);
  return QCryptographicHash::hash(QByteArray::fromRawData(chars, qsizetype(size)), QCryptographicHash::Sha256)
      .toStdString();
}

/// For things in several files, each as often as in the file that has it most often. Files are added one
/// after the other.
template <typename Thing>
class Once {
 public:
  /// Whether it is one more than in earlier files.
  bool isNew(std::size_t source, const Thing& thing) {
    std::map<std::size_t, int>& counts = counts_[thing];
    const int now = ++counts[source];
    return std::none_of(counts.begin(), counts.end(),
                        [&](const auto& of) { return of.first != source && of.second >= now; });
  }

 private:
  std::map<Thing, std::map<std::size_t, int>> counts_;
};

/// Channels as numbers: equal ones in two files share a number, and so do those of the initial state.
class ChannelNumbers {
 public:
  int of(const recording::ChannelPtr& channel) {
    const auto [known, is_new] = numbers_.try_emplace(channel, 0);
    if (!is_new) return known->second;
    recording::Channel plain = *channel;
    plain.metadata.erase(recorder::kSaid);
    plain.metadata.erase(recorder::kSaidAt);
    const auto next = int(plain_.size());
    return known->second = plain_
                               .try_emplace({plain.topic, plain.message_encoding, plain.schema_name,
                                             plain.schema_encoding, plain.schema_data, plain.metadata},
                                            next)
                               .first->second;
  }

 private:
  std::map<recording::ChannelPtr, int> numbers_;
  std::map<std::tuple<std::string, std::string, std::string, std::string, std::string, recording::Values>,
           int>
      plain_;
};

bool wasSaidBefore(const recording::Channel& channel) {
  const auto said = channel.metadata.find(recorder::kSaid);
  return said != channel.metadata.end() && said->second == recorder::kBefore;
}

/// The initial state of a part is dropped if another part contains these messages or has already given them.
class SaidBefore {
 public:
  explicit SaidBefore(ChannelNumbers& numbers) : numbers_(numbers) {}

  /// Call it for all of them before the first message.
  void expectThoseOf(recording::Source& source, const std::vector<std::string>& topics) {
    const recording::Summary summary = source.summary();
    recording::Query query;
    std::uint64_t count = 0;
    for (const recording::ChannelPtr& channel : source.channels()) {
      if (!wasSaidBefore(*channel) || !isOneOf(topics, channel->topic)) continue;
      query.topics.push_back(channel->topic);
      const auto of = summary.messages_of.find(channel->id);
      if (of != summary.messages_of.end()) count += of->second;
    }
    if (query.topics.empty() || !summary.start_ns) return;
    // They are at the start, except in merged recordings.
    query.last_ns = *summary.start_ns;
    if (expect(source, query) == count && summary.counted) return;
    query.last_ns = recording::Query().last_ns;
    expect(source, query);
  }

  /// In order of time. False: it is known already.
  bool isNew(std::size_t source, const recording::Message& message) {
    const int channel = numbers_.of(message.channel);
    bool known = false;
    for (const Time& time : timesOf(message)) {
      if (!times_.contains({channel, time})) continue;
      const auto told = by_.find(keyOf(channel, time, message));
      if (told == by_.end()) continue;
      known |= wasSaidBefore(*message.channel) && told->second && *told->second != source;
      if (!told->second) told->second = source;
    }
    return !known;
  }

 private:
  /// When it was said (true), or its publish time: parts know it by the one, other recordings by the other.
  using Time = std::pair<bool, std::int64_t>;
  using Key = std::tuple<int, Time, std::string>;
  static Key keyOf(int channel, const Time& time, const recording::Message& message) {
    return {channel, time, digestOf(message.bytes.data(), message.bytes.size())};
  }
  static std::vector<Time> timesOf(const recording::Message& message) {
    std::vector<Time> times{{true, robot::recorded::saidNs(message)}};
    if (!message.channel->metadata.contains(recorder::kSaidAt))
      times.emplace_back(false, message.publish_time_ns);
    return times;
  }
  std::uint64_t expect(recording::Source& source, const recording::Query& query) {
    std::uint64_t found = 0;
    const auto cursor = source.messages(query);
    while (const auto message = cursor->next()) {
      if (!wasSaidBefore(*message->channel)) continue;
      ++found;
      const int channel = numbers_.of(message->channel);
      const Time time = message->channel->metadata.contains(recorder::kSaidAt)
                            ? Time(true, robot::recorded::saidNs(*message))
                            : Time(false, message->publish_time_ns);
      times_.emplace(channel, time);
      by_.try_emplace(keyOf(channel, time, *message));
    }
    return found;
  }

  ChannelNumbers& numbers_;
  std::set<std::pair<int, Time>> times_;          // of those below
  std::map<Key, std::optional<std::size_t>> by_;  // the first file with it
};

class Merge {
 public:
  Merge(const std::vector<SourcePtr>& sources, WholeMcap& file)
      : sources_(sources), file_(file), before_(numbers_) {}

  std::optional<disk::FileError> describe() {
    // The result is only complete if all inputs are.
    const bool whole = std::none_of(sources_.begin(), sources_.end(), [](const SourcePtr& one) {
      return robot::recorded::isInterrupted(*one);
    });
    Once<std::pair<std::string, recording::Values>> once;
    for (std::size_t of = 0; of < sources_.size(); ++of) {
      for (const recording::Metadata& metadata : sources_[of]->metadata()) {
        if (!whole && robot::recorded::isEndMark(metadata)) continue;
        if (!once.isNew(of, {metadata.name, metadata.values})) continue;
        if (auto fault = file_.writer().addMetadata(metadata)) return fault;
      }
    }
    return std::nullopt;
  }

  std::optional<disk::FileError> copy(const recording::Query& query) {
    for (const SourcePtr& source : sources_) before_.expectThoseOf(*source, query.topics);
    std::vector<Head> heads;
    for (const SourcePtr& source : sources_) {
      heads.push_back({source->messages(query), std::nullopt});
      heads.back().message = heads.back().cursor->next();
    }
    while (true) {
      const auto next = std::min_element(heads.begin(), heads.end(), [](const Head& a, const Head& b) {
        return a.message && (!b.message || a.message->log_time_ns < b.message->log_time_ns);
      });
      if (next == heads.end() || !next->message) return std::nullopt;
      if (auto fault = copyAt(next->message->log_time_ns, heads)) return fault;
    }
  }

  std::optional<disk::FileError> attach() {
    std::vector<std::pair<std::size_t, const recording::AttachmentLocation*>> locations;
    for (std::size_t of = 0; of < sources_.size(); ++of) {
      for (const recording::AttachmentLocation& location : sources_[of]->attachments())
        locations.emplace_back(of, &location);
    }
    std::stable_sort(locations.begin(), locations.end(), [](const auto& a, const auto& b) {
      return a.second->log_time_ns < b.second->log_time_ns;
    });
    Once<std::tuple<std::string, std::string, std::int64_t, std::int64_t, std::string>> once;
    struct Last {
      std::string content;
      std::set<std::size_t> files;  // that hold it
    };
    std::map<std::string, Last> last_of;  // by name
    for (const auto& [of, location] : locations) {
      const auto attachment = sources_[of]->attachment(*location);
      if (!attachment) continue;  // it is damaged, and useless there
      const recording::Attachment& it = *attachment;
      std::string content = digestOf(it.bytes.data(), it.bytes.size());
      const bool is_new =
          once.isNew(of, {it.name, it.media_type, it.log_time_ns, it.create_time_ns, content});
      // A later message of another file that equals the current one adds nothing; repetitions within one file
      // stay.
      Last& last = last_of[it.name];
      const bool stands = last.content == content && !last.files.contains(of);
      if (!is_new || stands) {
        if (last.content == content) last.files.insert(of);
        continue;
      }
      last = {std::move(content), {of}};
      if (auto fault = file_.writer().attach(it)) return fault;
      ++done_.attachments;
    }
    return std::nullopt;
  }

  Written done() const {
    Written done = done_;
    for (const SourcePtr& source : sources_)
      addLosses(done, *source, robot::recorded::isInterrupted(*source));
    return done;
  }

 private:
  /// The next one of a file.
  struct Head {
    std::unique_ptr<recording::Cursor> cursor;
    std::optional<recording::Message> message;
  };

  /// All of one time, file after file. A message in two files is copied once: parts may overlap.
  std::optional<disk::FileError> copyAt(std::int64_t at_ns, std::vector<Head>& heads) {
    const auto isAt = [&](const Head& head) { return head.message && head.message->log_time_ns == at_ns; };
    const bool shared = std::count_if(heads.begin(), heads.end(), isAt) > 1;
    // Parts disagree about values that a file counts itself (the sequence).
    Once<std::tuple<int, bool, std::int64_t, std::string>> once;
    for (std::size_t of = 0; of < heads.size(); ++of) {
      for (Head& head = heads[of]; isAt(head); head.message = head.cursor->next()) {
        const recording::Message& message = *head.message;
        if (!before_.isNew(of, message)) continue;
        if (shared &&
            !once.isNew(of, {numbers_.of(message.channel), wasSaidBefore(*message.channel),
                             message.publish_time_ns, digestOf(message.bytes.data(), message.bytes.size())}))
          continue;
        ++done_.messages;
        done_.topics.insert(message.channel->topic);
        if (auto fault = file_.write(*message.channel, {at_ns, message.publish_time_ns, message.sequence},
                                     message.bytes))
          return fault;
      }
    }
    return std::nullopt;
  }

  const std::vector<SourcePtr>& sources_;
  WholeMcap& file_;
  ChannelNumbers numbers_;
  SaidBefore before_;
  Written done_;
};

}  // namespace

tl::expected<Written, Fault> mergeRecordings(const std::vector<std::string>& paths, const Order& order) {
  std::vector<SourcePtr> sources;
  for (const std::string& path : paths) {
    auto source = recording::openRecording(path);
    if (!source) {
      const Fault why = robot::recorded::reasonOf(source.error());
      if (why.code == robot::recorded::fault::RecordingNotOpened) return tl::make_unexpected(why);
      return tl::make_unexpected(Fault(robot::recorded::fault::RecordingNotOpened, {path}, {why}));
    }
    sources.push_back(std::move(*source));
  }
  std::string profile = sources.empty() ? std::string() : sources.front()->summary().profile;
  for (const SourcePtr& source : sources) {
    if (source->summary().profile != profile) profile.clear();
  }
  auto file = WholeMcap::create(order, std::move(profile));
  if (!file) return tl::make_unexpected(disk::notWritten(file.error()));
  recording::Query query;
  if (order.span.from_s) query.first_ns = firstNanosecondsOf(*order.span.from_s);
  if (order.span.to_s) query.last_ns = lastNanosecondsOf(*order.span.to_s);
  query.topics = order.topics;
  Merge merge(sources, *file);
  std::optional<disk::FileError> fault = merge.describe();
  if (!fault) fault = merge.copy(query);
  if (!fault) fault = merge.attach();
  if (!fault) fault = file->finish();
  if (fault) return tl::make_unexpected(disk::notWritten(*fault));
  return merge.done();
}

}  // namespace mapwright::excerpt
