#include "app/command_line.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/bench_program.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/log.h"
#include "app/option_words.h"
#include "app/output_paths.h"
#include "app/recording_operand.h"
#include "app/window.h"
#include "app/xdg.h"
#include "words/plain.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

class CommandLineText {
  Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

int runCommand(int argc, char** argv) {
  std::string robot, demo_query, operand, log_rules;
  AccessWords access;
  CLI::App cli(
      help(CommandLineText::tr(
          "mapwright: look at the maps of mobile robots. Without a subcommand it opens the window.")),
      "mapwright");
  cli.set_version_flag("--version", std::string("mapwright ") + MAPWRIGHT_VERSION);
  cli.set_help_all_flag("--help-all", help(CommandLineText::tr("Help for all subcommands")));
  cli.require_subcommand(0, 1);
  cli.add_option(
         "--robot", robot,
         help(CommandLineText::tr("Connect the window to this robot, for example "
                                  "axbot+http://192.168.25.25:8090; aimdk+http://HOST?tf=ws://HOST:9090 "
                                  "names an Agibot robot and the rosbridge that provides its pose")))
      ->envname("MAPWRIGHT_ROBOT");
  addAccess(cli, access);
  CLI::App* demo =
      cli.add_subcommand("demo", help(CommandLineText::tr("Open the window with a simulated robot")));
  demo->add_option("query", demo_query,
                   help(CommandLineText::tr("For example scene=warehouse&submaps=500&seed=3")));
  cli.add_option("file", operand,
                 help(CommandLineText::tr("A map or a recording (MCAP or ROS 1 bag) to open")));
  CLI::App* play = cli.add_subcommand("play", help(CommandLineText::tr("Open the window with a recording")));
  play->add_option("file", operand, help(CommandLineText::tr("MCAP or ROS 1 bag")))->required();
  Commands commands(cli);
  for (const auto add : {addSimulate, addSnapshot, addMaps, addProjections, addWaypoints, addBags, addRecord,
                         addClouds, addTopics})
    add(commands);
  addLog(cli, log_rules);
  CLI::App* bench = cli.add_subcommand(
      "bench", help(CommandLineText::tr(
                   "Run the benchmarks, which compare mapwright with other ways of doing the same")));
  bench->prefix_command();
  bench->footer(help(CommandLineText::tr(
      "Everything after bench goes to Google Benchmark, for example --benchmark_filter=Compose")));
  bench->set_help_flag();

  refuseOddWords(cli);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return cli.exit(error);
    const QString why = QString::fromStdString(words::plainLine(std::string_view(error.what())));
    std::fprintf(stderr, "%s\n", qUtf8Printable(CommandLineText::tr("%1 (see mapwright --help)").arg(why)));
    return kUsage;
  }
  if (const auto started = startLog(log_rules); !started) {
    std::fprintf(stderr, "%s\n", qUtf8Printable(words::plainLine(started.error())));
    return kUsage;
  }
  if (const auto code = commands.run({robot, access, argc, argv})) return *code;
  if (bench->parsed()) return app::bench(bench->remaining());
  if (demo->parsed()) return app::demo(QString::fromStdString(demo_query), argc, argv);
  if (operand.empty()) return window(QString::fromStdString(robot), access, argc, argv);
  const QString file = QString::fromStdString(operand);
  // A mistyped subcommand is not a file.
  if (!isFileName(file) && !play->parsed()) {
    std::fprintf(stderr, "%s\n",
                 qUtf8Printable(CommandLineText::tr(
                                    "%1 is neither a subcommand nor an existing file (see mapwright --help)")
                                    .arg(words::plainName(file))));
    return kUsage;
  }
  return window(file, access, argc, argv);
}

}  // namespace

int commandLine(int argc, char** argv) {
  // A write error is reported as a sentence; it must not end the program.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  ignoreRelativeFolders();
  try {
    return concludeStandardOutput(runCommand(argc, argv));
  } catch (const std::exception& error) {
    const QString why = QString::fromStdString(words::plainLine(std::string_view(error.what())));
    std::fprintf(stderr, "%s\n", qUtf8Printable(CommandLineText::tr("mapwright had to stop: %1").arg(why)));
    return kRobotError;
  }
}

}  // namespace mapwright::app
