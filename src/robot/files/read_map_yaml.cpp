#include "robot/files/read_map_yaml.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <yaml-cpp/yaml.h>

namespace mapwright::robot::files {
namespace {

auto refused(std::string sentence) { return tl::make_unexpected(std::move(sentence)); }

std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// The number of a scalar, also NaN and infinity in YAML's spelling and C's; nullopt for anything else.
std::optional<double> numberOf(const YAML::Node& node) {
  if (!node.IsScalar()) return std::nullopt;
  std::string text = lower(node.Scalar());
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.erase(0, 1);
  if (text.starts_with(".") && text.size() == 4 && !std::isdigit(static_cast<unsigned char>(text[1]))) {
    text.erase(0, 1);  // .nan, .inf
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return negative ? -value : value;
}

/// What is wrong with the origin, or nothing.
std::optional<std::string> readOrigin(const YAML::Node& node, MapYaml& yaml) {
  if (!node) return "It has no origin, so the map cannot be placed. Add for example: origin: [0.0, 0.0, 0.0]";
  if (!node.IsSequence() || node.size() < 2) return "Its origin is not a list of x, y and yaw.";
  const auto x = numberOf(node[0]), y = numberOf(node[1]);
  if (!x || !y) return "Its origin holds something that is not a number.";
  double yaw = 0;
  if (node.size() >= 3) {
    const auto given = numberOf(node[2]);
    if (given && std::isfinite(*given)) {
      yaw = *given;
    } else {
      yaml.notes.push_back("The yaw of its origin is not a number. It is taken as 0.");
    }
  }
  yaml.grid.origin = {*x, *y, yaw};
  return std::nullopt;
}

std::optional<std::string> readNegate(const YAML::Node& node, MapYaml& yaml) {
  if (!node) return std::nullopt;
  const std::string text = node.IsScalar() ? lower(node.Scalar()) : std::string();
  if (text == "1" || text == "true" || text == "yes" || text == "on") {
    yaml.reading.negate = true;
  } else if (text != "0" && text != "false" && text != "no" && text != "off") {
    return "Its negate is neither 0 nor 1.";
  }
  return std::nullopt;
}

std::optional<std::string> readThreshold(const YAML::Node& node, const char* name, double& threshold,
                                         MapYaml& yaml) {
  if (!node) {
    yaml.notes.push_back(std::string("It has no ") + name + ". " + std::to_string(threshold).substr(0, 5) +
                         " is assumed.");
    return std::nullopt;
  }
  const auto value = numberOf(node);
  if (!value || !(*value >= 0 && *value <= 1)) {
    return std::string("Its ") + name + " is not a number from 0 to 1.";
  }
  threshold = *value;
  return std::nullopt;
}

std::optional<std::string> readMode(const YAML::Node& node, MapYaml& yaml) {
  const std::string mode = !node ? "trinary" : node.IsScalar() ? lower(node.Scalar()) : std::string();
  if (mode == "trinary") {
    yaml.reading.mode = map::CellReading::Mode::Trinary;
  } else if (mode == "scale") {
    yaml.reading.mode = map::CellReading::Mode::Scale;
  } else if (mode == "raw") {
    yaml.reading.mode = map::CellReading::Mode::Raw;
  } else {
    return "Its mode is not known. It must be trinary, scale or raw.";
  }
  return std::nullopt;
}

std::optional<std::string> readAll(const YAML::Node& root, MapYaml& yaml) {
  const YAML::Node image = root["image"];
  if (!image || !image.IsScalar() || image.Scalar().empty()) return "It names no image.";
  yaml.image = image.Scalar();
  const YAML::Node resolution = root["resolution"];
  if (!resolution)
    return "It has no resolution, so the map cannot be placed. Add for example: resolution: 0.05";
  const auto metres = numberOf(resolution);
  if (!metres) return "Its resolution is not a number, so it cannot be placed.";
  yaml.grid.resolution_m = *metres;
  if (auto why = readOrigin(root["origin"], yaml)) return why;
  if (auto why = map::whyUnusable(yaml.grid)) return why;
  if (auto why = readNegate(root["negate"], yaml)) return why;
  if (auto why = readMode(root["mode"], yaml)) return why;
  if (yaml.reading.mode == map::CellReading::Mode::Raw) return std::nullopt;
  if (auto why =
          readThreshold(root["occupied_thresh"], "occupied_thresh", yaml.reading.occupied_thresh, yaml))
    return why;
  if (auto why = readThreshold(root["free_thresh"], "free_thresh", yaml.reading.free_thresh, yaml))
    return why;
  if (yaml.reading.free_thresh >= yaml.reading.occupied_thresh) {
    yaml.notes.push_back("Its free_thresh is not below its occupied_thresh, so no cell can be unknown.");
  }
  return std::nullopt;
}

}  // namespace

tl::expected<MapYaml, std::string> parseMapYaml(const std::string& text) {
  if (text.size() > kMaxYamlBytes) return refused("It is too long to be a map.yaml.");
  MapYaml yaml;
  try {
    const YAML::Node root = YAML::Load(text);
    if (!root.IsMap()) return refused("It is not a map.yaml: it names no image, resolution and origin.");
    if (auto why = readAll(root, yaml)) return refused(std::move(*why));
  } catch (const YAML::Exception& broken) {
    return refused("It is not YAML (line " + std::to_string(broken.mark.line + 1) + ").");
  }
  return yaml;
}

}  // namespace mapwright::robot::files
