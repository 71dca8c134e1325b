// The robots and files that were used lately, and what people call them. Secrets are never stored here.
#pragma once

#include <functional>

#include <QDateTime>
#include <QHash>
#include <QString>
#include <QVector>

#include "robot/address.h"
#include "ui/robot/robot_look.h"

class QSettings;

namespace mapwright::ui {

struct RecentRobot {
  QString address;  // normalised, never with a secret
  QString name;     // the robot's own name; may be empty. Untrusted plain text
  RobotLook look;   // the user's
  QDateTime last;
};

/// How a list leads with one, and what stands behind it.
struct RecentWords {
  QString title;   // the user's name for it, else its own, else its host; of a file its name
  QString detail;  // kind and host, the address of one without a name, or the folder of a file
  bool file = false;
};
RecentWords wordsOf(const RecentRobot& robot, const robot::Addresses& addresses);

class RecentRobots {
 public:
  static constexpr int kLimit = 12;
  /// The settings must outlive this.
  RecentRobots(QSettings& settings, robot::Addresses addresses);
  /// The supported ones.
  const robot::Addresses& addresses() const { return addresses_; }
  QVector<RecentRobot> list() const;  // newest first
  /// For those that worked: an address that was only tried is not kept.
  void add(const QString& address, const QDateTime& now);
  void setName(const QString& address, const QString& name);
  /// What an address that has not worked yet is called: known until the program ends, kept once it works.
  void tried(const QString& address, const RobotLook& look);
  /// Nothing for an address that is neither listed nor was tried.
  RobotLook look(const QString& address) const;
  void setLook(const QString& address, const RobotLook& look);
  /// Whether one of those is called so.
  bool isLookOfOne(const RobotLook& look) const;
  void remove(const QString& address);
  /// Told of each that leaves the list.
  void whenForgotten(std::function<void(const QString& address)> forgotten) {
    forgotten_ = std::move(forgotten);
  }

 private:
  void save(const QVector<RecentRobot>& robots);
  QSettings& settings_;
  robot::Addresses addresses_;
  QHash<QString, RobotLook> tried_;
  std::function<void(const QString&)> forgotten_;
};

/// By "host:port", as SHA-256 ("AB:CD:…"): fingerprints are not secret.
class TrustedCertificates {
 public:
  /// The settings must outlive this.
  explicit TrustedCertificates(QSettings& settings);
  /// Empty: none.
  QString of(const QString& host) const;
  void trust(const QString& host, const QString& sha256);
  void forget(const QString& host);

 private:
  QSettings& settings_;
};

}  // namespace mapwright::ui
