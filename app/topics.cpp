// `mapwright topics list|echo|hz`: a robot's topics under its own names (docs/command-line.md, "mapwright
// topics").
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>

#include <CLI/CLI.hpp>
#include <QCoreApplication>
#include <QEventLoop>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTimer>

#include "app/commands.h"
#include "app/connecting.h"
#include "app/exit_code.h"
#include "app/option_words.h"
#include "app/output_paths.h"
#include "app/robot_factory.h"
#include "app/say.h"
#include "app/stop_signals.h"
#include "app/table.h"
#include "robot/delivery.h"
#include "robot/offers_topics.h"
#include "sentences/absence_sentence.h"
#include "ui/kit/status_text.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class TopicsText {
  Q_DECLARE_TR_FUNCTIONS(Topics)
};

/// The words as typed; empty = not given.
struct TopicsWords {
  std::string robot;
  AccessWords access;
  std::vector<std::string> topics;
  int count = 0;          // for echo: messages; 0: until stopped
  double seconds = 10;    // of hz
  double timeout_s = 30;  // for the connection, and for each message of echo
  bool json = false;
};

using robot::OfferedTopic;

using words::text;
/// The statistics of a topic.
struct Tally {
  qint64 count = 0, bytes = 0;
  double first_s = 0, last_s = 0, shortest_s = 0, longest_s = 0, squares = 0;

  void note(double at_s, std::size_t size) {
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
  TopicsRun(const TopicsWords& words, std::unique_ptr<robot::Robot> robot)
      : words_(words), robot_(std::move(robot)), offers_(robot::topicsOfferedBy(*robot_)) {
    for (const std::string& typed : words_.topics) {
      QString topic = text(typed);
      if (!topic.startsWith(QLatin1Char('/'))) topic.prepend(QLatin1Char('/'));
      if (!topics_.contains(topic)) topics_ << topic;
    }
    QObject::connect(&signals_, &StopSignals::came, &context_, [this] {
      stopped_ = true;
      loop_.quit();
    });
  }
  ~TopicsRun() {
    if (robot::Delivers* const delivers = robot::deliversOf(*robot_)) delivers->setDeliveryTap({});
  }

  CommandResult<int> list() {
    if (auto failure = connect({})) return tl::make_unexpected(*failure);
    auto told = offers_ ? offers_->offered() : std::nullopt;
    const bool all = told.has_value();
    if (!told) {
      told.emplace();
      for (const QString& name : robot_->liveTopics()->known()) told->push_back({name, {}});
    }
    std::sort(told->begin(), told->end(),
              [](const OfferedTopic& a, const OfferedTopic& b) { return a.name < b.name; });
    print(*told);
    if (all) return kDone;
    say(offers_ ? TopicsText::tr("The robot does not list its topics (its node rosapi is not running): these "
                                 "are the usual ones.")
                : TopicsText::tr(
                      "The robot does not list its topics: these are the ones that mapwright understands."));
    return kIncomplete;
  }

  CommandResult<int> echo() {
    int left = words_.count;
    bool cut = false;
    QTimer silence;
    silence.setSingleShot(true);
    QObject::connect(&silence, &QTimer::timeout, &context_, [this] { loop_.quit(); });
    QObject::connect(robot_.get(), &robot::Robot::rawReceived, &context_,
                     [&](const robot::RawMessage& message) {
                       if (message.topic != topics_.front() || (words_.count > 0 && left == 0)) return;
                       cut |= message.text.size() >= robot::kMaxRawText;
                       printOut((lineOf(message.text) + '\n').toStdString());
                       std::fflush(stdout);
                       silence.start();
                       if (words_.count > 0 && --left == 0) loop_.quit();
                     });
    robot_->liveTopics()->setWatching(true);
    if (auto failure = connect(topics_)) return tl::make_unexpected(*failure);
    silence.setInterval(std::chrono::milliseconds(std::llround(words_.timeout_s * 1000)));
    silence.start();
    const bool done = stopped_ || (words_.count > 0 && left == 0);
    if (!done) loop_.exec();
    if (cut) say(TopicsText::tr("Messages longer than 1 MiB were truncated."));
    if (!stopped_ && (words_.count == 0 || left > 0))
      say(TopicsText::tr("%1: nothing arrived within %2 s (--timeout).")
              .arg(topics_.front(), QString::number(words_.timeout_s)));
    const bool ended_by_hand = stopped_ && words_.count == 0;
    return !cut && (ended_by_hand || (words_.count > 0 && left == 0)) ? kDone : kIncomplete;
  }

  CommandResult<int> hz() {
    robot::Delivers* const delivers = robot::deliversOf(*robot_);
    std::mutex mutex;
    std::map<QString, Tally> tallies;
    for (const QString& topic : std::as_const(topics_)) tallies[topic];
    delivers->setDeliveryTap([&](const robot::Delivery& message) {
      if (message.kind != robot::Delivery::Kind::Message || message.before) return;
      const std::lock_guard lock(mutex);
      const auto found = tallies.find(QString::fromUtf8(message.name.data(), qsizetype(message.name.size())));
      if (found != tallies.end()) found->second.note(message.received_s, message.bytes.size());
    });
    if (offers_) offers_->setEveryMessage(true);
    if (auto failure = connect(topics_)) return tl::make_unexpected(*failure);
    QTimer::singleShot(std::chrono::milliseconds(std::llround(words_.seconds * 1000)), &context_,
                       [this] { loop_.quit(); });
    if (!stopped_) loop_.exec();
    delivers->setDeliveryTap({});
    return report(tallies);
  }

 private:
  std::optional<CommandFailure> connect(const QStringList& topics) {
    robot::LiveTopics& live = *robot_->liveTopics();
    live.setBasics({false, false, false});
    live.setWanted({}, topics);
    return connectWithin(*robot_, words_.timeout_s, loop_);
  }

  void print(const std::vector<OfferedTopic>& topics) const {
    if (words_.json) {
      QJsonArray rows;
      for (const OfferedTopic& topic : topics)
        rows << QJsonObject{
            {QStringLiteral("topic"), topic.name},
            {QStringLiteral("type"), topic.type.isEmpty() ? QJsonValue() : QJsonValue(topic.type)}};
      return printJson(rows);
    }
    std::vector<QStringList> table{{TopicsText::tr("TYPE"), TopicsText::tr("TOPIC")}};
    for (const OfferedTopic& topic : topics)
      table.push_back({topic.type.isEmpty() ? QStringLiteral("?") : words::plainName(topic.type),
                       words::plainName(topic.name)});
    printTable(table);
  }

  /// JSON without line breaks, unchanged if it has none.
  static QByteArray lineOf(const QByteArray& message) {
    if (!message.contains('\n')) return message;
    const QJsonDocument parsed = QJsonDocument::fromJson(message);
    return parsed.isNull() ? QByteArray(message).replace('\n', ' ') : parsed.toJson(QJsonDocument::Compact);
  }

  CommandResult<int> report(const std::map<QString, Tally>& tallies) const {
    QJsonArray rows;
    std::vector<QStringList> table{{TopicsText::tr("PER SECOND"), TopicsText::tr("MESSAGES"),
                                    TopicsText::tr("MIN (s)"), TopicsText::tr("MAX (s)"),
                                    TopicsText::tr("STD DEV (s)"), TopicsText::tr("BYTES/s"),
                                    TopicsText::tr("TOPIC")}};
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
                       told ? window::bytesText(qint64(bytes_per_s)) : QStringLiteral("?"),
                       words::plainName(topic)});
      all &= told;
    }
    if (words_.json) {
      printJson(rows);
    } else {
      printTable(table);
    }
    for (const QString& topic : topics_) {
      if (tallies.at(topic).told()) continue;
      const QString sentence =
          tallies.at(topic).count == 0
              ? TopicsText::tr("%1: nothing arrived within %2 s (--seconds).")
              : TopicsText::tr("%1: only one message arrived within %2 s (--seconds), too few for a rate.");
      say(sentence.arg(topic, QString::number(words_.seconds)));
    }
    return all ? kDone : kIncomplete;
  }

  const TopicsWords& words_;
  std::unique_ptr<robot::Robot> robot_;
  robot::OffersTopics* offers_;
  QStringList topics_;
  QObject context_;
  StopSignals signals_;
  QEventLoop loop_;
  bool stopped_ = false;
};

CommandResult<int> carryOut(const TopicsWords& words, const std::string& what) {
  const QString address = text(words.robot);
  if (address.isEmpty()) return wrong(TopicsText::tr("Which robot? Pass --robot ADDRESS."));
  if (!(words.timeout_s > 0 && words.timeout_s <= 86'400))
    return wrong(TopicsText::tr("--timeout must be greater than 0 and at most 86400 seconds."));
  if (!(words.seconds > 0 && words.seconds <= 86'400))
    return wrong(TopicsText::tr("--seconds must be greater than 0 and at most 86400."));
  if (words.count < 0) return wrong(TopicsText::tr("--count must be at least 1."));
  const auto access = RobotAccess::read(words.access, address);
  if (!access) return wrong(access.error());
  auto robot = makeRobot(address, access->forAddress(address), DemoTime::Running);
  if (!robot) return wrong(robot.error());
  if (!(*robot)->liveTopics())
    return wrong(TopicsText::tr("%1: %2").arg(
        address, sentences::whyAbsent(robot::Capability::Live, (*robot)->whyNot(robot::Capability::Live))));
  if (what != "list" && !robot::deliversOf(**robot))
    return wrong(TopicsText::tr("%1 sends nothing by itself. For a recording, mapwright bags frames prints "
                                "the messages and mapwright bags info shows what it contains.")
                     .arg(address));
  TopicsRun run(words, std::move(*robot));
  return what == "list" ? run.list() : what == "echo" ? run.echo() : run.hz();
}

int runTopics(const std::string& what, const TopicsWords& words, int& argc, char** argv) {
  holdStopSignals();
  const QCoreApplication application(argc, argv);
  const CommandResult<int> done = carryOut(words, what);
  std::fflush(stdout);
  if (done) return *done;
  say(done.error().sentence);
  return done.error().exit_code;
}

}  // namespace

void addTopics(Commands& commands) {
  const auto shared = std::make_shared<TopicsWords>();
  TopicsWords& words = *shared;
  CLI::App* const topics = commands.program().add_subcommand(
      "topics", help(TopicsText::tr("The topics of a robot, under its own names: list, echo, hz")));
  topics->require_subcommand(1);
  const auto add = [&](const char* name, const QString& what) {
    CLI::App* const command = topics->add_subcommand(name, help(what));
    addRobot(*command, words.robot, words.access,
             TopicsText::tr("Robot address, or a recording for list (or MAPWRIGHT_ROBOT)"));
    addJson(*command, words.json);
    commands.add(command, shared, [name](const TopicsWords& typed, int& argc, char** argv) {
      return runTopics(name, typed, argc, argv);
    });
    return command;
  };
  addTimeout(*add("list", TopicsText::tr("List all topics with their types")), words.timeout_s,
             TopicsText::tr("Give up connecting after this many seconds"));
  CLI::App* const echo = add(
      "echo",
      TopicsText::tr("Print the messages of a topic as they arrive, one JSON text per line, until Ctrl+C"));
  echo->add_option("topic", words.topics, help(TopicsText::tr("Topic, as the robot names it")))
      ->required()
      ->expected(1);
  echo->add_option("--count", words.count,
                   help(TopicsText::tr("Stop after this many messages; by default when interrupted")))
      ->check(CLI::Range(1, 1'000'000'000));
  addTimeout(*echo, words.timeout_s,
             TopicsText::tr("Give up after this many seconds without a connection or a message"));
  CLI::App* const hz = add("hz", TopicsText::tr("Measure the rates of topics and how regular they are"));
  hz->add_option("topics", words.topics, help(TopicsText::tr("Topics, as the robot names them")))->required();
  hz->add_option("--seconds", words.seconds, help(TopicsText::tr("For how many seconds to measure")))
      ->capture_default_str();
  addTimeout(*hz, words.timeout_s, TopicsText::tr("Give up connecting after this many seconds"));
}

}  // namespace mapwright::app
