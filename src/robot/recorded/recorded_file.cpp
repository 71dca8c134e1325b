#include "robot/recorded/recorded_file.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <QThread>

#include "recorder/layout.h"
#include "robot/axbot/faults.h"
#include "robot/axbot/parse_topics.h"
#include "robot/recorded/recorded_robot.h"
#include "robot/recorded/recording_reasons.h"
#include "robot/wire/failures.h"

namespace mapwright::robot::recorded {
namespace {

constexpr map::Stream kLastStream = map::Stream::GlobalPositioning;

/// Nothing more can be read once the thread is asked to stop: any operation ends.
recording::Opened opened(const RecordedOptions& options) {
  return recording::openRecording(options.path.toStdString(), options.limits,
                                  [] { return QThread::currentThread()->isInterruptionRequested(); });
}

std::string listOf(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

QString text(const recording::Values& values, const char* name) {
  const auto found = values.find(name);
  return found == values.end() ? QString() : QString::fromStdString(found->second);
}

}  // namespace

/// A range in progress.
struct RecordedFile::Job {
  RangeJob range;
  wire::TaskPtr task;
  OutcomeTo<BagChunkPtr> reply;
  int number = 0;
  bool stopped = false;
};

RecordedFile::Parts::Parts(std::unique_ptr<recording::Source> source, const ros::Choices& choices,
                           const std::string& ns)
    : file(std::move(source)),
      shape(shapeOf(*file, fields, choices, ns)),
      lasting(*file, fields, placingTopics(*file, shape), shape),
      folds(*file, fields),
      kept(*file),
      robots(robotNames(*file, fields, shape)) {
  kept.look();
}

RecordedFile::RecordedFile(RecordedOptions options) : options_(std::move(options)) {}
RecordedFile::~RecordedFile() = default;

BagKey RecordedFile::ownKey() const { return {BagKind::File, bagNameOf(options_.path)}; }

bool RecordedFile::ready() {
  if (parts_) return true;
  auto source = recorded::opened(options_);
  if (!source) {
    trouble_ = reasonOf(source.error());
    return false;
  }
  parts_ = std::make_unique<Parts>(std::move(*source), choices_, options_.ns);
  trouble_ = noRobotReason();
  if (trouble_) {
    parts_.reset();
    return false;
  }
  reportNotes();
  Q_EMIT opened(facts());
  return true;
}

void RecordedFile::choose(const ros::Choices& choices) {
  if (std::exchange(choices_, choices) == choices || !parts_) return;
  parts_->shape = shapeOf(*parts_->file, parts_->fields, choices_, options_.ns);
  parts_->lasting.reset(placingTopics(*parts_->file, parts_->shape), parts_->shape);
  Q_EMIT opened(facts());
}

void RecordedFile::open() {
  if (parts_) {
    Q_EMIT opened(facts());
  } else if (!ready()) {
    Q_EMIT refused(*trouble_);
  }
}

std::optional<map::Failure> RecordedFile::unavailableReason(const map::Subject& subject) {
  if (ready()) return std::nullopt;
  return wire::unfit(subject, *trouble_);
}

void RecordedFile::reportOnce(const map::Problem& problem) {
  const std::string row =
      std::to_string(int(problem.subject.kind)) + problem.subject.id + '\n' + map::patternOf(problem);
  if (told_.insert(row).second) Q_EMIT problemFound(problem);
}

std::optional<Fault> RecordedFile::noRobotReason() const {
  const auto& robots = parts_->robots;
  const auto& channels = parts_->file->channels();
  if (options_.ns.empty() || std::find(robots.begin(), robots.end(), options_.ns) != robots.end() ||
      std::any_of(channels.begin(), channels.end(), [this](const recording::ChannelPtr& channel) {
        return ros::isBelow(channel->topic, options_.ns);
      }))
    return std::nullopt;
  if (robots.empty())
    return Fault(faultText("recorded", "It contains no topic in the namespace %1."), {options_.ns});
  return Fault(faultText("recorded", "It contains no robot %1, only %2."), {options_.ns, listOf(robots)});
}

void RecordedFile::reportNotes() {
  reportInterruption();
  if (!parts_->robots.empty() && options_.ns.empty()) {
    const std::string shown = parts_->shape.robots.size() < 2        ? parts_->robots.front()
                              : parts_->shape.robots.front().empty() ? "/"
                                                                     : parts_->shape.robots.front();
    reportOnce(
        {map::Severity::Info,
         subjectOf(ownKey()),
         {faultText("recorded",
                    "It contains several robots: %1. Shown as the robot is %2. To see another one, add "
                    "?ns=/NAMESPACE to the address of the file."),
          {listOf(parts_->robots), shown}},
         map::ProblemCode::Odd});
  }
  for (const recording::Note& note : parts_->file->summary().notes) {
    if (!reasonOf(note).any()) continue;
    const auto severity = isLoss(note.code) ? map::Severity::Warning : map::Severity::Info;
    const auto code = isLoss(note.code) ? map::ProblemCode::Unreadable : map::ProblemCode::Odd;
    reportOnce({severity, subjectOf(ownKey()), reasonOf(note), code});
  }
  for (const BagAway& away : awayIn(*parts_->file))
    reportOnce({map::Severity::Info, subjectOf(ownKey()), reasonOf(away), map::ProblemCode::Odd});
}

void RecordedFile::reportInterruption() {
  const bool interrupted = isInterrupted(*parts_->file);
  if (std::exchange(told_interrupted_, interrupted) == interrupted) return;
  const map::Subject bag = subjectOf(ownKey());
  if (!interrupted) {
    Q_EMIT recovered({bag, map::ProblemCode::Unavailable});
    return;
  }
  Q_EMIT problemFound(
      {map::Severity::Warning, bag, interruptionOf(parts_->file->summary()), map::ProblemCode::Unavailable});
}

std::size_t RecordedFile::newlyUntimed() {
  std::size_t found = 0;
  for (const recording::Note& note : parts_->file->summary().notes) {
    if (note.code == recording::NoteCode::TimeUnusable) found += std::size_t(note.count);
  }
  return found - std::min(std::exchange(told_untimed_, found), found);
}

bool RecordedFile::refresh() {
  const auto channels = parts_->file->channels().size();
  const auto end_ns = parts_->file->summary().end_ns;
  if (!parts_->file->refresh()) return false;
  info_is_old_ = true;
  parts_->lasting.forgetFrom(end_ns.value_or(0));
  parts_->kept.look();
  // Placed messages stay as they are: another frame would be another map.
  if (parts_->file->channels().size() == channels && parts_->shape.fixed_by_file) return true;
  RosShape shape = shapeOf(*parts_->file, parts_->fields, choices_, options_.ns);
  if (parts_->shape.fixed_by_file) {
    shape.fixed_frame = parts_->shape.fixed_frame;
    shape.own_frame = parts_->shape.own_frame;
  }
  shape.fixed_by_file |= parts_->shape.fixed_by_file;
  parts_->shape = std::move(shape);
  parts_->robots = robotNames(*parts_->file, parts_->fields, parts_->shape);
  parts_->lasting.reset(placingTopics(*parts_->file, parts_->shape), parts_->shape);
  Q_EMIT opened(facts());
  return true;
}

RecordingFacts RecordedFile::facts() const {
  RecordingFacts facts;
  for (const recording::Metadata& metadata : parts_->file->metadata()) {
    if (metadata.name != recorder::kAbout) continue;  // the last one counts
    facts.identity.model = text(metadata.values, "model");
    facts.identity.serial = text(metadata.values, "serial");
    facts.identity.name = text(metadata.values, "name");
    facts.identity.version = text(metadata.values, "firmware");
  }
  std::set<QString> topics;
  bool frames = false;
  for (const recording::ChannelPtr& channel : parts_->file->channels()) {
    if (parts_->shape.isRos(*channel)) continue;
    topics.insert(QString::fromStdString(channel->topic));
    frames = true;
  }
  // There may be many thousands.
  std::set<std::pair<map::Stream, std::string>> brought;
  std::set<std::string> understood;
  for (const ros::Source& source : parts_->shape.sources) {
    const QString topic = QString::fromStdString(source.topic);
    if (brought.emplace(source.stream, source.topic).second) facts.streams[source.stream] << topic;
    if (understood.insert(source.topic).second) facts.topics << topic;
  }
  std::set<std::pair<std::string, std::string>> offered;
  for (const recording::ChannelPtr& channel : parts_->file->channels()) {
    if (offered.emplace(channel->topic, channel->schema_name).second)
      facts.offered.push_back(
          {QString::fromStdString(channel->topic), QString::fromStdString(channel->schema_name)});
  }
  for (int stream = 0; stream <= int(kLastStream); ++stream) {
    for (const std::string& name : ros::choicesFor(map::Stream(stream), parts_->shape.found))
      facts.choices[map::Stream(stream)] << QString::fromStdString(name);
  }
  if (frames) {
    for (const QString& known : axbot::knownTopics()) {
      if (topics.contains(known)) facts.topics << known;
    }
    for (int stream = 0; stream <= int(kLastStream); ++stream) {
      const axbot::StreamTopics of = axbot::topicsOf(map::Stream(stream));
      for (const QString& topic : of.usual + of.older) {
        if (topics.contains(topic)) facts.streams[map::Stream(stream)] << topic;
      }
    }
  }
  return facts;
}

Outcome<std::vector<BagEntry>> RecordedFile::bags() {
  if (auto failure = unavailableReason({map::SubjectKind::Bag, ownKey().name}))
    return fail(std::move(*failure));
  refresh();
  const recording::Summary summary = parts_->file->summary();
  BagEntry entry;
  entry.key = ownKey();
  entry.size_bytes = std::int64_t(summary.bytes);
  if (summary.end_ns) entry.end_s = recording::secondsOf(*summary.end_ns);
  return std::vector<BagEntry>{entry};
}

Outcome<BagInfo> RecordedFile::info(const BagKey& key) {
  if (auto failure = unavailableReason(subjectOf(key))) return fail(std::move(*failure));
  if (key.name != ownKey().name) {
    return fail(wire::notThere(subjectOf(key)));
  }
  // A followed file is checked frequently: this only reads its length. A request for messages may already
  // have noticed its growth.
  refresh();
  if (!info_is_old_ && told_info_) return *told_info_;
  const recording::Summary summary = parts_->file->summary();
  BagInfo info;
  info.messages = std::int64_t(summary.messages);
  if (!summary.counted && summary.start_ns) {
    // The file does not say: counts them, each only once.
    recording::Query query;
    info.messages = 0;
    if (told_info_ && counted_until_ns_) {
      query.first_ns = *counted_until_ns_ + 1;
      info.messages = told_info_->messages;
    }
    const auto cursor = parts_->file->messages(query);
    while (const auto message = cursor->next()) {
      ++*info.messages;
      ++counted_of_[message->channel->id];
    }
    counted_until_ns_ = summary.end_ns;
  }
  if (summary.start_ns) info.start_s = recording::secondsOf(*summary.start_ns);
  info.end_s = summary.end_ns ? recording::secondsOf(*summary.end_ns) : info.start_s;
  info.interrupted = isInterrupted(*parts_->file);
  info.repair = repairOf(*parts_->file);
  info.away = awayIn(*parts_->file);
  notifyContent(info, summary);
  reportNotes();
  told_info_ = info;
  info_is_old_ = false;
  return info;
}

std::map<RecordedFile::Form, double> RecordedFile::rates(
    const std::map<std::uint32_t, std::uint64_t>& counts) {
  std::set<std::uint32_t> own, is_new;
  const std::vector<recording::ChannelPtr> channels = parts_->file->channels();
  for (const recording::ChannelPtr& channel : channels) {
    if (channel->metadata.contains(recorder::kSaid)) continue;
    own.insert(channel->id);
    // A followed file is checked frequently: the first message stays the first.
    if (!first_of_.contains(channel->id)) is_new.insert(channel->id);
  }
  first_of_.merge(parts_->file->outermostTimes(is_new, false));
  const std::map<std::uint32_t, std::int64_t> last_of = parts_->file->outermostTimes(own, true);
  struct Span {
    std::uint64_t messages = 0;
    std::int64_t first_ns = 0, last_ns = 0;
  };
  std::map<Form, Span> spans;
  for (const recording::ChannelPtr& channel : channels) {
    const auto count = counts.find(channel->id);
    const auto first = first_of_.find(channel->id);
    const auto last = last_of.find(channel->id);
    if (count == counts.end() || first == first_of_.end() || last == last_of.end()) continue;
    const auto at = spans
                        .try_emplace(Form(channel->topic, channel->schema_name, channel->message_encoding),
                                     Span{0, first->second, last->second})
                        .first;
    Span& span = at->second;
    span.messages += count->second;
    span.first_ns = std::min(span.first_ns, first->second);
    span.last_ns = std::max(span.last_ns, last->second);
  }
  std::map<Form, double> rates;
  for (const auto& [form, span] : spans) {
    if (span.messages < 2 || span.last_ns <= span.first_ns) continue;
    rates[form] = double(span.messages - 1) / recording::secondsOf(span.last_ns - span.first_ns);
  }
  return rates;
}

void RecordedFile::notifyContent(BagInfo& info, const recording::Summary& summary) {
  const auto& counts = summary.counted ? summary.messages_of : counted_of_;
  std::map<Form, std::int64_t> topics;
  for (const recording::ChannelPtr& channel : parts_->file->channels()) {
    const auto count = counts.find(channel->id);
    topics[{channel->topic, channel->schema_name, channel->message_encoding}] +=
        count == counts.end() ? 0 : std::int64_t(count->second);
  }
  const std::map<Form, double> rate_of = rates(counts);
  for (const auto& [topic, messages] : topics) {
    const auto& [name, type, encoding] = topic;
    const auto rate = rate_of.find(topic);
    info.topics.push_back(
        {name, type, encoding, messages, rate == rate_of.end() ? std::nullopt : std::optional(rate->second)});
  }
  info.robots = parts_->robots;
  info.format = parts_->file->format();
  info.written_by = summary.library;
  info.attachments = std::int64_t(parts_->file->attachments().size());
  // For a growing file the first result stays: it needs every chunk.
  if (told_info_) {
    info.packing = told_info_->packing;
    return;
  }
  for (const recording::Packing& one : parts_->file->packing())
    info.packing.push_back({one.compression, std::int64_t(one.chunks), std::int64_t(one.packed_bytes),
                            std::int64_t(one.unpacked_bytes)});
}

void RecordedFile::messages(const wire::TaskPtr& task, const BagKey& key, const BagRange& range,
                            OutcomeTo<BagChunkPtr> reply) {
  if (!std::isfinite(range.from_s) || !std::isfinite(range.until_s) || range.until_s < range.from_s) {
    const std::string span = std::to_string(range.from_s) + " - " + std::to_string(range.until_s);
    reply(tl::make_unexpected(map::Failure{.kind = map::FailureKind::Unsupported,
                                           .subject = subjectOf(key),
                                           .reason = map::FailureReason::Unfit,
                                           .cause = {robot::axbot::fault::BagNotAsked, {span}}}));
    return;
  }
  if (auto failure = unavailableReason(subjectOf(key))) {
    reply(tl::make_unexpected(std::move(*failure)));
    return;
  }
  const auto end_ns = parts_->file->summary().end_ns;
  if (!end_ns || recording::nanosecondsOf(range.until_s) > *end_ns) refresh();
  const auto job = std::make_shared<Job>(Job{RangeJob(key, range), task, std::move(reply)});
  job->number = task->begun([held = std::weak_ptr(job)] {
    if (const auto now = held.lock()) now->stopped = true;
  });
  proceed(job);
}

void RecordedFile::proceed(const std::shared_ptr<Job>& job) {
  const auto end = [&](Outcome<BagChunkPtr> outcome) {
    job->task->ended(job->number);
    job->reply(std::move(outcome));
  };
  if (job->stopped || QThread::currentThread()->isInterruptionRequested()) {
    return end(fail({.kind = map::FailureKind::Cancelled, .subject = subjectOf(job->range.key())}));
  }
  const RangeJob::Step step = job->range.step(
      {{*parts_->file, parts_->fields, parts_->shape, parts_->lasting, parts_->folds}, parts_->kept});
  for (const map::Problem& problem : job->range.releaseProblems()) reportOnce(problem);
  switch (step) {
    case RangeJob::Step::More:
      QMetaObject::invokeMethod(
          this, [this, job] { proceed(job); }, Qt::QueuedConnection);
      return;
    case RangeJob::Step::TooLong:
      return end(
          tl::make_unexpected(map::Failure{.kind = map::FailureKind::MalformedAnswer,
                                           .subject = subjectOf(job->range.key()),
                                           .cause = {fault::AnswerTooLong, {job->range.range().max_bytes}}}));
    case RangeJob::Step::Done:
      reportNotes();
      return end(job->range.chunk(newlyUntimed()));
  }
}

Outcome<std::shared_ptr<const std::string>> RecordedFile::picture(const std::string& topic,
                                                                  const std::string& name) {
  if (auto failure = unavailableReason({map::SubjectKind::Topic, topic})) return fail(std::move(*failure));
  return parts_->kept.picture(topic, name);
}

map::SubmapAnswer RecordedFile::submap(const map::SubmapKey& key) {
  if (ready()) return parts_->kept.submap(key);
  map::SubmapAnswer answer;
  answer.key = key;
  answer.reason = *trouble_;
  answer.failure = map::FailureKind::MalformedAnswer;
  return answer;
}

Outcome<map::WholeMap> RecordedFile::fetch(const map::MapKey& key) {
  if (auto failure = unavailableReason(map::subjectOf(key))) return fail(std::move(*failure));
  return parts_->kept.wholeMap(key);
}

Outcome<map::WaypointList> RecordedFile::waypoints(const map::MapKey& key) {
  if (auto failure = unavailableReason(map::placesOf(key))) return fail(std::move(*failure));
  return parts_->kept.waypoints(key);
}

Outcome<std::vector<map::CatalogueEntry>> RecordedFile::list() {
  if (auto failure = unavailableReason({map::SubjectKind::Catalogue, map::kMapsPart}))
    return fail(std::move(*failure));
  return parts_->kept.maps();
}

Outcome<map::CatalogueEntry> RecordedFile::describe(const map::MapKey& key) {
  return wire::entryOf(key, list());
}

}  // namespace mapwright::robot::recorded

#include "moc_recorded_file.cpp"
