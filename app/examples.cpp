#include "app/examples.h"

#include <map>
#include <sstream>
#include <string>

#include <CLI/CLI.hpp>

#include "app/command_text.h"
#include "app/commands.h"

namespace mapwright::app {
namespace {

/// Each stands under the command that it calls.
constexpr const char* kExamples[] = {
    "mapwright --robot axbot+http://192.168.25.25:8090",
    "mapwright office.yaml",
    "mapwright demo scene=warehouse",
    "mapwright play morning.mcap",
    "mapwright simulate --port 8090 --scene warehouse",
    "mapwright snapshot --robot demo: -o map.png",
    "mapwright snapshot --robot demo: --center 10,5 --scale 0.02 --layers all -o near.png",
    "mapwright compare before.png after.png --diff what.png",
    "mapwright suite run suite.yaml --expected expected --report report",
    "mapwright suite accept suite.yaml --expected expected",
    "mapwright suite list suite.yaml --expected expected",
    "mapwright maps list --robot demo:",
    "mapwright maps current --robot demo:",
    "mapwright maps show --robot office.yaml",
    "mapwright maps export 12 --robot 10.0.0.7 -o office.yaml",
    "mapwright maps export --robot rep130+ws://10.0.0.8 --region 10,-5,40,30 -o part.yaml",
    "mapwright maps diff before.yaml after.yaml --diff changes.png",
    "mapwright maps diff 12 office.yaml --robot 10.0.0.7 --json",
    "mapwright maps align before.yaml after.yaml --pair 3.2,1.5:10.4,-2.2",
    "mapwright maps rehearse after.yaml monday.mcap tuesday.csv --from before.yaml",
    "mapwright maps rename 12 \"Ground floor\" --robot 10.0.0.7",
    "mapwright maps load 12 --robot 10.0.0.7",
    "mapwright maps archive 12 --robot kabam+ws://10.0.0.8",
    "mapwright maps unarchive 12 --robot kabam+ws://10.0.0.8",
    "mapwright maps delete 12 --robot 10.0.0.7 --yes",
    "mapwright maps start-mapping --robot 10.0.0.7",
    "mapwright maps stop-mapping --robot 10.0.0.7",
    "mapwright maps save \"Ground floor\" --robot 10.0.0.7",
    "mapwright maps set-pose --at 1.5,-2,90 --robot 10.0.0.7",
    "mapwright maps locate --robot 10.0.0.7",
    "mapwright maps download 12 --robot 10.0.0.7 -o office",
    "mapwright maps upload office --robot 10.0.0.9 --name Office",
    "mapwright maps create Office --image office.png --resolution 0.05 --origin -10,-5 --robot 10.0.0.7",
    "mapwright maps set-image 3 office.pgm --robot kabam+ws://10.0.0.8",
    "mapwright maps save-on-robot building.png --robot rep130+ws://10.0.0.8",
    "mapwright projections list --robot rep130+ws://10.0.0.8",
    "mapwright projections set --projection 0,0,50,50,0,2 --robot rep130+ws://10.0.0.8",
    "mapwright waypoints list --robot office.yaml --warnings",
    "mapwright waypoints get \"Dock 2\" --robot office.yaml",
    "mapwright waypoints create \"Dock 2\" --at 3.4,-1.25,90 --robot office.yaml",
    "mapwright waypoints rename \"Dock 2\" \"Dock north\" --robot office.yaml",
    "mapwright waypoints move \"Dock 2\" --at 3.4,-1.25 --robot office.yaml --dry-run",
    "mapwright waypoints tag \"Dock 2\" --add charger --robot office.yaml",
    "mapwright waypoints delete \"Dock 2\" --robot office.yaml --yes",
    "mapwright waypoints import places.csv --robot office.yaml",
    "mapwright waypoints export --robot office.yaml -o places.csv",
    "mapwright waypoints plan places.csv --robot kabam+ws://10.0.0.8 -o plan.json",
    "mapwright waypoints apply plan.json --robot kabam+ws://10.0.0.8",
    "mapwright waypoints carry --from before.yaml --to after.yaml -o carried.geojson",
    "mapwright overlays get --robot 10.0.0.7 -o base.geojson",
    "mapwright overlays set mine.geojson --base base.geojson --robot 10.0.0.7",
    "mapwright overlays plan mine.geojson --base base.geojson --robot 10.0.0.7",
    "mapwright overlays validate mine.geojson --robot 10.0.0.7",
    "mapwright overlays carry --from 12 --to 15 --robot 10.0.0.7 -o carried.geojson",
    "mapwright overlays history list --robot 10.0.0.7",
    "mapwright overlays history show 7 -o earlier.geojson",
    "mapwright overlays history restore 7 --robot 10.0.0.7 --dry-run",
    "mapwright bags list --robot 10.0.0.7",
    "mapwright bags info morning.mcap",
    "mapwright bags frames morning.mcap --topic /alerts --from +1:00",
    "mapwright bags state morning.mcap --at 14:36:17",
    "mapwright bags events morning.mcap --kind alerts,stops",
    "mapwright bags report morning.mcap --at 14:36:17 --against yesterday.mcap -o incident.html",
    "mapwright bags download 2024-06-03_09-00-00.bag --robot 10.0.0.7",
    "mapwright bags export morning.mcap --from +1:00 --to -10 -o part.mcap",
    "mapwright bags track morning.mcap -o way.csv",
    "mapwright bags repair broken.mcap -o whole.mcap",
    "mapwright bags split morning.mcap --every 300 -o part-%03d.mcap",
    "mapwright bags merge part-000.mcap part-001.mcap -o whole.mcap",
    "mapwright bags delete 2024-06-03_09-00-00.bag --robot 10.0.0.7 --yes",
    "mapwright bags record --robot 10.0.0.7 --duration 90s",
    "mapwright bags snapshot morning.mcap --at +1:30 -o then.png",
    "mapwright bags film morning.mcap --from 14:30 --to 14:40 -o film.mp4",
    "mapwright record --robot 10.0.0.7 -o morning.mcap --duration 10m",
    "mapwright clouds export --robot rep130+ws://10.0.0.8 --box 0,0,1,20,20,2 -o hall.pcd",
    "mapwright slam info --robot office.pbstream",
    "mapwright slam closures --robot office.pbstream --top 10 --fail-over 0.5",
    "mapwright slam drop --robot office.pbstream --closure 0-4:0-512 -o mended.pbstream",
    "mapwright slam disagreement --robot demo: -o contradictions.png",
    "mapwright slam disagreement --robot axbot+http://10.0.0.7 --fail-over 0.05 --json",
    "mapwright slam coverage --robot demo: -o coverage.png",
    "mapwright topics list --robot ros+ws://10.0.0.8",
    "mapwright topics echo /odom --robot ros+ws://10.0.0.8 --count 1",
    "mapwright topics hz /scan /odom --robot ros+ws://10.0.0.8",
    "mapwright probe 192.168.25.25 --details",
};

}  // namespace

void addExamples(CLI::App& program) {
  std::map<CLI::App*, std::string> lines;
  for (const char* const example : kExamples) {
    std::istringstream words(example);
    CLI::App* command = &program;
    std::string word;
    words >> word;  // mapwright
    while (words >> word) {
      const auto called = command->get_subcommands([&](CLI::App* sub) { return sub->get_name() == word; });
      if (called.empty()) break;
      command = called.front();
    }
    lines[command] += std::string("\n  ") + example;
  }
  const std::string one = help(Text::tr("Example:")), several = help(Text::tr("Examples:"));
  for (const auto& [command, text] : lines)
    command->footer((text.find('\n', 1) == text.npos ? one : several) + text);
}

}  // namespace mapwright::app
