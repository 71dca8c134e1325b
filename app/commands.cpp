#include "app/commands.h"

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/option_words.h"

namespace mapwright::app {
namespace {

class CommandsText {
  Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

}  // namespace

void inherit(std::string& robot, AccessWords& access, const Invocation& before) {
  if (robot.empty()) robot = before.robot;
  access = withOuter(access, robot, before.access, before.robot);
}

std::optional<int> Commands::run(const Invocation& before) const {
  for (const auto& [command, run] : runs_) {
    if (command->parsed()) return run(before);
  }
  return std::nullopt;
}

// No envname(): the variable would also be read for subcommands that were not given, and override what was
// typed. It is handled by the option before the subcommand.
void addRobot(CLI::App& command, std::string& robot, AccessWords& access, const QString& about) {
  command.add_option("--robot", robot, help(about));
  addAccess(command, access);
}

void addAccess(CLI::App& command, AccessWords& access) {
  command.add_option(
      "--secret-file", access.secret_file,
      help(CommandsText::tr("File with the secret for the robot of --robot (or MAPWRIGHT_SECRET)")));
  command
      .add_option(
          "--secret-file-for", access.secret_files_for,
          help(CommandsText::tr("Address of another robot, and the file with its secret; may be repeated")))
      ->type_name("ADDRESS FILE")
      ->allow_extra_args(false);
  command.add_option("--ca-file", access.ca_file,
                     help(CommandsText::tr("PEM file with certificate authorities (or self-signed "
                                           "certificates) to trust in addition to the system's")));
}

void addTimeout(CLI::App& command, double& timeout_s, const QString& about) {
  const QString usual = CommandsText::tr("Give up waiting after this many seconds");
  command.add_option("--timeout", timeout_s, help(about.isEmpty() ? usual : about))->capture_default_str();
}

void addReport(CLI::App& command, std::string& path) {
  command.add_option("--report", path, help(CommandsText::tr("Write a summary and all warnings as JSON")));
}

void addJson(CLI::App& command, bool& json) {
  command.add_flag("--json", json, help(CommandsText::tr("Print JSON")));
}

}  // namespace mapwright::app
