#include "ui/robot/recent_robots.h"

#include <algorithm>
#include <utility>

#include <QSettings>

namespace mapwright::window {

namespace {
constexpr int kNameLimit = 80;
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
  RecentRobot robot{parsed->text, {}, now};
  for (const RecentRobot& old : robots) {
    if (old.address == robot.address) robot.name = old.name;
  }
  robots.removeIf([&robot](const RecentRobot& old) { return old.address == robot.address; });
  robots.prepend(robot);
  if (robots.size() > kLimit) robots.resize(kLimit);
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
  QVector<RecentRobot> robots = list();
  robots.removeIf([&address](const RecentRobot& robot) { return robot.address == address; });
  save(robots);
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

}  // namespace mapwright::window
