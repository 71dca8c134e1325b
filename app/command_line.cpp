#include "app/command_line.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <filesystem>
#include <string>
#include <system_error>
#include <unistd.h>
#include <vector>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QFileInfo>
#include <QLocale>
#include <QStandardPaths>

#include "app/command_text.h"
#include "app/commands.h"
#include "app/crash_report.h"
#include "app/display.h"
#include "app/examples.h"
#include "app/kept_overlays.h"
#include "app/language.h"
#include "app/log.h"
#include "app/output.h"
#include "app/robot_factory.h"
#include "app/settings_file.h"
#include "app/snapshot.h"
#include "app/unknown_word.h"
#include "app/wrong_words.h"
#include "disk/private_folder.h"
#include "keyring/key_ring.h"
#include "replay/replay_robot.h"
#include "robot/address.h"
#include "robot/second_server.h"
#include "sentences/language.h"
#include "ui/robot/recent_robots.h"
#include "ui/view/replay_state.h"
#include "ui/window/language_setting.h"
#include "ui/window/made_of.h"
#include "ui/window/main_window.h"
#include "ui/window/watched_application.h"
#include "ui/window/work_settings.h"
#include "words/plain.h"
#include "words/qt_plain.h"
#include "work/workers.h"

namespace mapwright::app {
namespace {

/// Replaces this process with mapwright-bench from the same folder; returns an exit code only if it is
/// missing.
int benchmarks(const std::vector<std::string>& arguments) {
  std::error_code unknown;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", unknown);
  std::vector<std::string> args{(self.parent_path() / "mapwright-bench").string()};
  args.insert(args.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : args) argv.push_back(word.data());
  argv.push_back(nullptr);
  ::execv(argv[0], argv.data());
  const int error = errno;
  const QString program = QString::fromStdString(words::plainLine(std::string_view(args[0])));
  const QString why =
      error == ENOENT
          ? Text::tr(
                "The benchmarks are a separate program that is built on demand, and there is "
                "no %1. Run \"./run bench\" in mapwright's source tree.")
                .arg(program)
          : Text::tr("%1 cannot be started: %2.").arg(program, QString::fromLocal8Bit(std::strerror(error)));
  return refuse(kUsage, why);
}

/// What --language says, if it was given.
using LanguageGiven = std::optional<QString>;

/// Numbers and dates go with the words, unless the system has them in this language anyway.
void speakInWindow(const LanguageGiven& given, const QSettings& settings) {
  const QString wanted = ui::languageIn(settings);
  const QString code =
      given.value_or(sentences::languageCalled(wanted).value_or(sentences::languageOfSystem()));
  if (!addLettersOf(code)) {
    sentences::speak(sentences::languages().front().code);
    return say(
        Text::tr("No font here has Chinese characters, so the window is in English. Install one, such as "
                 "fonts-noto-cjk."));
  }
  sentences::speak(code);
  const bool chosen = given || wanted != ui::kLanguageOfSystem;
  const QLocale locale(code);
  if (chosen && locale.language() != QLocale::system().language()) QLocale::setDefault(locale);
}

int showWindow(const QString& address, const RobotAccess& known, const LanguageGiven& language) {
  const std::unique_ptr<QSettings> settings = openSettings();
  speakInWindow(language, *settings);
  const robot::Addresses addresses = knownAddresses();
  const ui::KeptWorkSettings kept = ui::workSettingsIn(*settings);
  for (const QString& sentence : kept.nonsense) say(sentence);
  ui::MainWindow::Dependencies wanted{
      [&](const QString& to, const QByteArray& typed_secret) {
        Access access = known.forAddress(to);
        if (!typed_secret.isEmpty()) access.secret = typed_secret;
        const ui::TrustedCertificates trusted(*settings);
        const auto parsed = addresses.parse(to);
        if (parsed) access.trust.pinned_sha256 = net::fingerprintFrom(trusted.of(robot::hostOf(*parsed)));
        auto made = makeRobot(to, access, DemoTime::Running);
        robot::SecondServer* const second = made ? robot::secondServerOf(**made) : nullptr;
        const QString beside = second ? trusted.of(second->hostBeside()) : QString();
        if (!beside.isEmpty()) second->trustBeside(beside);
        // A recording is viewed by playing it.
        if (made && parsed && !parsed->path.isEmpty() && isRecording(parsed->path))
          *made = std::make_unique<replay::ReplayRobot>(std::move(*made), bagNameOf(parsed->path),
                                                        ui::followedReading());
        return made;
      },
      *settings, address};
  wanted.session = sessionOptions();
  wanted.yamls_naming = yamlsNaming;
  const QString data_folder =
      QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + QStringLiteral("/mapwright");
  disk::makePrivateFolder(QFile::encodeName(data_folder).toStdString());
  wanted.edit.drafts_folder = data_folder + QStringLiteral("/drafts");
  wanted.addresses = addresses;
  const std::unique_ptr<keyring::KeyRing> keys = keyring::systemKeyRing();
  wanted.keys = keys.get();
  wanted.probes = probesOf;
  wanted.has_secret = [&](const QString& to) { return !known.forAddress(to).secret.isEmpty(); };
  wanted.overlays_history = overlaysHistory();
  wanted.workers = std::make_shared<work::Workers>(kept.settings.threads);
  wanted.budgets = kept.settings.budgets();
  addLabelFont();
  ui::MainWindow main_window(std::move(wanted));
  main_window.show();
  const int exit_code = QApplication::exec();
  settings->sync();
  if (settings->status() != QSettings::NoError) {
    say(Text::tr("The window layout cannot be saved: %1 is not writable.").arg(settings->fileName()));
  }
  return exit_code;
}

/// Opens the window; `address` empty = not connected. Returns the exit code.
int openWindow(const QString& address, const AccessArguments& args, const LanguageGiven& language, int& argc,
               char** argv) {
  chooseWindowPlatform();
  const InPlaceOfSpeaker own;
  ui::WatchedApplication application(argc, argv);
  const auto access = RobotAccess::read(args, address);
  if (!access) return refuse(kUsage, access.error());
  if (!haveDisplay()) {
    return refuse(
        kUsage, Text::tr("There is no display to open the window on. mapwright snapshot works without one."));
  }
  return showWindow(address, *access, language);
}

/// The window on the embedded simulator; without a display it writes mapwright-demo.png and prints its name.
int openDemo(const QString& query, const LanguageGiven& language, int& argc, char** argv) {
  const QString address = query.isEmpty() ? QStringLiteral("demo:") : QStringLiteral("demo:?") + query;
  {
    chooseWindowPlatform();
    const InPlaceOfSpeaker own;
    ui::WatchedApplication application(argc, argv);
    if (haveDisplay()) return showWindow(address, {}, language);
  }
  const QString picture = QStringLiteral("mapwright-demo.png");
  say(Text::tr("There is no display to open the window on. Rendering %1 instead.").arg(picture));
  SnapshotArguments args;
  args.robot = address.toStdString();
  args.output = picture.toStdString();
  return snapshot(args, argc, argv);
}

int runCommand(int argc, char** argv) {
  const auto given = languageTyped(argc, argv);
  if (!given) return refuse(kUsage, given.error());
  const LanguageGiven language = *given;
  if (language) startSpeaking(*language);
  if (const auto why = notUtf8Reason(argc, argv)) return refuse(kUsage, *why);
  std::string robot, demo_query, operand, language_typed;
  LogArguments log;
  bool version = false, version_json = false;
  AccessArguments access;
  CLI::App cli(
      help(Text::tr(
          "mapwright: view and edit the maps of mobile robots. Without a subcommand it opens the window.")),
      "mapwright");
  cli.set_help_flag("-h,--help", help(Text::tr("Print this help message and exit")));
  CLI::Option* const version_flag =
      cli.add_flag("--version", version, help(Text::tr("Print the version and exit")));
  cli.add_flag(
         "--json", version_json,
         help(Text::tr("Print version, commit and libraries with their licences as JSON (with --version)")))
      ->needs(version_flag);
  cli.set_help_all_flag("--help-all", help(Text::tr("Help for all subcommands")));
  cli.require_subcommand(0, 1);
  cli.add_option("--robot", robot,
                 help(Text::tr("Connect the window to this robot, for example "
                               "axbot+http://192.168.25.25:8090; aimdk+http://HOST?tf=ws://HOST:9090 "
                               "names an Agibot robot and the rosbridge that provides its pose")))
      ->envname("MAPWRIGHT_ROBOT");
  addAccess(cli, access);
  CLI::App* demo = cli.add_subcommand("demo", help(Text::tr("Open the window with a simulated robot")));
  demo->add_option("query", demo_query, help(Text::tr("For example scene=warehouse&submaps=500&seed=3")));
  cli.add_option("file", operand,
                 help(Text::tr("A map, a state file (.pbstream) or a recording (MCAP or ROS bag) to open")));
  CLI::App* play = cli.add_subcommand("play", help(Text::tr("Open the window with a recording")));
  play->add_option("file", operand, help(Text::tr("MCAP or ROS bag")))->required();
  Commands commands(cli);
  for (const auto add :
       {addSimulate, addSnapshot, addCompare, addSuite, addMaps, addProjections, addWaypoints, addOverlays,
        addBags, addRecord, addClouds, addSlam, addTopics, addProbe})
    add(commands);
  addLog(cli, log);
  addLanguage(cli, language_typed);
  CLI::App* bench = cli.add_subcommand("bench", help(Text::tr("Run the benchmarks")));
  bench->prefix_command();
  bench->footer(help(
      Text::tr("Everything after bench goes to Google Benchmark, for example --benchmark_filter=Compose")));
  bench->set_help_flag();

  addExamples(cli);
  nameTypes(cli);
  refuseOddWords(cli);
  translateHeadings(cli);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return cli.exit(error);
    // A word that is not known may be the reason why another one is missing.
    if (const auto why = sentenceOnUnknownWord(cli)) return refuse(kUsage, *why);
    return refuse(kUsage, Text::tr("%1 (see %2 --help)").arg(sentenceOf(error), parsedCommand(cli)));
  }
  if (const auto why = noEffectReason(cli)) return refuse(kUsage, *why);
  if (version) {
    if (version_json)
      printJson(ui::versionJson());
    else
      printLine(QStringLiteral("mapwright " MAPWRIGHT_VERSION));
    return kDone;
  }
  if (const auto started = startLog(log); !started) return refuse(kUsage, started.error());
  if (const auto code = commands.run({robot, access, argc, argv})) return *code;
  if (bench->parsed()) return benchmarks(bench->remaining());
  if (demo->parsed()) return openDemo(QString::fromStdString(demo_query), language, argc, argv);
  if (operand.empty()) return openWindow(QString::fromStdString(robot), access, language, argc, argv);
  const QString file = QString::fromStdString(operand);
  if (!play->parsed() && !QFileInfo::exists(file) && file.contains(QLatin1Char(':')) &&
      knownAddresses().parse(file))
    return openWindow(file, access, language, argc, argv);
  if (!isFileName(file) && !play->parsed()) {  // a mistyped subcommand is not a file
    const auto nearest = nearestOf(operand, subcommandsOf(cli));
    const QString hint = nearest ? Text::tr("Did you mean %1?").arg(QString::fromStdString(*nearest))
                                 : Text::tr("See mapwright --help.");
    return refuse(
        kUsage,
        Text::tr("%1 is neither a subcommand nor an existing file. %2").arg(words::plainName(file), hint));
  }
  if (!file.startsWith(QLatin1String("file:")) && !QFileInfo::exists(file) &&
      !QFileInfo::exists(file.section(QLatin1Char('?'), 0, 0))) {
    return refuse(kUsage, Text::tr("%1: there is no such file.").arg(words::plainName(file)));
  }
  return openWindow(file, access, language, argc, argv);
}

}  // namespace

int commandLine(int argc, char** argv) {
  // A write error is reported as a sentence; it must not end the program.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  reportCrashes();
  ignoreRelativeFolders();
  makeOwnFoldersPrivate();
  try {
    return concludeStandardOutput(runCommand(argc, argv));
  } catch (const std::exception& error) {
    const QString why = QString::fromStdString(words::plainLine(std::string_view(error.what())));
    return refuse(kRobotError, Text::tr("mapwright had to stop: %1").arg(why));
  }
}

}  // namespace mapwright::app
