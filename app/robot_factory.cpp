#include "app/robot_factory.h"

#include <algorithm>

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QStringList>

#include "app/command_text.h"
#include "app/log.h"
#include "jobs/export_map.h"
#include "robot/aimdk/aimdk_address.h"
#include "robot/aimdk/aimdk_probe.h"
#include "robot/aimdk/aimdk_robot.h"
#include "robot/axbot/axbot_address.h"
#include "robot/axbot/axbot_probe.h"
#include "robot/axbot/axbot_robot.h"
#include "robot/files/file_address.h"
#include "robot/files/file_robot.h"
#include "robot/files/local_maps.h"
#include "robot/files/overlay_file.h"
#include "robot/files/waypoint_file.h"
#include "robot/pbstream/state_robot.h"
#include "robot/recorded/recorded_robot.h"
#include "robot/ros/ros_address.h"
#include "robot/ros/ros_probe.h"
#include "robot/ros/ros_robot.h"
#include "words/listed.h"

namespace mapwright::app {

namespace {

QString cacheFolder(const char* name) {
  return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) +
         QStringLiteral("/mapwright/") + QLatin1String(name);
}

/// Frozen demos show this moment: the live trajectory has grown, and the incremental one exists.
constexpr double kFrozenAtS = 90;

class DemoRobot : public robot::axbot::AxbotRobot {
 public:
  DemoRobot(const QString& address, robot::axbot::LinkOptions options,
            std::unique_ptr<simulator::Simulator> simulator)
      : AxbotRobot(address, std::move(options)), simulator_(std::move(simulator)) {}

 private:
  std::unique_ptr<simulator::Simulator> simulator_;
};

QString absolute(const QString& path) { return QDir::cleanPath(QFileInfo(path).absoluteFilePath()); }

using Made = tl::expected<std::unique_ptr<robot::Robot>, QString>;

/// A kind of robot: its address scheme and its factory.
struct Kind {
  robot::AddressScheme scheme;
  std::function<Made(const robot::Address&, const Access&, DemoTime)> make;
};

Made makeAxbot(const robot::Address& address, const Access& access, DemoTime) {
  robot::axbot::LinkOptions link;
  link.base = address.url;
  link.secret = access.secret;
  link.trust = access.trust;
  link.cache_folder = cacheFolder("http");
  return std::make_unique<robot::axbot::AxbotRobot>(address.text, std::move(link));
}

Made makeAimdk(const robot::Address& address, const Access& access, DemoTime) {
  robot::aimdk::LinkOptions link;
  link.base = address.url;
  link.trust = access.trust;
  robot::aimdk::RobotBeside second;
  if (const QUrl tf = robot::aimdk::tfOf(address); !tf.isEmpty()) {
    robot::ros::LinkOptions beside;
    beside.url = tf;
    // It is another server: it gets neither the secret nor the pinned certificate.
    beside.trust.authorities = access.trust.authorities;
    robot::Address its;
    its.url = tf;
    second = {
        std::make_unique<robot::ros::RosRobot>(QStringLiteral("ros+") + tf.toString(), std::move(beside)),
        robot::hostOf(its)};
  }
  return std::make_unique<robot::aimdk::AimdkRobot>(address.text, std::move(link), std::move(second));
}

Made rosRobot(const robot::Address& address, const Access& access, bool kabam_only) {
  robot::ros::LinkOptions link;
  link.url = address.url;
  link.secret = access.secret;
  link.trust = access.trust;
  link.ns = robot::ros::namespaceOf(address);
  link.dispatch = robot::ros::dispatchSettingsOf(address);
  link.kabam_only = kabam_only;
  if (access.timeout) link.kabam.read = *access.timeout;
  return std::make_unique<robot::ros::RosRobot>(address.text, std::move(link));
}

Made makeFiles(const robot::Address& address, const Access&, DemoTime) {
  if (robot::recorded::isRecording(address.path)) {
    robot::recorded::RecordedOptions recording;
    recording.path = absolute(address.path);
    recording.ns = robot::files::namespaceOf(address);
    QString text = QStringLiteral("file:") + recording.path;
    if (!recording.ns.empty()) text += QStringLiteral("?ns=") + QString::fromStdString(recording.ns);
    return std::make_unique<robot::recorded::RecordedRobot>(text, std::move(recording));
  }
  if (robot::pbstream::hasStateFileName(address.path)) {
    if (!address.options.isEmpty())
      return tl::make_unexpected(
          Text::tr("%1 is a Cartographer state file: leave out the part after the ?.").arg(address.path));
    robot::pbstream::StateOptions state;
    state.path = absolute(address.path);
    return std::make_unique<robot::pbstream::StateRobot>(QStringLiteral("file:") + state.path,
                                                         std::move(state));
  }
  if (address.options.hasQueryItem(QStringLiteral("ns")))
    return tl::make_unexpected(
        Text::tr("%1: ?ns= names a robot in a recording, and this is none.").arg(address.path));
  robot::files::FileOptions file;
  file.path = address.path;
  file.place = robot::files::placeOf(address);
  return std::make_unique<robot::files::FileRobot>(address.text, std::move(file));
}

Made makeDemo(const robot::Address& address, const Access&, DemoTime time) {
  const auto options = parseDemoQuery(address.options, time);
  if (!options) return passOn(options);
  return makeDemoRobot(address.text, *options);
}

/// "demo:", "demo:?scene=warehouse". The part after the ? is checked when the robot is made.
robot::AddressScheme demoAddressScheme() {
  const auto parse = [](const QString& rest) -> robot::ParsedAddress {
    const QString query = rest.contains(QLatin1Char('?')) ? rest.section(QLatin1Char('?'), 1) : QString();
    robot::Address address;
    address.options = QUrlQuery(query);
    address.text = query.isEmpty() ? QStringLiteral("demo:") : QStringLiteral("demo:?") + query;
    return address;
  };
  return {QStringLiteral("demo:"), QStringLiteral("demo:"), parse,
          [](const QString& typed) { return typed == QLatin1String("demo"); }, false};
}

/// Maps, recordings and state files: a path with such an extension is one, even if it does not exist.
robot::AddressScheme fileScheme() {
  robot::AddressScheme scheme = robot::files::addressScheme();
  scheme.claims = [maps = scheme.claims](const QString& typed) {
    const QString path = typed.section(QLatin1Char('?'), 0, 0);
    const bool named = robot::recorded::hasRecordingName(path) || robot::pbstream::hasStateFileName(path);
    return maps(typed) || (named && !typed.contains(QLatin1String("://")));
  };
  return scheme;
}

/// All kinds of robots; the first one takes addresses that no other claims.
std::vector<Kind> kinds() {
  const auto ros = [](const robot::Address& address, const Access& access, DemoTime) {
    return rosRobot(address, access, false);
  };
  const auto kabam = [](const robot::Address& address, const Access& access, DemoTime) {
    return rosRobot(address, access, true);
  };
  return {{robot::axbot::addressScheme(), makeAxbot},
          {robot::aimdk::addressScheme(), makeAimdk},
          {robot::ros::rosAddressScheme(), ros},
          {robot::ros::kabamAddressScheme(), kabam},
          {robot::ros::rep130AddressScheme(), ros},
          {demoAddressScheme(), makeDemo},
          {fileScheme(), makeFiles}};
}

}  // namespace

tl::expected<simulator::Options, QString> parseDemoQuery(const QUrlQuery& query, DemoTime time) {
  simulator::Options options;
  if (time == DemoTime::Frozen) {
    options.paused = true;
    options.start_at_s = kFrozenAtS;
  }
  for (const auto& [name, value] : query.queryItems(QUrl::FullyDecoded)) {
    bool ok = true;
    if (name == QLatin1String("scene")) {
      options.scene = value.toStdString();
      const auto scenes = simulator::sceneNames();
      if (std::none_of(scenes.begin(), scenes.end(),
                       [&](const auto& s) { return s.first == options.scene; })) {
        QStringList names;
        for (const auto& [scene, sentence] : scenes) names << QString::fromStdString(scene);
        return tl::make_unexpected(
            Text::tr("There is no scene \"%1\". Choose one of: %2.").arg(value, words::listed(names)));
      }
    } else if (name == QLatin1String("submaps")) {
      options.submaps = value.toInt(&ok);
      ok = ok && options.submaps >= 0 && options.submaps <= 100'000;
    } else if (name == QLatin1String("seed")) {
      options.seed = value.toUInt(&ok);
    } else if (name == QLatin1String("at")) {
      options.start_at_s = value.toDouble(&ok);
      ok = ok && options.start_at_s >= 0 && options.start_at_s <= 1e6;
    } else {
      return tl::make_unexpected(
          Text::tr("demo: accepts scene, submaps, seed and at, but not \"%1\".").arg(name));
    }
    if (!ok) return tl::make_unexpected(Text::tr("demo: %1 cannot be \"%2\".").arg(name, value));
  }
  return options;
}

tl::expected<std::unique_ptr<robot::Robot>, QString> makeDemoRobot(const QString& address,
                                                                   const simulator::Options& options) {
  auto simulator = std::make_unique<simulator::Simulator>(options);
  if (const auto error = simulator->start()) return tl::make_unexpected(QString::fromStdString(*error));
  robot::axbot::LinkOptions link;
  link.base = QUrl(QStringLiteral("http://127.0.0.1:%1").arg(simulator->port()));
  return std::make_unique<DemoRobot>(address, std::move(link), std::move(simulator));
}

void onRecording(std::string& robot, std::string& bag, const std::string& otherwise) {
  if (!robot.empty()) return;
  const QString typed = QString::fromStdString(bag);
  // A robot's own bags may be called .bag as well.
  const bool is_path =
      typed.contains(QLatin1Char('/')) || (robot::recorded::hasRecordingName(typed) &&
                                           !typed.endsWith(QLatin1String(".bag"), Qt::CaseInsensitive));
  // A missing file is opened anyway, so that the error is reported then.
  if (is_path || (otherwise.empty() && (QFileInfo(typed).isFile() ||
                                        (QFileInfo(typed).isDir() && robot::recorded::isRecording(typed))))) {
    robot = (QStringLiteral("file:") + absolute(typed)).toStdString();
    const auto parsed = knownAddresses().parse(QString::fromStdString(robot));
    bag = robot::recorded::bagNameOf(parsed ? parsed->path : typed);
  } else {
    robot = otherwise;
  }
}

bool isRecording(const QString& path) { return robot::recorded::isRecording(path); }

std::string bagNameOf(const QString& path) { return robot::recorded::bagNameOf(path); }

std::optional<QString> recordingWithoutTimeReason(const QString& address, const std::string& bag) {
  const auto parsed = knownAddresses().parse(address);
  if (!bag.empty() || !parsed || !isRecording(parsed->path)) return std::nullopt;
  return Text::tr(
             "%1 is a recording, so its map depends on the time. Commands with --bag and --at read it there.")
      .arg(oneLine(address, 200));
}

std::optional<QString> stateFileOf(const QString& address) {
  const auto parsed = knownAddresses().parse(address);
  if (!parsed || !robot::pbstream::hasStateFileName(parsed->path)) return std::nullopt;
  return absolute(parsed->path);
}

bool isMapFile(const QString& path) { return robot::files::isMapFile(path); }

QStringList yamlsNaming(const QString& picture) { return robot::files::yamlsNaming(picture); }

bool isFileName(const QString& typed) {
  return typed.contains(QLatin1Char('/')) || QFileInfo::exists(typed) ||
         typed.startsWith(QLatin1String("file:")) || robot::recorded::hasRecordingName(typed);
}

session::Session::Options sessionOptions() {
  session::Session::Options options;
  // The adapter limits the number of parallel requests (four). With a few more queued it can continue from
  // disk, or with the next request, without waiting for the main thread, which may be painting. Small enough
  // to react quickly when the view moves.
  options.scheduler.max_concurrent = 32;
  options.sidecar_folder = cacheFolder("grids");
  return options;
}

robot::Addresses knownAddresses() {
  std::vector<robot::AddressScheme> schemes;
  for (Kind& kind : kinds()) schemes.push_back(std::move(kind.scheme));
  return robot::Addresses(std::move(schemes));
}

std::vector<robot::Probe> probesOf(const robot::Host& host) {
  std::vector<robot::Probe> all;
  for (std::vector<robot::Probe> some :
       {robot::axbot::probesOf(host), robot::aimdk::probesOf(host), robot::ros::probesOf(host)})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

std::optional<QString> noPlaceReason(const QString& address, const std::string& resolution,
                                     const std::string& origin) {
  if (resolution.empty() && origin.empty()) return std::nullopt;
  const auto parsed = knownAddresses().parse(address);
  if (!parsed) return std::nullopt;  // reported elsewhere
  const QString options = origin.empty()       ? QStringLiteral("--resolution")
                          : resolution.empty() ? QStringLiteral("--origin")
                                               : Text::tr("--resolution and --origin");
  if (parsed->path.isEmpty()) {
    return Text::tr("%1: only for a plain picture file. A robot reports itself where its maps are.")
        .arg(options);
  }
  if (!parsed->options.isEmpty()) {
    return Text::tr("%1: the address already contains it after the ?. Give it only once.").arg(options);
  }
  const QString suffix = QFileInfo(parsed->path).suffix().toLower();
  if (suffix == QLatin1String("yaml") || suffix == QLatin1String("yml")) {
    return Text::tr("%1: only for a plain picture file. %2 states itself where its map is.")
        .arg(options, QFileInfo(parsed->path).fileName());
  }
  return std::nullopt;
}

std::vector<std::string> sourceFilesOf(const QString& address, const std::string& id,
                                       const std::string& picture) {
  std::vector<std::string> files =
      jobs::sourceFiles(knownAddresses(), address, id, picture, robot::files::yamlsNaming);
  for (std::size_t i = 0, maps = files.size(); i < maps; ++i) {
    files.push_back(robot::files::waypointPathOf(files[i]));
    files.push_back(robot::files::overlayPathOf(QString::fromStdString(files[i])).toStdString());
  }
  return files;
}

QString placedFile(const QString& address, const std::string& resolution, const std::string& origin) {
  if (resolution.empty() && origin.empty()) return address;
  const auto parsed = knownAddresses().parse(address);
  if (!parsed || parsed->path.isEmpty() || address.contains(QLatin1Char('?'))) return address;
  QUrlQuery query;
  if (!resolution.empty())
    query.addQueryItem(QStringLiteral("resolution"), QString::fromStdString(resolution));
  if (!origin.empty()) query.addQueryItem(QStringLiteral("origin"), QString::fromStdString(origin));
  return QStringLiteral("file:") + parsed->path + QLatin1Char('?') + query.toString();
}

tl::expected<std::unique_ptr<robot::Robot>, QString> makeRobot(const QString& address, const Access& access,
                                                               DemoTime demo_time) {
  const auto parsed = knownAddresses().parse(address);
  if (!parsed) return passOn(parsed);
  hideInLog(access.secret);
  qCInfo(lcApp, "robot %s, secret: %s", qUtf8Printable(parsed->text),
         access.secret.isEmpty() ? "none" : "given");
  for (const Kind& kind : kinds()) {
    if (kind.scheme.prefix == parsed->scheme) return kind.make(*parsed, access, demo_time);
  }
  return tl::make_unexpected(Text::tr("No kind of robot supports the address %1.").arg(address));
}

}  // namespace mapwright::app
