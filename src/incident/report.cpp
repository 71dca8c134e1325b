#include "incident/report.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <QCoreApplication>
#include <QDateTime>

#include "geometry/pose.h"
#include "map/safety.h"
#include "page/page.h"
#include "replay/event_sentence.h"
#include "sentences/overlay_name.h"
#include "sentences/plural.h"
#include "sentences/problem_sentence.h"
#include "sentences/state_words.h"
#include "sentences/subject_name.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/qt_versions.h"

namespace mapwright::incident {
namespace {

using page::Cell;
using page::named;
using page::Tone;

constexpr double kStandsMPerS = 0.05, kAheadM = 1;
constexpr double kEventsBeforeS = 300;
constexpr double kWithLossS =
    5;  // SLAM tells its state about once a second, robots with a bad link less often
constexpr double kBeginningS = 2;  // until then all that is told regularly has been
constexpr std::size_t kMostEvents = 30, kMostOnTheWay = 40, kMostTopics = 200;
constexpr std::size_t kLongestSaid = 400;
constexpr int kDayLetters = 11;

class ReportText {
  Q_DECLARE_TR_FUNCTIONS(Incident)
};

QString metres(double m) { return ReportText::tr("%1 m").arg(m, 0, 'f', 2); }

/// "12.3 s", "4 min 10 s", "2 h 5 min".
QString ageText(double s) {
  if (s < 100) return ReportText::tr("%1 s").arg(s, 0, 'f', 1);
  const auto whole = qint64(s);
  if (whole < 3600) return ReportText::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
  return ReportText::tr("%1 h %2 min").arg(whole / 3600).arg(whole % 3600 / 60);
}

/// The day is that of the moment, mostly.
QString clockText(double at_s, const Run& run) {
  const QString time = utcText(at_s), day = utcText(run.at_s).left(kDayLetters);
  return time.startsWith(day) ? time.mid(day.size()) : time;
}

QString poseText(const geometry::Pose2& pose) {
  return ReportText::tr("x %1 m, y %2 m, heading %3°")
      .arg(pose.x_m, 0, 'f', 2)
      .arg(pose.y_m, 0, 'f', 2)
      .arg(geometry::degreesFromRadians(geometry::normalizeAngle(pose.yaw_rad)), 0, 'f', 1);
}

std::optional<double> valueAt(const Run& run, series::Quantity quantity) {
  for (const Curve& curve : run.curves) {
    if (curve.quantity == quantity) return curve.at_moment;
  }
  return std::nullopt;
}

std::vector<OnTheWay> thingsOnTheWay(const Run& run) {
  return onTheWay(remainingWay(run.live), radiusOf(run.live.model), run.overlays, run.live.doors);
}

Cell notSaid() { return {ReportText::tr("not known"), Tone::Muted}; }

std::vector<Cell> qualityCells(const map::SlamStatus& slam) {
  std::vector<Cell> cells;
  if (slam.position_quality) {
    const int quality = *slam.position_quality;
    const Tone tone = quality >= 8   ? Tone::Good
                      : quality == 1 ? Tone::Bad
                      : quality == 3 ? Tone::Warning
                                     : Tone::Plain;
    cells.emplace_back(ReportText::tr("%1 (%2 of 10)").arg(sentences::qualityWord(quality)).arg(quality),
                       tone);
  }
  if (slam.reliable)
    cells.emplace_back(*slam.reliable ? ReportText::tr("The robot calls its position reliable.")
                                      : ReportText::tr("The robot calls its position unreliable."),
                       *slam.reliable ? Tone::Plain : Tone::Warning);
  if (slam.lidar_matching_score)
    cells.emplace_back(ReportText::tr("lidar matching %1").arg(*slam.lidar_matching_score, 0, 'f', 2));
  if (slam.lidar_matched == false)
    cells.emplace_back(ReportText::tr("The lidar does not match the map."), Tone::Warning);
  if (slam.wheel_slipping == true) cells.emplace_back(ReportText::tr("The wheels slip."), Tone::Warning);
  if (cells.empty()) cells.push_back(notSaid());
  return cells;
}

/// Before that a reason is one of an earlier task, or none.
bool hasFailed(const map::LiveState& live) { return live.planning && live.planning->move_state == "failed"; }

std::vector<Cell> plannerCells(const map::LiveState& live) {
  if (!live.planning) return {notSaid()};
  const map::PlanningState& planning = *live.planning;
  std::vector<Cell> cells;
  cells.emplace_back(sentences::plannerWord(planning.move_state),
                     planning.move_state == "failed" ? Tone::Bad : Tone::Plain);
  if (!planning.action_type.empty())
    cells.emplace_back(ReportText::tr("action: %1").arg(named(planning.action_type)));
  if (hasFailed(live) && !planning.fail_reason.empty())
    cells.emplace_back(ReportText::tr("reason, as the robot says it: %1")
                           .arg(named(sentences::failureWords(planning.fail_reason))),
                       Tone::Bad);
  if (!planning.stuck_state.empty())
    cells.emplace_back(ReportText::tr("stuck, as the robot says it: %1").arg(named(planning.stuck_state)),
                       Tone::Warning);
  if (planning.remaining_distance_m && *planning.remaining_distance_m >= 0)
    cells.emplace_back(ReportText::tr("%1 to go").arg(metres(*planning.remaining_distance_m)));
  for (std::size_t i = 0; i < std::min<std::size_t>(planning.targets.size(), 3); ++i)
    cells.emplace_back(ReportText::tr("target: %1").arg(poseText(planning.targets[i])));
  return cells;
}

void writeState(page::Page& page, const Run& run) {
  const map::LiveState& live = run.live;
  std::vector<page::Page::Fact> facts;
  const auto fact = [&](const QString& what, std::vector<Cell> values) {
    facts.push_back({what, std::move(values)});
  };
  fact(ReportText::tr("Time"), {ReportText::tr("%1 UTC").arg(utcText(run.at_s))});
  if (const robot::BagAway* const away = run.info.awayAt(run.at_s))
    fact(ReportText::tr("Connection"),
         {{ReportText::tr("lost since %1 UTC: nothing was recorded").arg(utcText(away->from_s)), Tone::Bad}});
  fact(ReportText::tr("Position"), {live.robot_pose ? Cell(poseText(*live.robot_pose)) : notSaid()});
  fact(ReportText::tr("Position quality"), qualityCells(live.slam));
  if (!live.slam.state.empty()) fact(ReportText::tr("SLAM"), {named(sentences::stateWord(live.slam.state))});
  const auto speed = valueAt(run, series::Quantity::Speed);
  fact(ReportText::tr("Speed"), {speed ? Cell(ReportText::tr("%1 m/s").arg(*speed, 0, 'f', 2)) : notSaid()});
  fact(ReportText::tr("Planner"), plannerCells(live));
  if (run.map_name.empty()) {
    fact(ReportText::tr("Map"), {notSaid()});
  } else {
    std::vector<Cell> map{named(run.map_name)};
    if (live.map_info && live.map_info->map_version)
      map.emplace_back(ReportText::tr("version %1").arg(*live.map_info->map_version));
    if (run.map_of_now)
      map.emplace_back(
          ReportText::tr("The bag holds no picture of the map: the robot's present one is drawn."),
          Tone::Warning);
    fact(ReportText::tr("Map"), std::move(map));
  }
  std::vector<Cell> battery;
  if (live.battery && live.battery->level)
    battery.emplace_back(ReportText::tr("%1 %").arg(*live.battery->level * 100, 0, 'f', 1));
  if (live.battery && !live.battery->supply.empty())
    battery.emplace_back(named(sentences::stateWord(live.battery->supply)));
  if (battery.empty()) battery.push_back(notSaid());
  fact(ReportText::tr("Battery"), std::move(battery));
  if (live.sensors && !live.sensors->power_state.empty())
    fact(ReportText::tr("Sensors"), {named(sentences::stateWord(live.sensors->power_state))});
  if (live.jack && !live.jack->state.empty()) {
    std::vector<Cell> jack{named(sentences::stateWord(live.jack->state))};
    if (live.jack->progress)
      jack.emplace_back(ReportText::tr("%1 % up").arg(*live.jack->progress * 100, 0, 'f', 0));
    fact(ReportText::tr("Jack"), std::move(jack));
  }
  if (live.towing && !live.towing->state.empty()) {
    const map::TowingState& towing = *live.towing;
    std::vector<Cell> cells{
        {named(sentences::stateWord(towing.state)), towing.state == "error" ? Tone::Bad : Tone::Plain}};
    if (towing.cargo_detected)
      cells.emplace_back(*towing.cargo_detected ? ReportText::tr("cargo detected")
                                                : ReportText::tr("no cargo"));
    if (!towing.error.empty()) cells.emplace_back(named(towing.error), Tone::Bad);
    fact(ReportText::tr("Towing"), std::move(cells));
  }
  page.facts(facts);
}

/// The first message of this kind tells of it, where the recording begins.
bool isFromTheFirst(std::size_t kind, double since_s, const Run& run) {
  const auto first = run.first_s.find(kind);
  return first != run.first_s.end() && since_s <= first->second &&
         first->second - run.info.start_s <= kBeginningS;
}

bool beganBefore(const map::SafetyCondition& condition, const Run& run) {
  std::size_t kind = map::topicIndex<map::WheelState>();
  if (condition.kind == map::SafetyKind::Alert) kind = map::topicIndex<map::AlertsMessage>();
  if (condition.kind == map::SafetyKind::PositionLost ||
      condition.kind == map::SafetyKind::PositionUncertain ||
      condition.kind == map::SafetyKind::WheelsSlipping)
    kind = map::topicIndex<map::SlamStatus>();
  return isFromTheFirst(kind, condition.since_s, run);
}

bool beganBefore(const replay::Event& event, const Run& run) {
  switch (event.kind) {
    case replay::EventKind::AlertBegan:
      return isFromTheFirst(map::topicIndex<map::AlertsMessage>(), event.at_s, run);
    case replay::EventKind::QualityLow:
      return isFromTheFirst(map::topicIndex<map::SlamStatus>(), event.at_s, run);
    case replay::EventKind::EmergencyStopOn:
      return isFromTheFirst(map::topicIndex<map::WheelState>(), event.at_s, run);
    default:
      return false;
  }
}

void writeSafety(page::Page& page, const Run& run) {
  const map::LiveState& live = run.live;
  std::vector<page::Page::Fact> facts;
  Cell stop = notSaid();
  if (live.wheels && live.wheels->emergency_stop)
    stop = *live.wheels->emergency_stop ? Cell(ReportText::tr("pressed"), Tone::Bad)
                                        : Cell(ReportText::tr("not pressed"));
  facts.push_back({ReportText::tr("Emergency stop"), {stop}});
  Cell control = notSaid();
  if (live.wheels && !live.wheels->control_mode.empty())
    control = Cell(named(sentences::stateWord(live.wheels->control_mode)));
  facts.push_back({ReportText::tr("Control"), {control}});
  std::vector<Cell> conditions;
  for (const auto& [condition, code_since_s] : run.conditions.all) {
    const map::Problem problem = map::problemOf(condition);
    QString words = words::about(sentences::nameOf(problem.subject), named(sentences::sentenceOf(problem)));
    if (beganBefore(condition, run))
      words = ReportText::tr("%1 (since before the recording begins)").arg(words);
    else if (condition.since_s > 0)
      words = ReportText::tr("%1 (since %2, for %3)")
                  .arg(words, clockText(condition.since_s, run), ageText(run.at_s - condition.since_s));
    if (code_since_s < condition.since_s)
      words = ReportText::tr("%1, in other words since %2").arg(words, clockText(code_since_s, run));
    conditions.emplace_back(words, condition.severity == map::Severity::Error ? Tone::Bad : Tone::Warning);
  }
  if (conditions.empty()) conditions.emplace_back(ReportText::tr("none that the robot reports"));
  facts.push_back({ReportText::tr("Conditions"), std::move(conditions)});
  for (const auto& [topic, said] : run.said)
    facts.push_back(
        {named(topic),
         {said.size() > kLongestSaid ? named(said.substr(0, kLongestSaid)) + QChar(0x2026) : named(said)}});
  page.facts(facts);
}

void writeMap(page::Page& page, const Run& run) {
  if (run.picture.isEmpty()) {
    page.paragraph(
        ReportText::tr("There is nothing to draw: the bag has no map and no position up to this time."),
        Tone::Muted);
  } else {
    page.picture(run.picture, run.picture_px,
                 ReportText::tr("The map around the robot at %1 UTC, with its path, scan and overlays")
                     .arg(utcText(run.at_s)));
  }
  for (const QString& remark : run.remarks) page.paragraph(remark, Tone::Warning);
}

void writeCurves(page::Page& page, const Run& run) {
  if (run.curves.empty())
    page.paragraph(ReportText::tr("The bag holds no numbers of this minute."), Tone::Muted);
  for (const Curve& curve : run.curves) page.drawing(svgOf(curve, run.at_s));
  page.paragraph(ReportText::tr("0 s is %1 UTC.").arg(utcText(run.at_s)), Tone::Muted);
}

Tone toneOf(const replay::Event& event) {
  switch (event.kind) {
    case replay::EventKind::EmergencyStopOn:
      return Tone::Bad;
    case replay::EventKind::AlertBegan:
    case replay::EventKind::PositionJump:
    case replay::EventKind::QualityLow:
      return Tone::Warning;
    case replay::EventKind::MoveState:
      return event.text == "failed" ? Tone::Bad : Tone::Plain;
    default:
      return Tone::Plain;
  }
}

void writeEvents(page::Page& page, const Run& run) {
  std::vector<const replay::Event*> shown;
  std::size_t before = 0;
  for (const replay::Event& event : run.events) {
    if (event.at_s > run.at_s + kBesideS) break;
    if (event.at_s < run.at_s - kEventsBeforeS) {
      ++before;
    } else {
      shown.push_back(&event);
    }
  }
  if (shown.size() > kMostEvents) {
    before += shown.size() - kMostEvents;
    shown.erase(shown.begin(), shown.end() - std::ptrdiff_t(kMostEvents));
  }
  if (before > 0)
    page.paragraph(sentences::counted(ReportText::tr("%1 earlier events are left out.", nullptr,
                                                     sentences::formOf(qint64(before))),
                                      qint64(before)),
                   Tone::Muted);
  if (shown.empty()) {
    page.paragraph(ReportText::tr("Nothing happened in the five minutes before."), Tone::Muted);
    return;
  }
  page.beginTable({ReportText::tr("Time (UTC)"), ReportText::tr("Offset"), ReportText::tr("Event")});
  const auto row = [&](double at_s, const Cell& what) {
    const double since_s = at_s - run.at_s;
    page.row({page::figure(clockText(at_s, run)),
              page::figure(ReportText::tr("%1%2 s")
                               .arg(since_s > 0 ? QStringLiteral("+") : QString())
                               .arg(since_s, 0, 'f', 1)),
              what});
  };
  bool told = false;
  for (const replay::Event* const event : shown) {
    if (event->at_s > run.at_s && !std::exchange(told, true))
      row(run.at_s, {ReportText::tr("the moment of this report"), Tone::Muted});
    const QString words = named(replay::eventText(*event));
    row(event->at_s, {beganBefore(*event, run)
                          ? ReportText::tr("%1 (was there already when the recording begins)").arg(words)
                          : words,
                      toneOf(*event)});
  }
  if (!told) row(run.at_s, {ReportText::tr("the moment of this report"), Tone::Muted});
  page.endTable();
}

void writeOnTheWay(page::Page& page, const Run& run) {
  const Way way = remainingWay(run.live);
  if (way.points.empty()) {
    page.paragraph(ReportText::tr("No path is known at this time."), Tone::Muted);
    return;
  }
  const double radius_m = radiusOf(run.live.model);
  if (way.local) page.paragraph(ReportText::tr("Only the local path is known."), Tone::Muted);
  if (way.off_m > kAheadM)
    page.paragraph(ReportText::tr("The robot is %1 away from this path.").arg(metres(way.off_m)),
                   Tone::Warning);
  const std::vector<OnTheWay> things = thingsOnTheWay(run);
  if (things.empty()) {
    page.paragraph(ReportText::tr("No wall, region or door lies on the rest of the path."));
  } else {
    page.beginTable({ReportText::tr("Along the path"), ReportText::tr("What"), ReportText::tr("How near")});
    for (std::size_t i = 0; i < std::min(things.size(), kMostOnTheWay); ++i) {
      const OnTheWay& thing = things[i];
      QString near = thing.away_m > 0 ? ReportText::tr("%1 beside it").arg(metres(thing.away_m))
                     : thing.here     ? ReportText::tr("the robot is there")
                                      : ReportText::tr("on the path");
      if (!thing.state.empty())
        near = ReportText::tr("%1, %2").arg(near, named(sentences::doorWord(thing.state)));
      page.row({page::figure(metres(thing.along_m)), Cell(nameOf(thing)), Cell(near)});
    }
    page.endTable();
    if (things.size() > kMostOnTheWay)
      page.paragraph(ReportText::tr("Those that are farther away are left out."), Tone::Muted);
  }
  page.paragraph(radius_m > 0
                     ? ReportText::tr("What the path crosses or passes within %1, half the robot's width.")
                           .arg(metres(radius_m))
                     : ReportText::tr("Only what the path crosses: the robot's width is not known."),
                 Tone::Muted);
}

void writeNotKnown(page::Page& page, const Run& run) {
  page.list(notKnown(run));
  std::vector<std::pair<double, std::string>> old;
  for (const auto& [topic, stamp_s] : run.topics) {
    if (run.at_s - stamp_s > kOldS) old.emplace_back(run.at_s - stamp_s, topic);
  }
  if (old.empty()) return;
  std::stable_sort(old.begin(), old.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  page.title(ReportText::tr("Older than %1 s at this time").arg(kOldS));
  page.beginTable({ReportText::tr("Topic"), ReportText::tr("Last message (UTC)"), ReportText::tr("Age")});
  for (std::size_t i = 0; i < std::min(old.size(), kMostTopics); ++i)
    page.row({Cell(named(old[i].second)), Cell(utcText(run.at_s - old[i].first)),
              page::figure(ageText(old[i].first))});
  page.endTable();
  if (old.size() <= kMostTopics) return;
  const auto more = qint64(old.size() - kMostTopics);
  page.paragraph(
      sentences::counted(ReportText::tr("%1 more are not listed.", nullptr, sentences::formOf(more)), more),
      Tone::Muted);
}

QStringList inShort(const Run& run) {
  QStringList all;
  if (run.live.robot_pose) {
    all << ReportText::tr("The robot believed to be at %1.").arg(poseText(*run.live.robot_pose));
  } else {
    all << ReportText::tr("Where the robot believed to be is not known.");
  }
  if (run.live.planning && !run.live.planning->move_state.empty())
    all << ReportText::tr("Its planner: %1.").arg(sentences::plannerWord(run.live.planning->move_state));
  const auto things = thingsOnTheWay(run);
  if (!things.empty())
    all << (things.front().here ? ReportText::tr("It is at %1.").arg(nameOf(things.front()))
                                : ReportText::tr("The next thing on its path is %1, after %2.")
                                      .arg(nameOf(things.front()), metres(things.front().along_m)));
  return all + consistent(run);
}

}  // namespace

QString notWithinReason(const std::string& name, const robot::BagInfo& info, double at_s, bool rounded) {
  constexpr double kSameS = 0.001, kRoundedS = 1;  // as times are written
  if (info.messages.value_or(0) == 0 && info.end_s <= 0)
    return ReportText::tr("%1 holds no messages.").arg(words::plainName(name));
  if (at_s >= info.start_s - kSameS && at_s <= info.end_s + (rounded ? kRoundedS : kSameS)) return {};
  return ReportText::tr("%1: %2 UTC is not within it: it lasts from %3 to %4 UTC.")
      .arg(words::plainName(name), utcText(at_s), utcText(info.start_s), utcText(info.end_s));
}

QString utcText(double epoch_s) {
  if (!std::isfinite(epoch_s) || std::abs(epoch_s) > 4e11) return QStringLiteral("-");
  return words::utcOfMs(qint64(std::floor(epoch_s * 1000 + 0.5)))
      .toString(QStringLiteral("yyyy-MM-dd HH:mm:ss.zzz"));
}

QString nameOf(const OnTheWay& thing) {
  const QString kind = thing.seen_door ? ReportText::tr("Door") : sentences::nameOf(thing.shape, thing.type);
  return thing.name.empty() ? kind : QStringLiteral("%1 %2").arg(kind, named(thing.name));
}

std::vector<NamedJump> namedJumps(const Run& run) {
  const replay::Event *loss = nullptr, *last = nullptr;
  // Far from everything where it is not known.
  double lost_s = run.conditions.poor_since_s.value_or(HUGE_VAL);
  if (isFromTheFirst(map::topicIndex<map::SlamStatus>(), lost_s, run)) lost_s = HUGE_VAL;
  const auto away_s = [&](const replay::Event& event) { return std::abs(event.at_s - lost_s); };
  for (const replay::Event& event : run.events) {
    if (event.kind != replay::EventKind::PositionJump || event.at_s > run.at_s) continue;
    if (away_s(event) <= kWithLossS && (!loss || away_s(event) < away_s(*loss))) loss = &event;
    if (run.at_s - event.at_s <= kBesideS) last = &event;
  }
  std::vector<NamedJump> named;
  if (loss) named.push_back({loss->at_s, loss->metres, true});
  if (last && last != loss) named.push_back({last->at_s, last->metres, false});
  std::stable_sort(named.begin(), named.end(),
                   [](const NamedJump& a, const NamedJump& b) { return a.at_s < b.at_s; });
  return named;
}

QStringList consistent(const Run& run) {
  QStringList all;
  const map::LiveState& live = run.live;
  if (hasFailed(live) && !live.planning->fail_reason.empty())
    all << ReportText::tr("The robot says itself why it failed: %1.")
               .arg(named(sentences::failureWords(live.planning->fail_reason)));
  for (const map::Alert& alert : live.alerts)
    all << ReportText::tr("The robot reports alert %1: %2")
               .arg(QString::number(alert.code),
                    alert.text.empty() ? ReportText::tr("it gives no further text.") : named(alert.text));
  const auto speed = valueAt(run, series::Quantity::Speed);
  const bool stands = speed && *speed < kStandsMPerS;
  if (live.wheels && live.wheels->emergency_stop == true) {
    if (!speed)
      all << ReportText::tr("The emergency stop is pressed.");
    else if (stands)
      all << ReportText::tr("It stands still, which is consistent with the emergency stop that is pressed.");
    else
      all << ReportText::tr("The emergency stop is pressed, and yet its positions change at %1 m/s.")
                 .arg(*speed, 0, 'f', 2);
  }
  const std::vector<OnTheWay> things = thingsOnTheWay(run);
  const bool wants = hasFailed(live) || (live.planning && live.planning->move_state == "moving");
  if (stands && wants && !things.empty() && things.front().along_m <= kAheadM)
    all << ReportText::tr(
               "It stands still although it has a way to go, which is consistent with being held up at %1, "
               "%2 ahead.")
               .arg(nameOf(things.front()), metres(things.front().along_m));
  const auto& poor_since_s = run.conditions.poor_since_s;
  const std::vector<NamedJump> jumps = namedJumps(run);
  for (const NamedJump& jump : jumps) {
    const QString jumped =
        ReportText::tr("Its position jumped by %1 at %2").arg(metres(jump.metres), clockText(jump.at_s, run));
    all << (jump.with_loss ? ReportText::tr("%1, which is consistent with its localization, poor since %2.")
                                 .arg(jumped, clockText(*poor_since_s, run))
            : poor_since_s ? ReportText::tr("%1, which is consistent with the poor localization.").arg(jumped)
                           : ReportText::tr("%1.").arg(jumped));
  }
  if (poor_since_s && jumps.empty())
    all << ReportText::tr("Its localization is poor: it may have been elsewhere.");
  return all;
}

QStringList notKnown(const Run& run) {
  const map::LiveState& live = run.live;
  QStringList all;
  const auto lacks = [&](bool known, const QString& what) {
    if (!known) all << what;
  };
  lacks(live.robot_pose.has_value(), ReportText::tr("Position: the bag holds none up to this time."));
  lacks(live.slam.position_quality || live.slam.reliable,
        ReportText::tr("Position quality: not in the bag up to this time."));
  lacks(valueAt(run, series::Quantity::Speed).has_value(),
        ReportText::tr("Speed: there are too few positions around this time."));
  lacks(live.planning && !live.planning->move_state.empty(),
        ReportText::tr("Planner state: not in the bag up to this time."));
  lacks(live.path.size() > 1 || live.local_path.points.size() > 1,
        ReportText::tr("Path: the bag holds none up to this time."));
  lacks(live.wheels && live.wheels->emergency_stop,
        ReportText::tr("Emergency stop: not in the bag up to this time."));
  lacks(!run.said.empty(), ReportText::tr("Bumpers: the bag has no topic about them up to this time."));
  lacks(live.battery && live.battery->level, ReportText::tr("Battery: not in the bag up to this time."));
  lacks(!live.clouds.empty(), ReportText::tr("Scan: the bag holds none up to this time."));
  lacks(radiusOf(live.model) > 0, ReportText::tr("The robot's outline: not in the bag up to this time."));
  lacks(!run.map_name.empty(),
        ReportText::tr("Map: the bag does not say which one was used up to this time."));
  lacks(!run.overlays.empty(),
        ReportText::tr("Overlays: none are known, so walls, regions and doors may be missing."));
  std::size_t later = 0;
  for (const robot::BagTopic& topic : run.info.topics) {
    if (!run.topics.contains(topic.name) && ++later <= kMostTopics)
      all << ReportText::tr("Topic %1 begins only later.").arg(named(topic.name));
  }
  if (later > kMostTopics) {
    const auto more = qint64(later - kMostTopics);
    all << sentences::counted(
        ReportText::tr("%1 more topics begin only later.", nullptr, sentences::formOf(more)), more);
  }
  if (run.info.interrupted) all << ReportText::tr("The recording was interrupted, or is still going on.");
  return all;
}

bool writeReport(QIODevice& out, const Report& report) {
  const Run& run = report.run;
  page::Page page(out, ReportText::tr("Incident report: %1, %2 UTC").arg(named(run.name), utcText(run.at_s)));
  page.paragraph(
      ReportText::tr(
          "What the recording says about this moment. All times are UTC. What is said to be consistent "
          "was so at the same time; only what the robot says itself is a reason."),
      Tone::Muted);
  if (report.against) {
    QStringList beside{ReportText::tr("Beside it: %1 at %2 UTC.")
                           .arg(named(report.against->name), utcText(report.against->at_s))};
    if (report.against_m)
      beside << (report.nearest
                     ? ReportText::tr("That is when this run came nearest to the same place: %1 away.")
                     : ReportText::tr("Its robot is %1 away from the same place."))
                    .arg(metres(*report.against_m));
    if (report.against->map_name != run.map_name)
      beside << ReportText::tr("The two runs use different maps, so their positions may not fit.");
    page.paragraph(words::paragraph(beside));
  }
  const auto both = [&](const QString& title, const std::function<void(const Run&)>& write) {
    page.section(title);
    if (!report.against) return write(run);
    page.beginColumns();
    for (const Run* const one : {&run, &*report.against}) {
      if (one != &run) page.nextColumn();
      page.title(ReportText::tr("%1, %2").arg(named(one->name), utcText(one->at_s)));
      write(*one);
    }
    page.endColumns();
  };
  both(ReportText::tr("In short"), [&](const Run& one) { page.list(inShort(one)); });
  both(ReportText::tr("Map"), [&](const Run& one) { writeMap(page, one); });
  both(ReportText::tr("What the robot believed"), [&](const Run& one) { writeState(page, one); });
  both(ReportText::tr("Safety"), [&](const Run& one) { writeSafety(page, one); });
  both(ReportText::tr("On the way"), [&](const Run& one) { writeOnTheWay(page, one); });
  both(ReportText::tr("The minute around it"), [&](const Run& one) { writeCurves(page, one); });
  both(ReportText::tr("Events"), [&](const Run& one) { writeEvents(page, one); });
  both(ReportText::tr("Not known"), [&](const Run& one) { writeNotKnown(page, one); });
  return page.end();
}

}  // namespace mapwright::incident
