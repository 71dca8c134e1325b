#include "app/access_words.h"

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/option_words.h"

namespace mapwright::app {
namespace {

class AccessOptionText {
  Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

}  // namespace

void addAccess(CLI::App& command, AccessWords& words) {
  command.add_option(
      "--secret-file", words.secret_file,
      help(AccessOptionText::tr("File that holds the secret of the robot of --robot (or MAPWRIGHT_SECRET)")));
  command
      .add_option("--secret-file-for", words.secret_files_for,
                  help(AccessOptionText::tr(
                      "Address of another robot, and the file that holds its secret; may be repeated")))
      ->type_name("ADDRESS FILE")
      ->allow_extra_args(false);
  command.add_option(
      "--ca-file", words.ca_file,
      help(AccessOptionText::tr(
          "PEM file of certificate authorities (or self-signed certificates) to believe besides "
          "those of this computer")));
}

}  // namespace mapwright::app
