// `mapwright record`: records what a robot sends to an MCAP file (docs/command-line.md, "mapwright record";
// recorder/layout.h).
#include <cmath>
#include <iterator>
#include <memory>

#include <CLI/CLI.hpp>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

#include "app/command_text.h"
#include "app/commands.h"
#include "app/live_robot.h"
#include "app/output.h"
#include "app/robot_factory.h"
#include "disk/file_error.h"
#include "recorder/recorder.h"
#include "recording/append_file.h"
#include "robot/delivery.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "sentences/subject_name.h"
#include "ui/kit/status_text.h"
#include "words/listed.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

/// As typed; empty = not given.
struct RecordArguments : RobotArguments {
  RecordArguments() { timeout_s = 30; }  // for the connection
  std::string output;
  std::optional<double> duration_s;  // nullopt = until stopped
  std::string topics;                // comma-separated, by the robot's own names, in addition to `streams`
  std::string streams = "all";       // comma-separated kinds of data, "all" or "none"
  std::string submaps = "listed";    // "all", "listed" or "none"
  bool force = false;
};

using recorder::Recorder;
using recorder::SubmapRequests;

using map::Stream;
using words::text;
struct StreamWord {
  Stream stream;
  const char* word;
};
constexpr StreamWord kStreamWords[] = {{Stream::Pose, "pose"},
                                       {Stream::Model, "model"},
                                       {Stream::WholeMap, "map"},
                                       {Stream::Incremental, "incremental-map"},
                                       {Stream::EnvMatch, "env-match"},
                                       {Stream::EnvSymmetry, "env-symmetry"},
                                       {Stream::CostmapLow, "costmap-low"},
                                       {Stream::CostmapHigh, "costmap-high"},
                                       {Stream::MapInfo, "map-info"},
                                       {Stream::Landmarks, "landmarks"},
                                       {Stream::Doors, "doors"},
                                       {Stream::Pallets, "pallets"},
                                       {Stream::Racks, "racks"},
                                       {Stream::SeenObjects, "objects"},
                                       {Stream::Constraints, "constraints"},
                                       {Stream::Trajectory, "trajectory"},
                                       {Stream::Path, "path"},
                                       {Stream::LocalPath, "local-path"},
                                       {Stream::Planning, "planning"},
                                       {Stream::Cloud, "cloud"},
                                       {Stream::NearbyRobots, "robots"},
                                       {Stream::NearbyFootprints, "footprints"},
                                       {Stream::Battery, "battery"},
                                       {Stream::Wheels, "wheels"},
                                       {Stream::Alerts, "alerts"},
                                       {Stream::Sensors, "sensors"},
                                       {Stream::GlobalPositioning, "positioning"}};

/// The kinds of data that a robot sends, as typed.
QStringList streamWords() {
  QStringList words;
  for (const StreamWord& one : kStreamWords) words << QLatin1String(one.word);
  return words;
}

/// Parses "pose,cloud", "all" or "none". The error is the unknown word.
tl::expected<map::Streams, QString> streamsFrom(const QString& typed) {
  map::Streams streams;
  if (typed == QLatin1String("none")) return streams;
  if (typed == QLatin1String("all")) return recorder::everyStream();
  for (const QString& part : typed.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    const auto known =
        std::find_if(std::begin(kStreamWords), std::end(kStreamWords),
                     [&](const StreamWord& one) { return part.trimmed() == QLatin1String(one.word); });
    if (known == std::end(kStreamWords)) return tl::make_unexpected(part.trimmed());
    streams.insert(known->stream);
  }
  return streams;
}

/// The validated options.
struct RecordOrder {
  map::Streams streams;
  QStringList topics;
  SubmapRequests::Which submaps = SubmapRequests::Which::Listed;
  QString path;
};

CommandResult<RecordOrder> orderFrom(const RecordArguments& args) {
  RecordOrder order;
  order.path = text(args.output);
  const auto streams = streamsFrom(text(args.streams));
  if (!streams)
    return wrong(Text::tr("--streams: \"%1\" is unknown. Choose from: all, none, %2.")
                     .arg(streams.error(), words::listed(streamWords())));
  order.streams = *streams;
  for (const QString& topic : text(args.topics).split(QLatin1Char(','), Qt::SkipEmptyParts))
    order.topics << topic.trimmed();
  if (args.submaps == "all") {
    order.submaps = SubmapRequests::Which::All;
  } else if (args.submaps == "none") {
    order.submaps = SubmapRequests::Which::None;
  } else if (args.submaps != "listed") {
    return wrong(Text::tr("--submaps must be all, listed or none, not \"%1\".").arg(text(args.submaps)));
  }
  if (args.duration_s && !(*args.duration_s > 0 && *args.duration_s <= 1e8))
    return wrong(Text::tr("--duration must be greater than 0 seconds and at most 100000000."));
  if (const auto why = noTimeoutReason(args.timeout_s)) return wrong(*why);
  if (isStream(order.path))
    return wrong(Text::tr(
        "A recording must go to a regular file (-o FILE), because its index is written at the end."));
  if (const auto why = notCreatedReason(order.path, args.force)) return wrong(*why);
  return order;
}

/// One recording from the first connection to its end.
class RecordRun {
 public:
  RecordRun(const RecordArguments& args, RecordOrder order, LiveRobot& live)
      : args_(args), order_(std::move(order)), live_(live), robot_(live.robot()) {}

  CommandResult<int> carryOut() {
    if (robot::LiveTopics* const topics = robot_.liveTopics()) {
      topics->setBasics({});
      topics->setWanted(order_.streams, order_.topics);
    }
    if (auto failure = live_.connectToRobot()) return tl::make_unexpected(*failure);
    if (live_.stopped()) return kDone;  // nothing was started
    auto target = recording::appendFile(args_.output, existingBy(args_.force));
    if (!target) return notWritten(target.error());
    Recorder::Options options;
    options.kind = knownAddresses().kindOf(text(args_.robot));
    options.recorded_by = std::string("mapwright ") + MAPWRIGHT_VERSION;
    options.submaps = order_.submaps;
    auto recorder = Recorder::start(robot_, std::move(*target), std::move(options));
    if (!recorder) return notWritten(recorder.error());
    recorder_ = std::move(*recorder);
    follow();
    const std::size_t missing = recorder_->fetches().submapsMissing();
    recorder_->finish();
    return end(missing);
  }

 private:
  /// Runs until it should end.
  void follow() {
    QObject::connect(recorder_.get(), &Recorder::progressed, &context_, [this] { reportProgress(); });
    QObject::connect(recorder_.get(), &Recorder::notHad, &context_, [this](const map::Failure& failure) {
      ++not_had_;
      say(Text::tr("%1: %2").arg(sentences::nameOf(failure.subject), text(sentences::sentenceOf(failure))));
    });
    QObject::connect(&robot_, &robot::Robot::connectionChanged, &context_, [this] {
      const robot::ConnectionState link = robot_.connection();
      if (link.phase == robot::ConnectionPhase::Interrupted && !away_) {
        away_ = true;
        ++interruptions_;
        progress_.clear();
        say(Text::tr("The connection was lost after %1 s. %2")
                .arg(QString::number(recorder_->progress().seconds, 'f', 1),
                     sentences::wordsOf(link.reason)));
      } else if (link.phase == robot::ConnectionPhase::Online && away_) {
        away_ = false;
        progress_.clear();
        say(Text::tr("Reconnected after %1 s.").arg(QString::number(recorder_->progress().seconds, 'f', 1)));
      }
      if (link.phase != robot::ConnectionPhase::Refused) return;
      refused_ = notConnectedReason(robot_.connection());
      live_.quit();
    });
    live_.follow(args_.duration_s);
  }

  void reportProgress() {
    const Recorder::Progress now = recorder_->progress();
    if (now.written.fault && now.written.fault != told_) {
      progress_.clear();
      say(sentences::wordsOf(disk::notWritten(withPath(*now.written.fault))));
    } else if (!now.written.fault && told_) {
      progress_.clear();
      say(Text::tr("Recording to %1 continues.").arg(order_.path));
    }
    told_ = now.written.fault;
    QString line = Text::tr("%1 s, %2, messages: %3")
                       .arg(QString::number(now.seconds, 'f', 0), ui::bytesText(qint64(now.written.bytes)),
                            QString::number(now.written.messages));
    if (now.written.lost > 0) line += Text::tr(", lost: %1").arg(now.written.lost);
    progress_.tell(line);
  }

  bool offers(const QString& topic) const {
    const robot::LiveTopics* const topics = robot_.liveTopics();
    return topics && topics->known().contains(topic);
  }

  disk::FileError withPath(disk::FileError fault) const {
    if (fault.path.empty()) fault.path = args_.output;
    return fault;
  }

  tl::unexpected<CommandFailure> notWritten(const disk::FileError& fault) const {
    return wrong(sentences::wordsOf(disk::notWritten(withPath(fault))));
  }

  CommandResult<int> end(std::size_t missing) {
    progress_.clear();
    const Recorder::Progress done = recorder_->progress();
    QStringList silent;
    for (const QString& topic : order_.topics) {
      if (!recorder_->heard(topic.toStdString())) silent << topic;
    }
    const bool complete = done.written.lost == 0 && !done.end_fault && not_had_ == 0 && !refused_ &&
                          interruptions_ == 0 && silent.isEmpty();
    if (args_.json) {
      printJson(QJsonObject{{QStringLiteral("file"), order_.path},
                            {QStringLiteral("seconds"), done.seconds},
                            {QStringLiteral("bytes"), qint64(done.written.bytes)},
                            {QStringLiteral("messages"), qint64(done.written.messages)},
                            {QStringLiteral("attachments"), qint64(done.written.files)},
                            {QStringLiteral("submaps_missing"), qint64(missing)},
                            {QStringLiteral("lost"), qint64(done.written.lost)},
                            {QStringLiteral("lost_bytes"), qint64(done.written.lost_bytes)},
                            {QStringLiteral("interruptions"), interruptions_},
                            {QStringLiteral("silent_topics"), QJsonArray::fromStringList(silent)},
                            {QStringLiteral("complete"), complete}});
    } else {
      printLine(Text::tr("%1: %2 s, %3, messages: %4, files: %5")
                    .arg(oneLine(order_.path), QString::number(done.seconds, 'f', 1),
                         ui::bytesText(qint64(done.written.bytes)), QString::number(done.written.messages),
                         QString::number(done.written.files)));
    }
    if (done.end_fault) {
      say(sentences::wordsOf(disk::notWritten(withPath(*done.end_fault))));
    } else if (refused_) {
      say(*refused_);
    } else if (done.written.lost > 0) {
      say(Text::tr("Incomplete: messages were lost because the disk or this computer was too slow: %1 (%2).")
              .arg(QString::number(done.written.lost), ui::bytesText(qint64(done.written.lost_bytes))));
    }
    for (const QString& topic : silent)
      say(Text::tr("Nothing arrived on %1: %2")
              .arg(oneLine(topic), offers(topic) ? Text::tr("the robot has this topic but sent nothing.")
                                                 : Text::tr("the robot does not list this topic.")));
    return complete ? kDone : kIncomplete;
  }

  const RecordArguments& args_;
  RecordOrder order_;
  LiveRobot& live_;
  robot::Robot& robot_;
  std::unique_ptr<Recorder> recorder_;
  QObject context_;
  ProgressLine progress_;
  bool away_ = false;  // disconnected
  int interruptions_ = 0;
  int not_had_ = 0;
  std::optional<QString> refused_;
  std::optional<disk::FileError> told_;
};

CommandResult<int> record(const RecordArguments& args) {
  auto order = orderFrom(args);
  if (!order) return passOn(order);
  auto live = LiveRobot::make(args);
  if (!live) return passOn(live);
  if (!robot::deliversOf((*live)->robot()))
    return wrong(
        Text::tr("%1 is not a robot that sends messages: there is nothing to record.").arg(text(args.robot)));
  return RecordRun(args, std::move(*order), **live).carryOut();
}

}  // namespace

void addRecord(Commands& commands) {
  const auto shared = std::make_shared<RecordArguments>();
  RecordArguments& args = *shared;
  CLI::App* const command = commands.program().add_subcommand(
      "record", help(Text::tr("Record what a robot sends to a file, including its maps")));
  addRobot(*command, args, Text::tr("Robot address (or MAPWRIGHT_ROBOT)"));
  command->add_option("-o,--output", args.output, help(Text::tr("The MCAP file to write")))->required();
  addForce(*command, args.force);
  command
      ->add_option(
          "--duration", args.duration_s,
          help(Text::tr("For example 90s, 2m or 1h, or a number of seconds; by default until Ctrl+C")))
      ->transform(CLI::AsNumberWithUnit(std::map<std::string, double>{{"s", 1}, {"m", 60}, {"h", 3600}},
                                        CLI::AsNumberWithUnit::CASE_SENSITIVE)
                      .description(""))
      ->type_name("DURATION");
  command->add_option("--topics", args.topics,
                      help(Text::tr("Additional topics, separated by commas, as the robot names them")));
  command
      ->add_option("--streams", args.streams,
                   help(Text::tr("Kinds of data, separated by commas: all, none, %1")
                            .arg(words::listed(streamWords()))))
      ->capture_default_str();
  command
      ->add_option("--submaps", args.submaps,
                   help(Text::tr("listed (each submap once), all (every version) or none")))
      ->capture_default_str();
  addTimeout(*command, args.timeout_s, Text::tr("Timeout for connecting in seconds"));
  addJson(*command, args.json);
  commands.add(command, [shared](const Invocation& before) {
    inherit(*shared, before);
    return runLive(before.argc, before.argv, [&] { return record(*shared); });
  });
}

}  // namespace mapwright::app
