#include "ui/robot/robot_status.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QTimeZone>

#include "geometry/polyline.h"
#include "sentences/state_words.h"
#include "words/fixed.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

constexpr int kLongestValue = 200;

QString plain(const std::string& text) { return plainWords(text, kLongestValue); }

/// In the language spoken where it is known.
QString stateWord(const std::string& state) { return plainWords(sentences::stateWord(state), kLongestValue); }

QString number(double value, int decimals, const char* unit) {
  if (!std::isfinite(value)) return QStringLiteral("?");
  return QStringLiteral("%1 %2").arg(QString::number(value, 'f', decimals), QLatin1String(unit));
}

QString percent(double share) {
  if (!std::isfinite(share)) return QStringLiteral("?");
  return QCoreApplication::translate("window", "%1 %").arg(words::fixed(share * 100, 0));
}

class Section {
 public:
  explicit Section(const char* title) { made_.title = QCoreApplication::translate("window", title); }
  void add(const char* name, const QString& value, Mark mark = Mark::None, std::optional<double> bar = {}) {
    if (!value.isEmpty())
      made_.fields.push_back({QCoreApplication::translate("window", name), value, mark, bar});
  }
  void addTo(std::vector<StatusSection>& sections) {
    if (!made_.fields.empty()) sections.push_back(std::move(made_));
  }

 private:
  StatusSection made_;
};

void addBattery(const map::BatteryState& battery, std::vector<StatusSection>& sections) {
  Section section(QT_TRANSLATE_NOOP("window", "Battery"));
  if (battery.level && std::isfinite(*battery.level)) {
    const double level = std::clamp(*battery.level, 0.0, 1.0);
    const bool charging = battery.supply == "charging";
    const Mark mark = charging || level >= 0.2 ? Mark::None : level >= 0.1 ? Mark::Warning : Mark::Bad;
    section.add(QT_TRANSLATE_NOOP("window", "Level"), percent(level), mark, level);
  }
  section.add(QT_TRANSLATE_NOOP("window", "Supply"), stateWord(battery.supply),
              battery.supply == "charging" ? Mark::Busy : Mark::None);
  if (battery.voltage_v)
    section.add(QT_TRANSLATE_NOOP("window", "Voltage"), number(*battery.voltage_v, 1, "V"));
  if (battery.current_a)
    section.add(QT_TRANSLATE_NOOP("window", "Current"), number(*battery.current_a, 1, "A"));
  section.addTo(sections);
}

void addWheels(const map::WheelState& wheels, std::vector<StatusSection>& sections) {
  Section section(QT_TRANSLATE_NOOP("window", "Wheels"));
  if (wheels.emergency_stop.value_or(false)) {
    section.add(QT_TRANSLATE_NOOP("window", "Emergency stop"),
                QCoreApplication::translate("window", "PRESSED"), Mark::Bad);
  }
  section.add(QT_TRANSLATE_NOOP("window", "Control"), stateWord(wheels.control_mode),
              wheels.control_mode == "manual" ? Mark::Warning : Mark::None);
  if (wheels.wheels_released.value_or(false)) {
    section.add(QT_TRANSLATE_NOOP("window", "Wheels"),
                QCoreApplication::translate("window", "released, can be pushed"), Mark::Warning);
  }
  if (wheels.emergency_stop && !*wheels.emergency_stop)
    section.add(QT_TRANSLATE_NOOP("window", "Emergency stop"),
                QCoreApplication::translate("window", "not pressed"));
  section.addTo(sections);
}

void addSlam(const map::SlamStatus& slam, std::vector<StatusSection>& sections) {
  Section section(QT_TRANSLATE_NOOP("window", "SLAM"));
  section.add(QT_TRANSLATE_NOOP("window", "State"), stateWord(slam.state));
  if (slam.position_quality) {
    const int quality = *slam.position_quality;
    const Mark mark = quality >= 8   ? Mark::Good
                      : quality == 0 ? Mark::Neutral
                      : quality == 1 ? Mark::Bad
                                     : Mark::Warning;
    section.add(QT_TRANSLATE_NOOP("window", "Position"), sentences::qualityWord(quality), mark);
  }
  if (slam.reliable) {
    section.add(QT_TRANSLATE_NOOP("window", "Reliable"),
                *slam.reliable ? QCoreApplication::translate("window", "yes")
                               : QCoreApplication::translate("window", "no"),
                *slam.reliable ? Mark::Good : Mark::Warning);
  }
  if (slam.lidar_matching_score && std::isfinite(*slam.lidar_matching_score)) {
    section.add(QT_TRANSLATE_NOOP("window", "Lidar matching"),
                QString::number(*slam.lidar_matching_score, 'f', 2),
                slam.lidar_matched.value_or(true) ? Mark::None : Mark::Warning);
  } else if (slam.lidar_matched) {
    section.add(QT_TRANSLATE_NOOP("window", "Lidar matching"),
                *slam.lidar_matched ? QCoreApplication::translate("window", "matched")
                                    : QCoreApplication::translate("window", "lost"),
                *slam.lidar_matched ? Mark::Good : Mark::Warning);
  }
  if (slam.wheel_slipping.value_or(false))
    section.add(QT_TRANSLATE_NOOP("window", "Wheels"), QCoreApplication::translate("window", "slipping"),
                Mark::Warning);
  section.addTo(sections);
}

void addPlanning(const map::PlanningState& planning, std::vector<StatusSection>& sections) {
  Section section(QT_TRANSLATE_NOOP("window", "Planning"));
  QString action = plain(planning.action_type);
  if (planning.action_id && *planning.action_id > 0) {
    action = QStringLiteral("%1 #%2").arg(
        action.isEmpty() ? QCoreApplication::translate("window", "action") : action,
        QString::number(*planning.action_id));
  }
  section.add(QT_TRANSLATE_NOOP("window", "Action"), action);
  const std::string& state = planning.move_state;
  section.add(QT_TRANSLATE_NOOP("window", "State"), stateWord(state),
              state == "failed"      ? Mark::Bad
              : state == "moving"    ? Mark::Busy
              : state == "succeeded" ? Mark::Good
                                     : Mark::None);
  if (planning.remaining_distance_m && *planning.remaining_distance_m >= 0)
    section.add(QT_TRANSLATE_NOOP("window", "Remaining"), number(*planning.remaining_distance_m, 1, "m"));
  if (planning.stuck_state != "none")
    section.add(QT_TRANSLATE_NOOP("window", "Stuck"), plain(planning.stuck_state), Mark::Warning);
  if (planning.fail_reason != "none")
    section.add(QT_TRANSLATE_NOOP("window", "Failure"), plain(planning.fail_reason), Mark::Bad);
  section.addTo(sections);
}

void addPositioning(const map::GlobalPositioning& positioning, std::vector<StatusSection>& sections) {
  Section section(QT_TRANSLATE_NOOP("window", "Global positioning"));
  section.add(QT_TRANSLATE_NOOP("window", "State"), stateWord(positioning.state));
  if (positioning.score && std::isfinite(*positioning.score))
    section.add(QT_TRANSLATE_NOOP("window", "Score"), QString::number(*positioning.score, 'f', 2));
  if (positioning.needs_confirmation.value_or(false))
    section.add(QT_TRANSLATE_NOOP("window", "Confirmation"), QCoreApplication::translate("window", "needed"),
                Mark::Warning);
  section.add(QT_TRANSLATE_NOOP("window", "Message"), plain(positioning.message));
  section.addTo(sections);
}

void addJack(const map::JackState& jack, std::vector<StatusSection>& sections) {
  Section section(QT_TRANSLATE_NOOP("window", "Jack"));
  section.add(QT_TRANSLATE_NOOP("window", "State"), stateWord(jack.state));
  if (jack.progress && std::isfinite(*jack.progress))
    section.add(QT_TRANSLATE_NOOP("window", "Height"), percent(*jack.progress));
  if (jack.weight && std::isfinite(*jack.weight))
    section.add(QT_TRANSLATE_NOOP("window", "Weight"), QString::number(*jack.weight, 'g', 6));
  if (jack.self_checking.value_or(false))
    section.add(QT_TRANSLATE_NOOP("window", "Self-check"), QCoreApplication::translate("window", "running"),
                Mark::Busy);
  section.addTo(sections);
}

void addTowing(const map::TowingState& towing, std::vector<StatusSection>& sections) {
  Section section(QT_TRANSLATE_NOOP("window", "Towing"));
  section.add(QT_TRANSLATE_NOOP("window", "State"), stateWord(towing.state),
              towing.state == "error" ? Mark::Bad : Mark::None);
  if (towing.cargo_detected)
    section.add(QT_TRANSLATE_NOOP("window", "Cargo"), *towing.cargo_detected
                                                          ? QCoreApplication::translate("window", "detected")
                                                          : QCoreApplication::translate("window", "none"));
  if (towing.progress && *towing.progress > 0 && *towing.progress < 1)
    section.add(QT_TRANSLATE_NOOP("window", "Progress"), percent(*towing.progress));
  if (towing.error_code != 0 || !towing.error.empty()) {
    QString error = plain(towing.error);
    if (towing.error_code != 0)
      error = error.isEmpty() ? QString::number(towing.error_code)
                              : words::about(QString::number(towing.error_code), error);
    section.add(QT_TRANSLATE_NOOP("window", "Failure"), error, Mark::Bad);
  }
  section.addTo(sections);
}

}  // namespace

std::vector<StatusSection> statusSections(const map::LiveState& live) {
  std::vector<StatusSection> sections;
  if (live.battery) addBattery(*live.battery, sections);
  if (live.wheels) addWheels(*live.wheels, sections);
  addSlam(live.slam, sections);
  if (live.planning) addPlanning(*live.planning, sections);
  if (live.map_info) {
    Section section(QT_TRANSLATE_NOOP("window", "Map"));
    section.add(QT_TRANSLATE_NOOP("window", "Name"), plain(live.map_info->name));
    if (live.map_info->map_version)
      section.add(QT_TRANSLATE_NOOP("window", "Version"), QString::number(*live.map_info->map_version));
    if (live.map_info->overlays_version)
      section.add(QT_TRANSLATE_NOOP("window", "Overlays"),
                  QCoreApplication::translate("window", "version %1").arg(*live.map_info->overlays_version));
    section.addTo(sections);
  }
  if (live.sensors) {
    Section section(QT_TRANSLATE_NOOP("window", "Sensors"));
    section.add(QT_TRANSLATE_NOOP("window", "Power"), stateWord(live.sensors->power_state));
    section.addTo(sections);
  }
  if (live.jack) addJack(*live.jack, sections);
  if (live.towing) addTowing(*live.towing, sections);
  if (live.global_positioning) addPositioning(*live.global_positioning, sections);
  if (live.barcode) {
    Section section(QT_TRANSLATE_NOOP("window", "Barcode"));
    section.add(QT_TRANSLATE_NOOP("window", "State"), stateWord(live.barcode->state));
    section.add(QT_TRANSLATE_NOOP("window", "Id"), plain(live.barcode->id));
    section.addTo(sections);
  }
  return sections;
}

std::vector<StatusSection> topicSections(const map::LiveState& live) {
  std::vector<StatusSection> sections;
  const auto place = [](double x_m, double y_m) {
    return QStringLiteral("%1, %2").arg(number(x_m, 2, "m"), number(y_m, 2, "m"));
  };
  const auto heading = [](double yaw_rad) {
    return std::isfinite(yaw_rad) ? QStringLiteral("%1°").arg(QString::number(yaw_rad * 180 / M_PI, 'f', 0))
                                  : QString();
  };
  const auto& pose = live.robot_pose;
  if (pose) {
    Section section(QT_TRANSLATE_NOOP("window", "Pose"));
    section.add(QT_TRANSLATE_NOOP("window", "Position"), place(pose->x_m, pose->y_m));
    section.add(QT_TRANSLATE_NOOP("window", "Heading"), heading(pose->yaw_rad));
    section.addTo(sections);
  }
  if (live.planning && !live.planning->targets.empty()) {
    const geometry::Pose2& goal = live.planning->targets.front();
    Section section(QT_TRANSLATE_NOOP("window", "Goal"));
    section.add(QT_TRANSLATE_NOOP("window", "Position"), place(goal.x_m, goal.y_m));
    section.add(QT_TRANSLATE_NOOP("window", "Heading"), heading(goal.yaw_rad));
    if (pose)
      section.add(QT_TRANSLATE_NOOP("window", "Distance"),
                  number(std::hypot(goal.x_m - pose->x_m, goal.y_m - pose->y_m), 1, "m"));
    section.addTo(sections);
  }
  if (live.path.size() > 1) {
    Section section(QT_TRANSLATE_NOOP("window", "Path"));
    section.add(QT_TRANSLATE_NOOP("window", "Length"), number(geometry::lengthOf(live.path), 1, "m"));
    section.addTo(sections);
  }
  return sections;
}

std::vector<AlertLine> alertLines(const std::vector<map::Alert>& alerts, const QDateTime& now) {
  std::vector<const map::Alert*> sorted;
  for (const map::Alert& alert : alerts) sorted.push_back(&alert);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const map::Alert* a, const map::Alert* b) { return a->level > b->level; });
  std::vector<AlertLine> lines;
  for (const map::Alert* alert : sorted) {
    AlertLine line;
    line.mark = alert->level == map::AlertLevel::Error     ? Mark::Bad
                : alert->level == map::AlertLevel::Warning ? Mark::Warning
                                                           : Mark::Neutral;
    line.level = alert->level == map::AlertLevel::Error     ? QCoreApplication::translate("window", "error")
                 : alert->level == map::AlertLevel::Warning ? QCoreApplication::translate("window", "warning")
                                                            : QCoreApplication::translate("window", "note");
    line.code = QString::number(alert->code);
    line.text = plain(alert->text);
    if (alert->since_s > 0 && alert->since_s < 4e9) {
      const QDateTime since = QDateTime::fromMSecsSinceEpoch(qint64(alert->since_s * 1000), now.timeZone());
      line.since = since.toString(since.date() == now.date() ? QStringLiteral("HH:mm:ss")
                                                             : QStringLiteral("yyyy-MM-dd HH:mm:ss"));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace mapwright::ui
