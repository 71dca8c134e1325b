#include "app/suite_drawing.h"

#include <algorithm>
#include <chrono>

#include <CLI/CLI.hpp>
#include <QCoreApplication>
#include <QDir>
#include <QEventLoop>
#include <QFileInfo>
#include <QRegularExpression>

#include "app/command_text.h"
#include "app/report.h"
#include "app/robot_factory.h"
#include "app/suite_quality.h"
#include "app/wrong_words.h"
#include "replay/replay_robot.h"
#include "words/listed.h"
#include "words/text.h"
#include "work/budgets.h"

namespace mapwright::app {
namespace {

using words::text;

/// `snapshot` itself reads the options of a view.
struct ViewParser {
  SnapshotArguments args;
  CLI::App cli;
  ViewParser() {
    addSnapshotOptions(&cli, args);
    addSnapshotBag(&cli, args);
    refuseOddWords(cli);
  }
};

/// A path that is written relative to the suite; anything else stays.
QString placed(const QString& written, const QString& folder) {
  const QString prefix = QStringLiteral("file:");
  const bool named_file = written.startsWith(prefix);
  const QString path = named_file ? written.mid(prefix.size()) : written;
  const QString plain = path.section(QLatin1Char('?'), 0, 0);
  if (path.contains(QLatin1String("://")) || path.startsWith(QLatin1Char('/')) ||
      path.startsWith(QLatin1String("~/")) || path.startsWith(QLatin1String("demo:")))
    return written;
  const QString there = QDir(folder).absoluteFilePath(path);
  if (!named_file && !isFileName(path) && !isMapFile(plain) &&
      !QFileInfo::exists(there.section(QLatin1Char('?'), 0, 0)))
    return written;
  return prefix + QDir::cleanPath(there);
}

/// The file that this address opens as a recording; empty: none.
QString recordingIn(const QString& address) {
  const QString prefix = QStringLiteral("file:");
  const QString named = address.startsWith(prefix) ? address.mid(prefix.size()) : address;
  const QString path = named.section(QLatin1Char('?'), 0, 0);
  const bool file = !path.isEmpty() && !path.contains(QLatin1String("://")) && QFileInfo(path).isFile();
  return file && isRecording(path) ? QFileInfo(path).absoluteFilePath() : QString();
}

/// A bag may be a file, too.
QString placedBag(const QString& written, const QString& folder) {
  const QString there = QDir(folder).absoluteFilePath(written);
  return QFileInfo(there).isFile() ? there : written;
}

}  // namespace

suite::KnownOptions viewOptions() {
  ViewParser parser;
  suite::KnownOptions known;
  for (const CLI::Option* const option : std::as_const(parser.cli).get_options()) {
    const std::string name = option->get_lnames().empty() ? std::string() : option->get_lnames().front();
    const auto is = [&name](auto... other) { return ((name == other) || ...); };
    if (name.empty() ||
        is("output", "report", "json", "force", "secret-file", "secret-file-for", "ca-file", "help"))
      continue;
    (option->get_items_expected_max() == 0 ? known.switches : known.values).insert(name);
  }
  return known;
}

tl::expected<SnapshotOptions, QString> snapshotOptionsOf(const suite::View& view, const QString& folder,
                                                         const std::string& robot, const QString& output) {
  ViewParser parser;
  std::vector<std::string> typed{"--output=" + output.toStdString()};
  for (const suite::ViewOption& option : view.options)
    typed.push_back("--" + option.name + (option.is_switch ? std::string() : "=" + option.value));
  std::reverse(typed.begin(), typed.end());  // as CLI11 takes them
  const auto wrong_view = [&view](const QString& sentence) {
    static const QRegularExpression option_named(QStringLiteral("--([a-z-]*[a-z])"));
    const QString first = option_named.match(sentence).captured(1);
    suite::Position at = view.at;
    for (const suite::ViewOption& option : view.options) {
      if (text(option.name) == first) at = option.at;
    }
    return tl::make_unexpected(suite::atPosition(at, words::about(view.name, sentence)));
  };
  try {
    parser.cli.parse(std::move(typed));
  } catch (const CLI::ParseError& error) {
    return wrong_view(sentenceOf(error));
  }
  SnapshotArguments& args = parser.args;
  if (!args.robot.empty()) args.robot = placed(text(args.robot), folder).toStdString();
  if (args.robot.empty() && args.bag.empty()) args.robot = robot;
  // A recording is named by its robot, or as a bag.
  if (const QString recording = recordingIn(text(args.robot)); args.bag.empty() && !recording.isEmpty()) {
    if (args.at.empty())
      return wrong_view(Text::tr("A view of a recording needs \"at\", the time in it: %1.").arg(recording));
    args.bag = recording.toStdString();
    args.robot.clear();
  }
  if (!args.bag.empty()) {
    args.bag = placedBag(text(args.bag), folder).toStdString();
    onRecording(args.robot, args.bag, robot);
  }
  if (args.robot.empty()) args.robot = robot;
  if (args.robot.empty()) return wrong_view(Text::tr("It names no robot, and neither does --robot."));
  auto options = parseSnapshotOptions(args);
  if (!options) return wrong_view(options.error());
  options->quality = view.quality;
  return std::move(*options);
}

void drawViews(const std::vector<SnapshotOptions>& views, const RobotAccess& access, int jobs,
               const std::function<void(std::size_t view, const DrawnView& drawn)>& done) {
  const auto workers = std::make_shared<work::Workers>();
  const auto dense = std::make_shared<render::DenseCache>(work::budgetsFrom().dense);
  QEventLoop loop;
  std::size_t next = 0;
  int under_way = 0;
  std::function<void()> go_on;
  const auto start = [&](std::size_t view) {
    const SnapshotOptions& options = views[view];
    auto robot = makeRobot(options.robot, access.forAddress(options.robot), DemoTime::Frozen);
    if (!robot) return done(view, {kUsage, robot.error(), 0, nullptr});
    if (!options.bag.empty()) *robot = std::make_unique<replay::ReplayRobot>(std::move(*robot), options.bag);
    const auto begun = std::chrono::steady_clock::now();
    auto* const run = new SnapshotRun(options, std::move(*robot), {begun, {}}, workers);
    ++under_way;
    QObject::connect(
        run, &SnapshotRun::finished, &loop,
        [&, view, run, begun](int code) {
          const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
          const QString sentence =
              !run->error().isEmpty()
                  ? run->error()
                  : Text::tr("Incomplete. %1").arg(run->warnings().join(QLatin1Char(' ')));
          const auto end = [&, view, run, code, sentence, seconds = took.count()](suite::Examined examined) {
            done(view, {code, code == kDone ? QString() : sentence, seconds, run, std::move(examined)});
            run->deleteLater();
            --under_way;
            go_on();
          };
          if (code != kDone) return end({});
          examine(run->options().quality, run->session(), {workers, dense, run->options().timeout_s}, &loop,
                  end);
        },
        Qt::QueuedConnection);
    run->start();
  };
  go_on = [&] {
    while (under_way < jobs && next < views.size()) start(next++);
    if (under_way == 0) loop.quit();
  };
  QMetaObject::invokeMethod(
      &loop, [&] { go_on(); }, Qt::QueuedConnection);
  loop.exec();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // the last ones
}

}  // namespace mapwright::app
