// The recently used robots. Only addresses: secrets are never stored.
#pragma once

#include <QDateTime>
#include <QString>
#include <QVector>

#include "robot/address.h"

class QSettings;

namespace mapwright::window {

struct RecentRobot {
  QString address;  // normalised, never with a secret
  QString name;     // the robot's own name; may be empty. Untrusted plain text
  QDateTime last;
};

class RecentRobots {
 public:
  static constexpr int kLimit = 12;
  /// The settings must outlive this.
  RecentRobots(QSettings& settings, robot::Addresses addresses);
  /// The supported ones.
  const robot::Addresses& addresses() const { return addresses_; }
  QVector<RecentRobot> list() const;  // newest first
  void add(const QString& address, const QDateTime& now);
  void setName(const QString& address, const QString& name);
  void remove(const QString& address);

 private:
  void save(const QVector<RecentRobot>& robots);
  QSettings& settings_;
  robot::Addresses addresses_;
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

}  // namespace mapwright::window
