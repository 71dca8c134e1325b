#include "ui/robot/recent_robots.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSettings>

#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

constexpr int kNameLimit = 80;

/// The one that is missed least: the oldest that has no name of the user's.
qsizetype leastMissed(const QVector<RecentRobot>& robots) {
  for (qsizetype i = robots.size() - 1; i > 0; --i) {
    if (robots[i].look == RobotLook()) return i;
  }
  return robots.size() - 1;
}

}  // namespace

RecentWords wordsOf(const RecentRobot& robot, const robot::Addresses& addresses) {
  const auto parsed = addresses.parse(robot.address);
  RecentWords words;
  words.file = parsed && !parsed->path.isEmpty();
  const QString own = words::plainName(robot.look.called.isEmpty() ? robot.name : robot.look.called);
  if (words.file) {
    const QFileInfo info(parsed->path);
    words.title = robot.look.called.isEmpty() ? words::plainName(info.fileName()) : own;
    words.detail = words::plainName(QDir::toNativeSeparators(info.absolutePath()));
    return words;
  }
  const QString shown = addresses.hostShown(robot.address);
  const QString host = shown.isEmpty() ? robot.address : shown;
  const QString kind = addresses.titleOf(robot.address);
  words.title = own.isEmpty() ? host : own;
  words.detail = own.isEmpty()    ? (shown.isEmpty() ? kind : robot.address)
                 : kind.isEmpty() ? host
                                  : QCoreApplication::translate("window", "%1, %2").arg(kind, host);
  return words;
}

RecentRobots::RecentRobots(QSettings& settings, robot::Addresses addresses)
    : settings_(settings), addresses_(std::move(addresses)) {}

QVector<RecentRobot> RecentRobots::list() const {
  QVector<RecentRobot> robots;
  const int count = std::min(settings_.beginReadArray(QStringLiteral("recentRobots")), kLimit);
  for (int i = 0; i < count; ++i) {
    settings_.setArrayIndex(i);
    RecentRobot robot{settings_.value(QStringLiteral("address")).toString(),
                      settings_.value(QStringLiteral("name")).toString().left(kNameLimit),
                      {settings_.value(QStringLiteral("called")).toString().left(kNameLimit),
                       settings_.value(QStringLiteral("color")).toString()},
                      settings_.value(QStringLiteral("last")).toDateTime()};
    // The file may have been edited: invalid addresses are skipped.
    if (addresses_.parse(robot.address)) robots << robot;
  }
  settings_.endArray();
  return robots;
}

void RecentRobots::add(const QString& address, const QDateTime& now) {
  const auto parsed = addresses_.parse(address);
  if (!parsed) return;
  QVector<RecentRobot> robots = list();
  RecentRobot robot{parsed->text, {}, tried_.take(parsed->text), now};
  for (const RecentRobot& old : robots) {
    if (old.address != robot.address) continue;
    robot.name = old.name;
    robot.look = old.look;
  }
  robots.removeIf([&robot](const RecentRobot& old) { return old.address == robot.address; });
  robots.prepend(robot);
  while (robots.size() > kLimit) {
    const QString gone = robots.takeAt(leastMissed(robots)).address;
    if (forgotten_) forgotten_(gone);
  }
  save(robots);
}

RobotLook RecentRobots::look(const QString& address) const {
  for (const RecentRobot& robot : list()) {
    if (robot.address == address) return robot.look;
  }
  return tried_.value(address);
}

void RecentRobots::tried(const QString& address, const RobotLook& look) {
  const QVector<RecentRobot> robots = list();
  const bool listed = std::any_of(robots.begin(), robots.end(),
                                  [&](const RecentRobot& robot) { return robot.address == address; });
  listed ? setLook(address, look) : (void)tried_.insert(address, look);
}

bool RecentRobots::isLookOfOne(const RobotLook& look) const {
  const QVector<RecentRobot> robots = list();
  return tried_.values().contains(look) ||
         std::any_of(robots.begin(), robots.end(),
                     [&](const RecentRobot& robot) { return robot.look == look; });
}

void RecentRobots::setLook(const QString& address, const RobotLook& look) {
  if (const auto one = tried_.find(address); one != tried_.end()) *one = look;
  QVector<RecentRobot> robots = list();
  for (RecentRobot& robot : robots) {
    if (robot.address == address) robot.look = {look.called.left(kNameLimit), look.color};
  }
  save(robots);
}

void RecentRobots::setName(const QString& address, const QString& name) {
  QVector<RecentRobot> robots = list();
  for (RecentRobot& robot : robots) {
    if (robot.address == address) robot.name = name.left(kNameLimit);
  }
  save(robots);
}

void RecentRobots::remove(const QString& address) {
  tried_.remove(address);
  QVector<RecentRobot> robots = list();
  robots.removeIf([&address](const RecentRobot& robot) { return robot.address == address; });
  save(robots);
  if (forgotten_) forgotten_(address);
  // A forgotten robot is no longer trusted.
  if (const auto parsed = addresses_.parse(address)) {
    TrustedCertificates(settings_).forget(robot::hostOf(*parsed));
  }
}

void RecentRobots::save(const QVector<RecentRobot>& robots) {
  settings_.remove(QStringLiteral("recentRobots"));
  settings_.beginWriteArray(QStringLiteral("recentRobots"), int(robots.size()));
  for (int i = 0; i < robots.size(); ++i) {
    settings_.setArrayIndex(i);
    settings_.setValue(QStringLiteral("address"), robots[i].address);
    settings_.setValue(QStringLiteral("name"), robots[i].name);
    settings_.setValue(QStringLiteral("called"), robots[i].look.called);
    settings_.setValue(QStringLiteral("color"), robots[i].look.color);
    settings_.setValue(QStringLiteral("last"), robots[i].last);
  }
  settings_.endArray();
}

namespace {

QString keyOf(const QString& host) { return QStringLiteral("trustedCertificates/") + host.toLower(); }

}  // namespace

TrustedCertificates::TrustedCertificates(QSettings& settings) : settings_(settings) {}

QString TrustedCertificates::of(const QString& host) const {
  return host.isEmpty() ? QString() : settings_.value(keyOf(host)).toString();
}

void TrustedCertificates::trust(const QString& host, const QString& sha256) {
  if (!host.isEmpty()) settings_.setValue(keyOf(host), sha256);
}

void TrustedCertificates::forget(const QString& host) {
  if (!host.isEmpty()) settings_.remove(keyOf(host));
}

}  // namespace mapwright::ui
