#include "app/commands.h"

#include <charconv>
#include <cmath>
#include <map>

#include <CLI/CLI.hpp>
#include <QFileInfo>

#include "app/command_text.h"
#include "app/output.h"
#include "app/robot_factory.h"
#include "jobs/export_map.h"

namespace mapwright::app {

void inherit(RobotArguments& args, const Invocation& before) {
  if (args.robot.empty()) args.robot = before.robot;
  AccessArguments& access = args.access;
  const AccessArguments& outer = before.access;
  if (!outer.secret_file.empty()) {
    if (!before.robot.empty() && before.robot != args.robot) {
      access.secret_files_for.emplace_back(before.robot, outer.secret_file);
    } else if (access.secret_file.empty()) {
      access.secret_file = outer.secret_file;
    }
  }
  access.secret_files_for.insert(access.secret_files_for.end(), outer.secret_files_for.begin(),
                                 outer.secret_files_for.end());
  if (access.ca_file.empty()) access.ca_file = outer.ca_file;
}

namespace {

/// A sentence if --report is a file that the command was given to read.
std::optional<QString> noReportThereReason(const CLI::App& command) {
  const CLI::Option* const report = command.get_option_no_throw("--report");
  if (!report || report->empty()) return std::nullopt;
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options()) {
    if (option != report && option->get_name() != "--output" && option->get_name() != "--diff")
      words.insert(words.end(), option->results().begin(), option->results().end());
  }
  // Also the picture, waypoints and overlays of a map, which nobody types.
  const QString path = QString::fromStdString(report->results().back());
  for (std::size_t i = 0, typed = words.size(); i < typed; ++i) {
    const QString word = QString::fromStdString(words[i]);
    if (!QFileInfo(word).isFile()) continue;
    for (std::string& file : sourceFilesOf(word, {}, {})) words.push_back(std::move(file));
  }
  for (const QString& yaml : yamlsNaming(path)) {
    if (!jobs::firstOwnSource({yaml}, words).isEmpty()) words.push_back(path.toStdString());
  }
  return reportOverSource(path, words);
}

}  // namespace

std::optional<int> Commands::run(const Invocation& before) const {
  for (const auto& [command, run] : runs_) {
    if (!command->parsed()) continue;
    if (const auto why = noReportThereReason(*command)) return refuse(kUsage, *why);
    return run(before);
  }
  return std::nullopt;
}

// No envname(): the variable would also be read for subcommands that were not given, and override what was
// typed. It is handled by the option before the subcommand.
void addRobot(CLI::App& command, RobotArguments& args, const QString& about) {
  command.add_option("--robot", args.robot, help(about));
  addAccess(command, args.access);
}

void addAccess(CLI::App& command, AccessArguments& access) {
  command.add_option("--secret-file", access.secret_file,
                     help(Text::tr("File with the secret for the robot of --robot (or MAPWRIGHT_SECRET)")));
  command
      .add_option("--secret-file-for", access.secret_files_for,
                  help(Text::tr("Address of another robot, and the file with its secret; may be repeated")))
      ->type_name("ADDRESS FILE")
      ->allow_extra_args(false);
  command.add_option("--ca-file", access.ca_file,
                     help(Text::tr("PEM file with certificate authorities (or self-signed "
                                   "certificates) to trust in addition to the system's")));
}

void addTimeout(CLI::App& command, double& timeout_s, const QString& about) {
  const QString usual = Text::tr("Timeout in seconds");
  command.add_option("--timeout", timeout_s, help(about.isEmpty() ? usual : about))->capture_default_str();
}

void addReport(CLI::App& command, std::string& path) {
  command.add_option("--report", path, help(Text::tr("Write a summary and all warnings as JSON")));
}

void addForce(CLI::App& command, bool& force) {
  command.add_flag("--force", force, help(Text::tr("Replace an existing file")));
}

void addJson(CLI::App& command, bool& json) {
  command.add_flag("--json", json, help(Text::tr("Print JSON")));
}

std::optional<QString> noTimeoutReason(double timeout_s) {
  if (timeout_s > 0 && timeout_s <= 86'400) return std::nullopt;
  return Text::tr("--timeout must be greater than 0 and at most 86400 seconds.");
}

bool isDecimal(const std::string& word) {
  const char* first = word.data();
  const char* const last = first + word.size();
  if (first != last && (*first == '+' || *first == '-')) ++first;
  if (first == last || !(*first == '.' || (*first >= '0' && *first <= '9'))) return false;  // "inf", "nan"
  double number = 0;
  const auto [end, error] = std::from_chars(first, last, number);
  return end == last && error != std::errc::invalid_argument;
}

std::optional<std::vector<double>> numbersFrom(const std::string& typed) {
  constexpr double kMost = 1e9;
  std::vector<double> numbers;
  for (const QString& part : QString::fromStdString(typed).split(QLatin1Char(','))) {
    const QString word = part.trimmed();
    const double number = word.toDouble();
    if (!isDecimal(word.toStdString()) || !(std::abs(number) <= kMost)) return std::nullopt;
    numbers.push_back(number);
  }
  return numbers;
}

void nameTypes(CLI::App& app) {
  static const std::map<std::string, const char*> types{
      {"--secret-file", "FILE"}, {"--ca-file", "FILE"}, {"--report", "FILE"},      {"--output", "FILE"},
      {"--diff", "FILE"},        {"--mask", "FILE"},    {"--base", "FILE"},        {"--image", "FILE"},
      {"file", "FILE"},          {"files", "FILE"},     {"suite", "FILE"},         {"expected", "FILE"},
      {"actual", "FILE"},        {"folder", "DIR"},     {"--resolution", "FLOAT"}, {"--radius", "FLOAT"},
      {"number", "INT"}};
  for (CLI::Option* option : app.get_options()) {
    const auto type = types.find(option->get_name());
    if (type != types.end() && option->get_type_name() == "TEXT") option->type_name(type->second);
  }
  for (CLI::App* command : app.get_subcommands({})) nameTypes(*command);
}

void refuseOddWords(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_items_expected_max() == 0) continue;  // a flag
    const std::string type = option->get_type_name();
    const bool number = type.starts_with("FLOAT") || type.starts_with("INT") || type.starts_with("UINT") ||
                        type == "DURATION";
    option->check([number](const std::string& word) {
      if (word.empty()) return Text::tr("the value is empty").toStdString();
      if (!number || isDecimal(word)) return std::string();
      return Text::tr("\"%1\" is not a number").arg(QString::fromStdString(word)).toStdString();
    });
  }
  for (CLI::App* command : app.get_subcommands({})) refuseOddWords(*command);
}

CLI::App* addRobotCommand(CLI::App& parent, const char* name, const QString& about, const QString& robots,
                          RobotArguments& args) {
  CLI::App* const command = parent.add_subcommand(name, help(about));
  addRobot(*command, args, robots);
  addTimeout(*command, args.timeout_s);
  addReport(*command, args.report);
  return command;
}

}  // namespace mapwright::app
