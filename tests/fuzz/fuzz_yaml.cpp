// Suites of views and the map.yaml of map_server.
#include "robot/files/read_map_yaml.h"
#include "suite/read_suite.h"
#include "target.h"
#include "yaml/read_yaml.h"

namespace mapwright::fuzz::yaml {
namespace {

void read(Input input) {
  static const suite::KnownOptions known{
      {"robot", "map", "bag", "at", "size", "layers", "mode", "center", "scale", "region"},
      {"robot-anyway", "no-robot"}};
  const std::string text = textOf(input);
  use(mapwright::yaml::readYaml(text));
  use(suite::readSuite(text, known));
  use(robot::files::parseMapYaml(text));
}

}  // namespace
}  // namespace mapwright::fuzz::yaml

MAPWRIGHT_FUZZ_TARGET(yaml)
