#include "ui/robot/trusted_certificates.h"

#include <QSettings>

namespace mapwright::window {

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
