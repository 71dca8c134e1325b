#include "app/bag_reading.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <CLI/CLI.hpp>
#include <QEventLoop>
#include <QRegularExpression>
#include <QTimer>

#include "app/command_text.h"
#include "excerpt/time_typed.h"
#include "incident/report.h"
#include "map/failure.h"
#include "sentences/failure_sentence.h"
#include "sentences/subject_name.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

constexpr int kBagTries = 3;
constexpr int kBagLookEveryMs = 50;
constexpr double kAgainAfterS = 0.5;

using words::text;

}  // namespace

tl::unexpected<CommandFailure> BagReading::failure(const map::Failure& failed) const {
  const int code = robot_->exitCodeHere(failed);
  if (failed.subject.kind != map::SubjectKind::Bag || failed.subject.id.empty())
    return robot_->failure(code, QString::fromStdString(sentences::sentenceOf(failed)));
  return robot_->failure(code, words::about(sentences::nameOf(failed.subject),
                                            QString::fromStdString(sentences::sentenceOf(failed))));
}

void addTime(CLI::App& command, const std::string& name, std::string& word, Needed needed) {
  command
      .add_option(
          name, word,
          help(Text::tr("A time of the recording: 2024-06-03T09:00:00Z or seconds since 1970; 09:00:00 "
                        "(UTC) of its day; +90 or +1:30 after its start; -10 before its end")))
      ->type_name("TIME")
      ->required(needed == Needed::Yes)
      ->check([](const std::string& typed) {
        return isTime(typed) ? std::string()
                             : help(Text::tr("%1 is not a time: give 2024-06-03T09:00:00Z, 09:00:00, "
                                             "+1:30, -10 or seconds since 1970")
                                        .arg(text(typed)));
      });
}

bool isTime(const std::string& word) {
  constexpr double kSpanS = 4e9;  // any clock time is in there
  return excerpt::absoluteTimeTyped(text(word), 0) || excerpt::timeTyped(text(word), 0, kSpanS);
}

CommandResult<double> timeFrom(const std::string& word, const QString& option, const robot::BagInfo& bag) {
  if (const auto at_s = excerpt::absoluteTimeTyped(text(word), bag.start_s)) return *at_s;
  if (bag.messages.value_or(0) == 0 && bag.end_s <= 0) return wrong(Text::tr("It contains no messages."));
  if (const auto at_s = excerpt::timeTyped(text(word), bag.start_s, bag.end_s)) return *at_s;
  return wrong(Text::tr("%1 %2 is not within the recording: it lasts from %3 to %4 UTC.")
                   .arg(option, text(word), incident::utcText(bag.start_s), incident::utcText(bag.end_s)));
}

CommandResult<excerpt::TimeSpan> timeSpanFrom(const BagsArguments& args, const robot::BagInfo& bag) {
  excerpt::TimeSpan span;
  for (const auto& [word, option, value] :
       {std::tuple(&args.from, "--from", &span.from_s), std::tuple(&args.to, "--to", &span.to_s)}) {
    if (word->empty()) continue;
    const auto time = timeFrom(*word, QString::fromLatin1(option), bag);
    if (!time) return passOn(time);
    *value = *time;
  }
  if (span.from_s && span.to_s && *span.to_s < *span.from_s)
    return wrong(Text::tr("--to is earlier than --from."));
  return span;
}

CommandResult<double> timeIn(const RobotArguments& args, const QString& address, const std::string& bag,
                             const std::string& word, const QString& option) {
  constexpr double kAnyYearS = 1e9;
  if (const auto at_s = excerpt::absoluteTimeTyped(text(word), kAnyYearS)) return *at_s;
  RobotCommand look(args);
  auto bags = BagReading::open(look, address);
  if (!bags) return passOn(bags);
  const auto info = bags->robot().ask<robot::BagInfo>([&](robot::OutcomeTo<robot::BagInfo> reply) {
    return bags->library().info(bags->keyOf(bag), std::move(reply));
  });
  if (!info) return bags->failure(info.error());
  return timeFrom(word, option, *info);
}

CommandResult<BagReading> BagReading::open(RobotCommand& command, const QString& address) {
  auto opened = command.open(RobotReading::Purpose::Bags, address);
  if (!opened) return passOn(opened);
  BagReading reading;
  reading.robot_ = *opened;
  reading.library_ = reading.robot_->session().robot().bagLibrary();
  if (!reading.library_) return reading.robot_->lacks(robot::Capability::Bags);
  return reading;
}

robot::BagKey BagReading::keyOf(const std::string& name) const {
  const auto rows = robot_->ask<std::vector<robot::BagEntry>>(
      [&](robot::OutcomeTo<std::vector<robot::BagEntry>> reply) { return library_->list(std::move(reply)); });
  std::optional<robot::BagKey> recording;
  if (rows) {
    for (const robot::BagEntry& row : *rows) {
      if (row.key.name != name) continue;
      if (row.key.kind != robot::BagKind::Recording) return row.key;
      recording = row.key;
    }
  }
  return recording.value_or(robot::BagKey{robot::BagKind::Bag, name});
}

CommandResult<replay::Reading*> BagReading::replay(const std::string& name) { return open(name, {}); }

CommandResult<replay::Reading*> BagReading::readThrough(const std::string& name, Texts texts) {
  replay::Reading::Options options;
  options.chunks.look_back = false;
  options.whole_texts = texts == Texts::Whole;
  return open(name, std::move(options));
}

CommandResult<replay::Reading*> BagReading::open(const std::string& name, replay::Reading::Options options) {
  reading_ = std::make_unique<replay::Reading>(*library_, keyOf(name), std::move(options));
  QObject::connect(reading_.get(), &replay::Reading::chunkRead, reading_.get(),
                   [odd = unreadable_](const replay::ChunkPtr& chunk) {
                     const robot::BagChunk& source = *chunk->source;
                     (*odd)[chunk->from_s] = std::int64_t(source.without_stamp + source.unreadable);
                   });
  std::optional<map::Failure> failed;
  bool opened = false;
  QObject context;
  QObject::connect(reading_.get(), &replay::Reading::opened, &context, [&] { opened = true; });
  QObject::connect(reading_.get(), &replay::Reading::failed, &context,
                   [&](const map::Failure& failure) { failed = failure; });
  for (int tries = 1;; ++tries) {
    failed.reset();
    reading_->open();
    if (!robot_->waitUntil([&] { return opened || failed; }))
      failed = robot_->tooLate({.subject = subjectOf(reading_->key())});
    if (!failed || !map::mayPass(*failed) || tries >= kBagTries) break;
    (void)robot_->waitUntil([] { return false; }, kAgainAfterS);
  }
  if (failed) return failure(*failed);
  return reading_.get();
}

CommandResult<void> BagReading::waitUntil(const std::function<bool()>& done) {
  QEventLoop loop;
  QTimer look;
  std::optional<map::Failure> failed;
  bool is_done = done();
  // Gaps are rare: checking for them and for the time now and then is enough.
  QObject::connect(&look, &QTimer::timeout, &loop, [&] {
    // Anything later is only read-ahead.
    const replay::Cell* const obstacle =
        reading_->chunks().obstacleUntil(reading_->chunks().wanted().value_or(-1e300));
    if (obstacle && !obstacle->lost && replay::isFinal(*obstacle)) failed = obstacle->failure;
    if (!failed && robot_->time().over()) failed = robot_->tooLate({.subject = subjectOf(reading_->key())});
    if (failed) loop.quit();
  });
  QObject::connect(reading_.get(), &replay::Reading::changed, &loop, [&] {
    is_done = is_done || done();
    if (is_done) loop.quit();
  });
  look.start(kBagLookEveryMs);
  if (!is_done) loop.exec();
  if (!is_done && failed) return failure(*failed);
  return {};
}

CommandResult<void> BagReading::readRanges(std::optional<double> from_s, std::optional<double> to_s,
                                           const UseRange& use) {
  replay::RangeWalk walk(*reading_, from_s, to_s);
  while (!walk.over()) {
    replay::ChunkPtr chunk;
    const auto next = [&] { return chunk || (chunk = walk.next()) || walk.over(); };
    if (auto came = waitUntil(next); !came) return came;
    if (!chunk) break;
    if (auto taken = use(*chunk); !taken) return taken;
  }
  const auto holes = reading_->chunks().holes(from_s.value_or(-HUGE_VAL), to_s.value_or(HUGE_VAL));
  if (!holes.empty() && reading_->chunks().messagesRead() == 0) return failure(holes.front().failure);
  return {};
}

CommandResult<void> BagReading::anyRead(double until_s) const {
  const replay::Cell* const obstacle = reading_->chunks().obstacleUntil(until_s);
  if (obstacle && obstacle->lost) return failure(obstacle->failure);
  return {};
}

CommandResult<void> BagReading::readWhole() {
  // From the end back to the start, including parts beyond the stated times.
  reading_->want(1e300);
  if (auto read = waitUntil([&] { return reading_->chunks().wholeSettled(); }); !read) return read;
  return anyRead(HUGE_VAL);
}

CommandResult<replay::Moment> BagReading::momentAt(double at_s) {
  reading_->want(at_s);
  replay::Moment moment;
  // Computing the world gets more expensive the more is known: wait until all of it is.
  const auto known = waitUntil([&] {
    if (!reading_->chunks().settledUntil(at_s)) return false;
    moment = reading_->moment();
    return moment.knowledge == replay::Knowledge::Exact;
  });
  if (!known) return passOn(known);
  if (const auto any = anyRead(at_s); !any) return passOn(any);
  return moment;
}

void BagReading::reportNotFound(const std::vector<std::string>& topics, const excerpt::TimeSpan& span,
                                std::size_t messages, const std::set<std::string>& found) {
  for (const QString& sentence : notFound(topics, span, messages, found)) robot_->lack(sentence);
}

QStringList notFound(const std::vector<std::string>& topics, const excerpt::TimeSpan& span,
                     std::size_t messages, const std::set<std::string>& found) {
  if (topics.empty() && messages == 0 && span.limited()) return {Text::tr("No message was found.")};
  QStringList sentences;
  for (const std::string& topic : topics) {
    if (!found.contains(topic))
      sentences << Text::tr("No message of %1 was found.").arg(words::plainName(topic));
  }
  return sentences;
}

void BagReading::reportUnreadable(double until_s, std::optional<double> from_s) {
  if (const auto holes = reading_->chunks().holes(from_s.value_or(-HUGE_VAL), until_s); !holes.empty())
    robot_->lack(sentences::sentenceOf(replay::faultOf(holes)));
  std::int64_t odd = 0;
  for (const auto& [range_s, count] : *unreadable_) odd += range_s <= until_s ? count : 0;
  if (odd > 0)
    robot_->lack(
        Text::tr("Messages left out because they have no time stamp or cannot be read: %1.").arg(odd));
  robot_->insistOnReadable();
}

QString numbered(const QString& pattern, int number) {
  static const QRegularExpression number_pattern(QStringLiteral("%(?:0(\\d{1,2}))?d"));
  const QRegularExpressionMatch match = number_pattern.match(pattern);
  if (!match.hasMatch() || pattern.indexOf(number_pattern, match.capturedEnd()) >= 0) return {};
  const QString digits = QStringLiteral("%1").arg(number, match.captured(1).toInt(), 10, QLatin1Char('0'));
  return pattern.left(match.capturedStart()) + digits + pattern.mid(match.capturedEnd());
}

}  // namespace mapwright::app
