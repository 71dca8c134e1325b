// `mapwright slam …`: what SLAM made of what the robot saw (docs/command-line.md).
#include <CLI/CLI.hpp>

#include "app/command_text.h"
#include "app/commands.h"

namespace mapwright::app {

void addSlam(Commands& commands) {
  CLI::App* const slam =
      commands.program().add_subcommand("slam", help(Text::tr("Whether a map made of submaps is good")));
  slam->require_subcommand(1);
  addSlamGraph(commands, *slam);
  addSlamDrop(commands, *slam);
  addSlamAgreement(commands, *slam);
}

}  // namespace mapwright::app
