// `mapwright record`: records what a robot sends to an MCAP file (docs/command-line.md, "mapwright record";
// recorder/layout.h).
#include <cmath>
#include <cstdio>
#include <memory>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <QCoreApplication>
#include <QEventLoop>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>
#include <QTimer>

#include "app/command_failure.h"
#include "app/commands.h"
#include "app/connecting.h"
#include "app/exit_code.h"
#include "app/one_line.h"
#include "app/option_words.h"
#include "app/output_paths.h"
#include "app/robot_factory.h"
#include "app/say.h"
#include "app/stop_signals.h"
#include "app/stream_words.h"
#include "app/waypoint_list.h"
#include "disk/file_error.h"
#include "recorder/recorder.h"
#include "recording/append_file.h"
#include "robot/delivery.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "sentences/subject_name.h"
#include "ui/kit/status_text.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class RecordText {
  Q_DECLARE_TR_FUNCTIONS(Record)
};

/// The words as typed; empty = not given.
struct RecordWords {
  std::string robot;
  AccessWords access;
  std::string output;
  std::optional<double> duration_s;  // nullopt = until stopped
  double timeout_s = 30;             // for the connection
  std::string topics;                // comma-separated, by the robot's own names, in addition to `streams`
  std::string streams = "all";       // comma-separated kinds of data, "all" or "none"
  std::string submaps = "listed";    // "all", "listed" or "none"
  bool json = false, force = false;
};

using recorder::Recorder;
using recorder::SubmapRequests;

using words::text;

/// The validated options.
struct RecordOrder {
  map::Streams streams;
  QStringList topics;
  SubmapRequests::Which submaps = SubmapRequests::Which::Listed;
  QString path;
};

CommandResult<RecordOrder> orderFrom(const RecordWords& words) {
  RecordOrder order;
  order.path = text(words.output);
  const auto streams = streamsFrom(text(words.streams));
  if (!streams)
    return wrong(RecordText::tr("--streams: \"%1\" is unknown. Choose from: all, none, %2.")
                     .arg(streams.error(), streamWords().join(QLatin1String(", "))));
  order.streams = *streams;
  for (const QString& topic : text(words.topics).split(QLatin1Char(','), Qt::SkipEmptyParts))
    order.topics << topic.trimmed();
  if (words.submaps == "all") {
    order.submaps = SubmapRequests::Which::All;
  } else if (words.submaps == "none") {
    order.submaps = SubmapRequests::Which::None;
  } else if (words.submaps != "listed") {
    return wrong(
        RecordText::tr("--submaps must be all, listed or none, not \"%1\".").arg(text(words.submaps)));
  }
  if (words.duration_s && !(*words.duration_s > 0 && *words.duration_s <= 1e8))
    return wrong(RecordText::tr("--duration must be greater than 0 seconds and at most 100000000."));
  if (!(words.timeout_s > 0 && words.timeout_s <= 86'400))
    return wrong(RecordText::tr("--timeout must be greater than 0 and at most 86400 seconds."));
  if (isStandardOutput(order.path))
    return wrong(RecordText::tr(
        "A recording must go to a regular file (-o FILE), because its index is written at the end."));
  if (const auto why = whyNotWritable(order.path)) return wrong(*why);
  if (QFileInfo::exists(order.path) && !words.force)
    return wrong(RecordText::tr("%1 already exists. Pass --force to replace it.").arg(order.path));
  return order;
}

/// The scheme without its separator: "axbot".
std::string kindOf(const QString& address) {
  const auto parsed = knownAddresses().parse(address);
  QString scheme = parsed ? parsed->scheme : QString();
  while (!scheme.isEmpty() && !scheme.back().isLetterOrNumber()) scheme.chop(1);
  return scheme.toStdString();
}

/// One recording from the first connection to its end.
class RecordRun {
 public:
  RecordRun(const RecordWords& words, RecordOrder order, std::unique_ptr<robot::Robot> robot)
      : words_(words), order_(std::move(order)), robot_(std::move(robot)) {
    QObject::connect(&signals_, &StopSignals::came, &context_, [this] {
      stopped_ = true;
      loop_.quit();
    });
  }

  CommandResult<int> carryOut() {
    if (auto failure = connect()) return tl::make_unexpected(*failure);
    if (stopped_) return kDone;  // nothing was started
    auto target = recording::appendFile(
        words_.output, words_.force ? recording::Existing::Replace : recording::Existing::Refuse);
    if (!target) return notWritten(target.error());
    Recorder::Options options;
    options.kind = kindOf(text(words_.robot));
    options.recorded_by = std::string("mapwright ") + MAPWRIGHT_VERSION;
    options.submaps = order_.submaps;
    auto recorder = Recorder::start(*robot_, std::move(*target), std::move(options));
    if (!recorder) return notWritten(recorder.error());
    recorder_ = std::move(*recorder);
    follow();
    const std::size_t missing = recorder_->fetches().submapsMissing();
    recorder_->finish();
    return end(missing);
  }

 private:
  std::optional<CommandFailure> connect() {
    if (robot::LiveTopics* const topics = robot_->liveTopics()) {
      topics->setBasics({});
      topics->setWanted(order_.streams, order_.topics);
    }
    return connectWithin(*robot_, words_.timeout_s, loop_);
  }

  /// Runs until it should end.
  void follow() {
    QObject::connect(recorder_.get(), &Recorder::progressed, &context_, [this] { tellProgress(); });
    QObject::connect(recorder_.get(), &Recorder::notHad, &context_, [this](const map::Failure& failure) {
      ++not_had_;
      say(RecordText::tr("%1: %2").arg(sentences::nameOf(failure.subject),
                                       text(sentences::sentenceOf(failure))));
    });
    QObject::connect(robot_.get(), &robot::Robot::connectionChanged, &context_, [this] {
      const robot::ConnectionState link = robot_->connection();
      if (link.phase == robot::ConnectionPhase::Interrupted && !away_) {
        away_ = true;
        ++interruptions_;
        clearLine();
        say(RecordText::tr("The connection was lost after %1 s. %2")
                .arg(QString::number(recorder_->progress().seconds, 'f', 1),
                     sentences::wordsOf(link.reason)));
      } else if (link.phase == robot::ConnectionPhase::Online && away_) {
        away_ = false;
        clearLine();
        say(RecordText::tr("Reconnected after %1 s.")
                .arg(QString::number(recorder_->progress().seconds, 'f', 1)));
      }
      if (link.phase != robot::ConnectionPhase::Refused) return;
      refused_ = whyNotConnected(robot_->connection());
      loop_.quit();
    });
    if (words_.duration_s)
      QTimer::singleShot(std::chrono::milliseconds(std::llround(*words_.duration_s * 1000)), &context_,
                         [this] { loop_.quit(); });
    loop_.exec();
  }

  void tellProgress() {
    const Recorder::Progress now = recorder_->progress();
    if (now.written.fault && now.written.fault != told_) {
      clearLine();
      say(sentences::wordsOf(disk::notWritten(withPath(*now.written.fault))));
    } else if (!now.written.fault && told_) {
      clearLine();
      say(RecordText::tr("Recording to %1 continues.").arg(order_.path));
    }
    told_ = now.written.fault;
    if (!terminal_) return;
    QString line =
        RecordText::tr("%1 s, %2, messages: %3")
            .arg(QString::number(now.seconds, 'f', 0), window::bytesText(qint64(now.written.bytes)),
                 QString::number(now.written.messages));
    if (now.written.lost > 0) line += RecordText::tr(", lost: %1").arg(now.written.lost);
    std::fprintf(stderr, "\r%-70s", qUtf8Printable(line));
  }

  bool offers(const QString& topic) const {
    const robot::LiveTopics* const topics = robot_->liveTopics();
    return topics && topics->known().contains(topic);
  }

  void clearLine() const {
    if (terminal_) std::fprintf(stderr, "\r%-70s\r", "");
  }

  disk::FileError withPath(disk::FileError fault) const {
    if (fault.path.empty()) fault.path = words_.output;
    return fault;
  }

  tl::unexpected<CommandFailure> notWritten(const disk::FileError& fault) const {
    return wrong(sentences::wordsOf(disk::notWritten(withPath(fault))));
  }

  CommandResult<int> end(std::size_t missing) {
    clearLine();
    const Recorder::Progress done = recorder_->progress();
    QStringList silent;
    for (const QString& topic : order_.topics) {
      if (!recorder_->heard(topic.toStdString())) silent << topic;
    }
    const bool complete = done.written.lost == 0 && !done.end_fault && not_had_ == 0 && !refused_ &&
                          interruptions_ == 0 && silent.isEmpty();
    if (words_.json) {
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
      std::printf("%s\n", qUtf8Printable(RecordText::tr("%1: %2 s, %3, messages: %4, files: %5")
                                             .arg(oneLine(order_.path), QString::number(done.seconds, 'f', 1),
                                                  window::bytesText(qint64(done.written.bytes)),
                                                  QString::number(done.written.messages),
                                                  QString::number(done.written.files))));
    }
    if (done.end_fault) {
      say(sentences::wordsOf(disk::notWritten(withPath(*done.end_fault))));
    } else if (refused_) {
      say(*refused_);
    } else if (done.written.lost > 0) {
      say(RecordText::tr(
              "Incomplete: messages were lost because the disk or this computer was too slow: %1 (%2).")
              .arg(QString::number(done.written.lost), window::bytesText(qint64(done.written.lost_bytes))));
    }
    for (const QString& topic : silent)
      say(RecordText::tr("Nothing arrived on %1: %2")
              .arg(oneLine(topic), offers(topic)
                                       ? RecordText::tr("the robot has this topic but sent nothing.")
                                       : RecordText::tr("the robot does not list this topic.")));
    return complete ? kDone : kIncomplete;
  }

  const RecordWords& words_;
  RecordOrder order_;
  std::unique_ptr<robot::Robot> robot_;
  std::unique_ptr<Recorder> recorder_;  // goes before the robot
  QObject context_;
  StopSignals signals_;
  QEventLoop loop_;
  bool stopped_ = false;
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  bool away_ = false;  // disconnected
  int interruptions_ = 0;
  int not_had_ = 0;
  std::optional<QString> refused_;
  std::optional<disk::FileError> told_;
};

CommandResult<int> carryOut(const RecordWords& words) {
  auto order = orderFrom(words);
  if (!order) return tl::make_unexpected(order.error());
  const QString address = text(words.robot);
  if (address.isEmpty()) return wrong(RecordText::tr("Which robot? Pass --robot ADDRESS."));
  const auto access = RobotAccess::read(words.access, address);
  if (!access) return wrong(access.error());
  auto robot = makeRobot(address, access->forAddress(address), DemoTime::Running);
  if (!robot) return wrong(robot.error());
  if (!robot::deliversOf(**robot))
    return wrong(
        RecordText::tr("%1 is not a robot that sends messages: there is nothing to record.").arg(address));
  return RecordRun(words, std::move(*order), std::move(*robot)).carryOut();
}

/// Until the time is over, or SIGINT or SIGTERM.
int record(const RecordWords& words, int& argc, char** argv) {
  holdStopSignals();
  const QCoreApplication application(argc, argv);
  const CommandResult<int> done = carryOut(words);
  std::fflush(stdout);
  if (done) return *done;
  say(done.error().sentence);
  return done.error().exit_code;
}

}  // namespace

void addRecord(Commands& commands) {
  const auto shared = std::make_shared<RecordWords>();
  RecordWords& words = *shared;
  CLI::App* const command = commands.program().add_subcommand(
      "record", help(RecordText::tr("Record what a robot sends to a file, including its maps")));
  addRobot(*command, words.robot, words.access, RecordText::tr("Robot address (or MAPWRIGHT_ROBOT)"));
  command->add_option("-o,--output", words.output, help(RecordText::tr("The MCAP file to write")))
      ->required();
  command->add_flag("--force", words.force, help(RecordText::tr("Replace an existing file")));
  command->add_option("--duration", words.duration_s,
                      help(RecordText::tr("Length in seconds; by default until Ctrl+C")));
  command->add_option(
      "--topics", words.topics,
      help(RecordText::tr("Additional topics, separated by commas, as the robot names them")));
  command
      ->add_option("--streams", words.streams,
                   help(RecordText::tr("Kinds of data, separated by commas: all, none, %1")
                            .arg(streamWords().join(QLatin1String(", ")))))
      ->capture_default_str();
  command
      ->add_option("--submaps", words.submaps,
                   help(RecordText::tr("listed (each submap once), all (every version) or none")))
      ->capture_default_str();
  addTimeout(*command, words.timeout_s, RecordText::tr("Give up connecting after this many seconds"));
  addJson(*command, words.json);
  commands.add(command, shared, record);
}

}  // namespace mapwright::app
