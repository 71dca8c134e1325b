// The certificates that the user decided to trust, one per robot.
#pragma once

#include <QString>

class QSettings;

namespace mapwright::window {

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
