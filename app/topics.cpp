// `mapwright topics list|echo|hz`: a robot's topics under its own names (docs/command-line.md, "mapwright
// topics").
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <mutex>

#include <CLI/CLI.hpp>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTimer>

#include "app/command_text.h"
#include "app/commands.h"
#include "app/live_robot.h"
#include "app/output.h"
#include "app/report.h"
#include "net/rosbridge/frame.h"
#include "robot/delivery.h"
#include "robot/offers_topics.h"
#include "sentences/absence_sentence.h"
#include "ui/kit/status_text.h"
#include "ui/scene/layer.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

/// As typed; empty = not given.
struct TopicsArguments : RobotArguments {
  TopicsArguments() { timeout_s = 30; }  // for the connection, and for each message of echo
  std::vector<std::string> topics;
  int count = 0;         // for echo: messages; 0: until stopped
  double seconds = 10;   // of hz
  bool shorten = false;  // of echo
};

using robot::OfferedTopic;

using words::text;

/// The statistics of a topic.
struct Tally {
  qint64 count = 0, bytes = 0;
  double first_s = 0, last_s = 0, shortest_s = 0, longest_s = 0, squares = 0;

  void add(double at_s, std::size_t size) {
    const double since_s = at_s - last_s;
    if (++count == 1) {
      first_s = last_s = at_s;
      return;
    }
    bytes += qint64(size);  // of those in the time span, without its first message
    shortest_s = count == 2 ? since_s : std::min(shortest_s, since_s);
    longest_s = std::max(longest_s, since_s);
    squares += since_s * since_s;
    last_s = at_s;
  }
  bool told() const { return count > 1 && last_s > first_s; }
  double span() const { return last_s - first_s; }
  double perSecond() const { return double(count - 1) / span(); }
  double deviation() const {
    const double mean = span() / double(count - 1);
    return std::sqrt(std::max(0.0, squares / double(count - 1) - mean * mean));
  }
};

class TopicsRun {
 public:
  TopicsRun(const TopicsArguments& args, LiveRobot& live)
      : args_(args), live_(live), robot_(live.robot()), offers_(robot::topicsOfferedBy(robot_)) {
    for (const std::string& typed : args_.topics) {
      QString topic = text(typed);
      if (!topic.startsWith(QLatin1Char('/'))) topic.prepend(QLatin1Char('/'));
      if (!topics_.contains(topic)) topics_ << topic;
    }
  }
  ~TopicsRun() {
    if (robot::Delivers* const delivers = robot::deliversOf(robot_)) delivers->setDeliveryTap({});
  }

  CommandResult<int> list() {
    QStringList lost;  // of a recording, and topics with it
    QObject::connect(&robot_, &robot::Robot::problemFound, &context_, [&lost](const map::Problem& problem) {
      if (problem.subject.kind == map::SubjectKind::Bag && problem.severity >= map::Severity::Warning)
        lost << problemLine(problem);
    });
    auto failure = connect({});
    QObject::disconnect(&robot_, nullptr, &context_, nullptr);
    if (failure) return tl::make_unexpected(*failure);
    auto told = offers_ ? offers_->offered() : std::nullopt;
    const bool all = told.has_value();
    if (!told) {
      told.emplace();
      for (const QString& name : robot_.liveTopics()->known()) told->push_back({name, {}});
    }
    std::sort(told->begin(), told->end(),
              [](const OfferedTopic& a, const OfferedTopic& b) { return a.name < b.name; });
    print(*told);
    for (const QString& sentence : lost) say(sentence);
    if (all) return lost.isEmpty() ? kDone : kIncomplete;
    say(offers_
            ? Text::tr("The robot does not list its topics (its node rosapi is not running): these "
                       "are the usual ones.")
            : Text::tr("The robot does not list its topics: these are the ones that mapwright understands."));
    return kIncomplete;
  }

  CommandResult<int> echo() {
    robot::Delivers* const delivers = robot::deliversOf(robot_);
    int left = args_.count;
    bool shortened = false;
    QTimer silence;
    silence.setSingleShot(true);
    QObject::connect(&silence, &QTimer::timeout, &context_, [this] { live_.quit(); });
    const auto print = [&](QByteArray line) {
      if (args_.count > 0 && left == 0) return;
      if (args_.shorten) line = shorter(line, shortened);
      printOut((line + '\n').toStdString());
      std::fflush(stdout);
      silence.start();
      if (args_.count > 0 && --left == 0) live_.quit();
    };
    const std::string topic = topics_.front().toStdString();
    delivers->setDeliveryTap([&](const robot::Delivery& message) {
      if (message.kind != robot::Delivery::Kind::Message || message.before || message.name != topic) return;
      QMetaObject::invokeMethod(
          &context_, [&print, line = lineOf(message, *delivers)] { print(line); }, Qt::QueuedConnection);
    });
    if (auto failure = connect(topics_)) return tl::make_unexpected(*failure);
    silence.setInterval(std::chrono::milliseconds(std::llround(args_.timeout_s * 1000)));
    silence.start();
    const bool done = live_.stopped() || (args_.count > 0 && left == 0);
    if (!done) live_.follow({});
    delivers->setDeliveryTap({});
    if (shortened) say(Text::tr("Long lists and texts are shortened (--shorten)."));
    if (!live_.stopped() && (args_.count == 0 || left > 0))
      say(Text::tr("%1: nothing arrived within %2 s (--timeout).")
              .arg(topics_.front(), QString::number(args_.timeout_s)));
    const bool ended_by_hand = live_.stopped() && args_.count == 0;
    return ended_by_hand || (args_.count > 0 && left == 0) ? kDone : kIncomplete;
  }

  CommandResult<int> hz() {
    robot::Delivers* const delivers = robot::deliversOf(robot_);
    std::mutex mutex;
    std::map<QString, Tally> tallies;
    for (const QString& topic : std::as_const(topics_)) tallies[topic];
    delivers->setDeliveryTap([&](const robot::Delivery& message) {
      if (message.kind != robot::Delivery::Kind::Message || message.before) return;
      const std::lock_guard lock(mutex);
      const auto found = tallies.find(QString::fromUtf8(message.name.data(), qsizetype(message.name.size())));
      if (found != tallies.end()) found->second.add(message.received_s, message.bytes.size());
    });
    if (offers_) offers_->setEveryMessage(true);
    if (auto failure = connect(topics_)) return tl::make_unexpected(*failure);
    live_.follow(args_.seconds);
    delivers->setDeliveryTap({});
    return report(tallies);
  }

 private:
  std::optional<CommandFailure> connect(const QStringList& topics) {
    robot::LiveTopics& live = *robot_.liveTopics();
    live.setBasics({false, false, false});
    live.setWanted({}, topics);
    return live_.connectToRobot();
  }

  /// The layers that show it.
  QStringList layersOf(const QString& topic) const {
    // Patches are part of their grid.
    const QString patches = QStringLiteral("_updates");
    const QString grid = topic.endsWith(patches) ? topic.chopped(patches.size()) : topic;
    QStringList layers;
    for (const ui::scene::Layer layer : ui::scene::allLayers()) {
      map::Streams streams = ui::scene::layerStreams(layer);
      // Where the robot is comes without being asked for.
      if (layer == ui::scene::Layer::Robot) streams.insert(map::Stream::Pose);
      if (layer == ui::scene::Layer::Footprint) streams.insert(map::Stream::Model);
      if (std::any_of(streams.begin(), streams.end(), [&](map::Stream stream) {
            const QStringList known = robot_.liveTopics()->topicsOf(stream);
            return known.contains(topic) || known.contains(grid);
          }))
        layers << ui::scene::layerName(layer);
    }
    return layers;
  }

  void print(const std::vector<OfferedTopic>& topics) const {
    if (args_.json) {
      QJsonArray rows;
      for (const OfferedTopic& topic : topics)
        rows << QJsonObject{
            {QStringLiteral("topic"), topic.name},
            {QStringLiteral("type"), topic.type.isEmpty() ? QJsonValue() : QJsonValue(topic.type)},
            {QStringLiteral("layers"), QJsonArray::fromStringList(layersOf(topic.name))}};
      return printJson(rows);
    }
    std::vector<QStringList> table{{Text::tr("TYPE"), Text::tr("LAYERS"), Text::tr("TOPIC")}};
    for (const OfferedTopic& topic : topics) {
      const QStringList layers = layersOf(topic.name);
      table.push_back({topic.type.isEmpty() ? QStringLiteral("?") : words::plainName(topic.type),
                       layers.isEmpty() ? QStringLiteral("-") : layers.join(QLatin1Char(',')),
                       words::plainName(topic.name)});
    }
    printTable(table);
  }

  /// All of a message as one line of JSON. On any thread.
  static QByteArray lineOf(const robot::Delivery& message, const robot::Delivers& from) {
    const QByteArray bytes(message.bytes.data(), qsizetype(message.bytes.size()));
    // JSON has line breaks only between its words, where a space means the same.
    if (message.encoding == "json") return QByteArray(bytes).replace('\n', ' ').replace('\r', ' ');
    if (message.encoding == "cbor") {
      using net::rosbridge::Frame;
      const auto frame = Frame::read(bytes, Frame::Wire::Binary);
      if (frame->fault() == Frame::Fault::None) return frame->root().toWholeJson();
    }
    if (const auto json = from.jsonOf(message)) return QByteArray::fromStdString(*json);
    const QJsonObject unknown{
        {QStringLiteral("topic"), QString::fromUtf8(message.name.data(), qsizetype(message.name.size()))},
        {QStringLiteral("bytes"), bytes.size()},
        {QStringLiteral("base64"), QString::fromLatin1(bytes.toBase64())}};
    return QJsonDocument(unknown).toJson(QJsonDocument::Compact);
  }

  /// The beginnings of long lists and texts, as JSON. What is no JSON stays as it is.
  static QByteArray shorter(const QByteArray& json, bool& shortened) {
    using net::rosbridge::Frame;
    const auto frame = Frame::read(json, Frame::Wire::Text);
    if (frame->fault() != Frame::Fault::None) return json;
    QByteArray text = frame->root().toJson(std::numeric_limits<qsizetype>::max());
    shortened |= text != frame->root().toWholeJson();
    return text;
  }

  CommandResult<int> report(const std::map<QString, Tally>& tallies) const {
    QJsonArray rows;
    std::vector<QStringList> table{{Text::tr("PER SECOND"), Text::tr("MESSAGES"), Text::tr("MIN (s)"),
                                    Text::tr("MAX (s)"), Text::tr("STD DEV (s)"), Text::tr("BYTES/s"),
                                    Text::tr("TOPIC")}};
    bool all = true;
    for (const QString& topic : topics_) {
      const Tally& tally = tallies.at(topic);
      const bool told = tally.told();
      const auto known = [&](double value) { return told ? QJsonValue(value) : QJsonValue(); };
      const auto shown = [&](double value) {
        return told ? QString::number(value, 'f', 3) : QStringLiteral("?");
      };
      const double bytes_per_s = told ? double(tally.bytes) / tally.span() : 0;
      rows << QJsonObject{{QStringLiteral("topic"), topic},
                          {QStringLiteral("messages"), tally.count},
                          {QStringLiteral("hz"), known(told ? tally.perSecond() : 0)},
                          {QStringLiteral("min_s"), known(tally.shortest_s)},
                          {QStringLiteral("max_s"), known(tally.longest_s)},
                          {QStringLiteral("stddev_s"), known(told ? tally.deviation() : 0)},
                          {QStringLiteral("bytes_per_s"), known(bytes_per_s)}};
      table.push_back({shown(told ? tally.perSecond() : 0), QString::number(tally.count),
                       shown(tally.shortest_s), shown(tally.longest_s), shown(told ? tally.deviation() : 0),
                       told ? ui::bytesText(qint64(bytes_per_s)) : QStringLiteral("?"),
                       words::plainName(topic)});
      all &= told;
    }
    if (args_.json) {
      printJson(rows);
    } else {
      printTable(table);
    }
    for (const QString& topic : topics_) {
      if (tallies.at(topic).told()) continue;
      const QString sentence =
          tallies.at(topic).count == 0
              ? Text::tr("%1: nothing arrived within %2 s (--seconds).")
              : Text::tr("%1: only one message arrived within %2 s (--seconds), too few for a rate.");
      say(sentence.arg(topic, QString::number(args_.seconds)));
    }
    return all ? kDone : kIncomplete;
  }

  const TopicsArguments& args_;
  LiveRobot& live_;
  robot::Robot& robot_;
  robot::OffersTopics* offers_;
  QStringList topics_;
  QObject context_;
};

CommandResult<int> runTopics(const std::string& what, const TopicsArguments& args) {
  if (!args.robot.empty()) {
    if (const auto why = noTimeoutReason(args.timeout_s)) return wrong(*why);
    if (!(args.seconds > 0 && args.seconds <= 86'400))
      return wrong(Text::tr("--seconds must be greater than 0 and at most 86400."));
  }
  auto live = LiveRobot::make(args);
  if (!live) return passOn(live);
  robot::Robot& robot = (*live)->robot();
  if (!robot.liveTopics())
    return wrong(Text::tr("%1: %2").arg(
        text(args.robot),
        sentences::absenceReason(robot::Capability::Live, robot.unavailableReason(robot::Capability::Live))));
  if (what != "list" && !robot::deliversOf(robot))
    return wrong(Text::tr("%1 sends nothing by itself. For a recording, mapwright bags frames prints the "
                          "messages and mapwright bags info shows what it contains.")
                     .arg(text(args.robot)));
  TopicsRun run(args, **live);
  return what == "list" ? run.list() : what == "echo" ? run.echo() : run.hz();
}

}  // namespace

void addTopics(Commands& commands) {
  const auto shared = std::make_shared<TopicsArguments>();
  TopicsArguments& args = *shared;
  CLI::App* const topics =
      commands.program().add_subcommand("topics", help(Text::tr("The topics of a robot: list, echo, hz")));
  topics->require_subcommand(1);
  const auto add = [&](const char* name, const QString& what) {
    CLI::App* const command = topics->add_subcommand(name, help(what));
    addRobot(*command, args, Text::tr("Robot address, or a recording for list (or MAPWRIGHT_ROBOT)"));
    addJson(*command, args.json);
    commands.add(command, [shared, name](const Invocation& before) {
      inherit(*shared, before);
      return runLive(before.argc, before.argv, [&] { return runTopics(name, *shared); });
    });
    return command;
  };
  addTimeout(*add("list", Text::tr("List all topics with their types")), args.timeout_s,
             Text::tr("Timeout for connecting in seconds"));
  CLI::App* const echo = add(
      "echo", Text::tr("Print the messages of a topic as they arrive, one JSON text per line, until Ctrl+C"));
  echo->add_option("topic", args.topics, help(Text::tr("Topic, as the robot names it")))
      ->required()
      ->expected(1);
  echo->add_option("--count", args.count,
                   help(Text::tr("Stop after this many messages; by default at Ctrl+C")))
      ->check(CLI::Range(1, 1'000'000'000));
  echo->add_flag("--shorten", args.shorten,
                 help(Text::tr("Print only the beginning of long lists and texts, still as JSON")));
  addTimeout(*echo, args.timeout_s, Text::tr("Timeout in seconds without a connection or a message"));
  CLI::App* const hz = add("hz", Text::tr("Measure the rates of topics and how regular they are"));
  hz->add_option("topics", args.topics, help(Text::tr("Topics, as the robot names them")))->required();
  hz->add_option("--seconds", args.seconds, help(Text::tr("For how many seconds to measure")))
      ->capture_default_str();
  addTimeout(*hz, args.timeout_s, Text::tr("Timeout for connecting in seconds"));
}

}  // namespace mapwright::app
