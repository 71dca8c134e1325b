#include "robot/files/read_map_yaml.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <ctime>
#include <map>
#include <optional>
#include <sys/stat.h>

#include "disk/file_error.h"
#include "disk/read_file.h"
#include "map/faults.h"
#include "robot/files/faults.h"
#include "yaml/read_yaml.h"

namespace mapwright::robot::files {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// The number of a scalar, including NaN and infinity in YAML's and C's spelling; nullopt for anything else.
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

/// An origin of more than three numbers, where only one meaning keeps the map flat; nullopt = none does.
std::optional<double> yawOfLong(const std::vector<double>& numbers, const char*& read_as) {
  const auto isNone = [&](std::size_t i) { return std::abs(numbers[i]) < 1e-6; };
  if (numbers.size() == 4 && isNone(2) && isNone(3)) {
    read_as = "x, y, z, yaw";
    return 0;
  }
  if (numbers.size() == 6 && isNone(3) && isNone(4)) {
    read_as = "x, y, z, roll, pitch, yaw";
    return numbers[5];
  }
  if (numbers.size() == 7 && isNone(3) && isNone(4) &&
      std::abs(std::hypot(numbers[5], numbers[6]) - 1) < 1e-3) {
    read_as = "x, y, z, qx, qy, qz, qw";
    return 2 * std::atan2(numbers[5], numbers[6]);
  }
  return std::nullopt;
}

/// What is wrong with the origin, or nothing.
std::optional<Fault> readOrigin(const YAML::Node& node, MapYaml& yaml) {
  constexpr std::size_t kLongest = 7;
  if (!node)
    return faultText(
        "files",
        "It has no origin, so the position of the map is unknown. Add for example: origin: [0.0, 0.0, 0.0]");
  if (!node.IsSequence() || node.size() < 2)
    return faultText("files", "Its origin is not a list of x, y and yaw.");
  if (node.size() > kLongest) return Fault(fault::OriginCount, {std::int64_t(node.size())});
  std::vector<double> numbers;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const auto number = numberOf(node[i]);
    const bool is_yaw = i == 2 && node.size() == 3;
    if (is_yaw && !(number && std::isfinite(*number)))
      yaml.notes.push_back(faultText("files", "The yaw of its origin is not a number; 0 is used."));
    if (!number && !is_yaw) return faultText("files", "Its origin contains something that is not a number.");
    numbers.push_back(is_yaw && !(number && std::isfinite(*number)) ? 0 : *number);
  }
  double yaw = numbers.size() == 3 ? numbers[2] : 0;
  if (numbers.size() == 2)
    yaml.notes.push_back(
        faultText("files", "Its origin has two numbers, but map_server needs three. A yaw of 0 is used."));
  if (numbers.size() > 3) {
    const char* read_as = "";
    const auto turn = yawOfLong(numbers, read_as);
    if (!turn || !std::isfinite(*turn)) return Fault(fault::OriginCount, {std::int64_t(numbers.size())});
    yaw = *turn;
    yaml.notes.push_back(
        {faultText("files", "Its origin has %1 numbers, but map_server takes three. They were read as %2."),
         {std::int64_t(numbers.size()), std::string(read_as)}});
  }
  constexpr double kFullTurn = 6.2832;  // as it is rounded
  if (std::abs(yaw) > kFullTurn)
    yaml.notes.push_back(faultText(
        "files", "The yaw of its origin is more than a full turn. It is read as radians, not degrees."));
  yaml.grid.origin = {numbers[0], numbers[1], yaw};
  return std::nullopt;
}

std::optional<Fault> readNegate(const YAML::Node& node, MapYaml& yaml) {
  if (!node) {
    yaml.notes.push_back(faultText("files", "negate is missing, but map_server needs it; 0 is assumed."));
    return std::nullopt;
  }
  const std::string text = node.IsScalar() ? lower(node.Scalar()) : std::string();
  if (text == "1" || text == "true" || text == "yes" || text == "on") {
    yaml.reading.negate = true;
  } else if (text != "0" && text != "false" && text != "no" && text != "off") {
    return faultText("files", "Its negate is neither 0 nor 1.");
  }
  return std::nullopt;
}

std::optional<Fault> readThreshold(const YAML::Node& node, const char* name, double& threshold,
                                   MapYaml& yaml) {
  if (!node) {
    yaml.notes.push_back({faultText("files", "%1 is missing, but map_server needs it; %2 is assumed."),
                          {name, std::to_string(threshold).substr(0, 5)}});
    return std::nullopt;
  }
  const auto value = numberOf(node);
  if (!value || !(*value >= 0 && *value <= 1)) {
    return Fault(faultText("files", "Its %1 is not a number from 0 to 1."), {name});
  }
  threshold = *value;
  return std::nullopt;
}

std::optional<Fault> readMode(const YAML::Node& node, MapYaml& yaml) {
  const std::string mode = !node ? "trinary" : node.IsScalar() ? lower(node.Scalar()) : std::string();
  if (mode == "trinary") {
    yaml.reading.mode = map::CellReading::Mode::Trinary;
  } else if (mode == "scale") {
    yaml.reading.mode = map::CellReading::Mode::Scale;
  } else if (mode == "raw") {
    yaml.reading.mode = map::CellReading::Mode::Raw;
  } else {
    return faultText("files", "Its mode is unknown. It must be trinary, scale or raw.");
  }
  return std::nullopt;
}

std::optional<Fault> readAll(const YAML::Node& root, MapYaml& yaml) {
  const YAML::Node image = root["image"];
  if (!image || !image.IsScalar() || image.Scalar().empty())
    return faultText("files", "It does not name an image.");
  yaml.image = image.Scalar();
  const YAML::Node resolution = root["resolution"];
  if (!resolution)
    return faultText(
        "files",
        "It has no resolution, so the position of the map is unknown. Add for example: resolution: 0.05");
  const auto metres = numberOf(resolution);
  if (!metres) return map::fault::ResolutionNoNumber;
  yaml.grid.resolution_m = *metres;
  if (auto why = readOrigin(root["origin"], yaml)) return why;
  if (auto why = map::unusableReason(yaml.grid)) return why;
  if (auto why = readNegate(root["negate"], yaml)) return why;
  if (auto why = readMode(root["mode"], yaml)) return why;
  if (yaml.reading.mode == map::CellReading::Mode::Raw) {
    // They are of no use there, but map_server insists on them.
    for (const char* name : {"occupied_thresh", "free_thresh"}) {
      const YAML::Node threshold = root[name];
      if (!threshold || !numberOf(threshold))
        yaml.notes.push_back(
            {faultText("files", "%1 is missing or no number, but map_server needs it in any mode."), {name}});
    }
    return std::nullopt;
  }
  if (auto why =
          readThreshold(root["occupied_thresh"], "occupied_thresh", yaml.reading.occupied_thresh, yaml))
    return why;
  if (auto why = readThreshold(root["free_thresh"], "free_thresh", yaml.reading.free_thresh, yaml))
    return why;
  if (yaml.reading.free_thresh >= yaml.reading.occupied_thresh) {
    yaml.notes.push_back(
        faultText("files", "Its free_thresh is not below its occupied_thresh, so no cell can be unknown."));
  }
  return std::nullopt;
}

/// Programs disagree about which of them counts.
void noteTwice(const YAML::Node& root, MapYaml& yaml) {
  std::map<std::string, int> met;
  for (const auto& member : root) {
    if (member.first.IsScalar() && ++met[member.first.Scalar()] == 2)
      yaml.notes.push_back({faultText("files", "%1 is written twice. The first one counts."),
                            {member.first.Scalar().substr(0, 80)}});
  }
}

constexpr std::size_t kMostKept = 20'000;
constexpr std::int64_t kCoarsestTimeNs = 2'000'000'000;  // FAT

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

tl::expected<MapYaml, Fault> parseMapYaml(const std::string& text) {
  if (text.size() > kMaxYamlBytes) return refused(faultText("files", "It is too long for a map.yaml."));
  const auto document = yaml::readYaml(text);
  if (!document) return refused({fault::YamlBroken, {document.error().line}});
  MapYaml yaml;
  try {
    const YAML::Node& root = document->root;
    if (!root.IsMap())
      return refused(faultText("files", "It is not a map.yaml: image, resolution and origin are missing."));
    if (auto why = readAll(root, yaml)) return refused(std::move(*why));
    noteTwice(root, yaml);
    if (document->next)
      yaml.notes.push_back(
          faultText("files", "It holds more than one document. Only the first one is read."));
  } catch (const YAML::Exception& broken) {
    return refused({fault::YamlBroken, {broken.mark.line + 1}});
  }
  return yaml;
}

std::int64_t YamlShelf::timeOfDayNs() {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  return nanoseconds(now);
}

tl::expected<MapYaml, Fault> YamlShelf::read(const std::string& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) about = {};
  const Stamp stamp{std::uint64_t(about.st_dev), std::uint64_t(about.st_ino), std::uint64_t(about.st_size),
                    nanoseconds(about.st_mtim), nanoseconds(about.st_ctim)};
  if (const auto found = kept_.find(path); found != kept_.end() && found->second.stamp == stamp) {
    return found->second.yaml;
  }
  ++reads_;
  const auto text = disk::readFile(path, kMaxYamlBytes + 1);
  tl::expected<MapYaml, Fault> yaml =
      text ? parseMapYaml(*text)
           : tl::make_unexpected(
                 Fault(faultText("files", "%1 cannot be opened"), {path}, {text.error().cause}));
  const bool settled = now_ns_() - std::max(stamp.modified_ns, stamp.changed_ns) > kCoarsestTimeNs;
  kept_.erase(path);
  if (!settled || !text) return yaml;
  if (kept_.size() >= kMostKept) kept_.clear();
  kept_.emplace(path, Kept{stamp, yaml});
  return yaml;
}

}  // namespace mapwright::robot::files
