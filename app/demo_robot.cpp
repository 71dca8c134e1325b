#include "app/demo_robot.h"

#include <algorithm>

#include <QCoreApplication>
#include <QStringList>

#include "robot/axbot/axbot_robot.h"

namespace mapwright::app {
namespace {

class DemoRobotText {
  Q_DECLARE_TR_FUNCTIONS(DemoRobot)
};

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
        return tl::make_unexpected(DemoRobotText::tr("There is no scene \"%1\". Choose one of: %2.")
                                       .arg(value, names.join(QLatin1String(", "))));
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
          DemoRobotText::tr("demo: accepts scene, submaps, seed and at, but not \"%1\".").arg(name));
    }
    if (!ok) return tl::make_unexpected(DemoRobotText::tr("demo: %1 cannot be \"%2\".").arg(name, value));
  }
  return options;
}

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

tl::expected<std::unique_ptr<robot::Robot>, QString> makeDemoRobot(const QString& address,
                                                                   const simulator::Options& options) {
  auto simulator = std::make_unique<simulator::Simulator>(options);
  if (const auto error = simulator->start()) return tl::make_unexpected(QString::fromStdString(*error));
  robot::axbot::LinkOptions link;
  link.base = QUrl(QStringLiteral("http://127.0.0.1:%1").arg(simulator->port()));
  return std::make_unique<DemoRobot>(address, std::move(link), std::move(simulator));
}

}  // namespace mapwright::app
