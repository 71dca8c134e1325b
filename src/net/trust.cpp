#include "net/trust.h"

#include <algorithm>

#include <QCryptographicHash>
#include <QFile>
#include <QStringList>

#include "net/openssl_exit.h"
#include "net/plain_sentences.h"

namespace mapwright::net {
namespace {

constexpr qsizetype kSha256Bytes = 32;
constexpr qsizetype kLongestName = 40;
constexpr qint64 kLongestFile = qint64(8) << 20;  // all authorities of a system are much smaller

QString day(const QDateTime& time) { return time.toUTC().date().toString(Qt::ISODate); }

/// Names in certificates are untrusted.
QString shortName(const QString& name) {
  const QString plain = plainText(name);
  return plain.size() > kLongestName ? plain.left(kLongestName - 1) + QChar(u'\u2026') : plain;
}

QString commonName(const QStringList& names, const QStringList& organizations) {
  const QString name = names.value(0).isEmpty() ? organizations.value(0) : names.value(0);
  return shortName(name);
}

QString subjectOf(const QSslCertificate& certificate) {
  return commonName(certificate.subjectInfo(QSslCertificate::CommonName),
                    certificate.subjectInfo(QSslCertificate::Organization));
}

QString issuerOf(const QSslCertificate& certificate) {
  return commonName(certificate.issuerInfo(QSslCertificate::CommonName),
                    certificate.issuerInfo(QSslCertificate::Organization));
}

/// The first name that it is issued for; empty: none.
QString nameOf(const QSslCertificate& certificate) {
  QStringList names = certificate.subjectAlternativeNames().values();
  if (names.isEmpty()) names = certificate.subjectInfo(QSslCertificate::CommonName);
  return names.isEmpty() ? QString() : shortName(names.first());
}

/// What is wrong with `leaf`; in the words of the library where this program has none.
Fault rejectedReason(const QSslCertificate& leaf, const QSslError& error) {
  switch (error.error()) {
    case QSslError::CertificateExpired:
      if (error.certificate() == leaf) return faultOf(fault::CertificateExpired, {day(leaf.expiryDate())});
      return faultOf(faultText("net", "the certificate of its authority expired on %1"),
                     {day(error.certificate().expiryDate())});
    case QSslError::CertificateNotYetValid:
      return faultOf(fault::CertificateNotYetValid, {day(leaf.effectiveDate())});
    case QSslError::HostNameMismatch: {
      const QString name = nameOf(leaf);
      if (name.isEmpty()) return faultText("net", "it was issued without a name");
      return faultOf(fault::CertificateOfOtherName, {name});
    }
    case QSslError::CertificateRevoked:
    case QSslError::CertificateBlacklisted:
      return fault::CertificateWithdrawn;
    case QSslError::SelfSignedCertificate:
      return fault::SelfSigned;
    case QSslError::SelfSignedCertificateInChain:
    case QSslError::UnableToGetIssuerCertificate:
    case QSslError::UnableToGetLocalIssuerCertificate:
    case QSslError::UnableToVerifyFirstCertificate:
    case QSslError::CertificateUntrusted: {
      if (leaf.isSelfSigned()) return fault::SelfSigned;
      const QString issuer = issuerOf(leaf);
      if (issuer.isEmpty()) return faultText("net", "it was issued by an unknown authority");
      return faultOf(fault::AuthorityUnknown, {issuer});
    }
    default:
      return faultOf(fault::Said, {plainText(error.errorString())});
  }
}

bool contains(const std::vector<Fault>& whys, const FaultCode& code) {
  return std::any_of(whys.begin(), whys.end(), [&](const Fault& why) { return why.code == code; });
}

}  // namespace

bool CertificateFault::trustable() const {
  return !sha256.isEmpty() && !contains(whys, fault::CertificateWithdrawn);
}

QString fingerprintText(const QByteArray& sha256) { return QString::fromLatin1(sha256.toHex(':').toUpper()); }

QByteArray fingerprintFrom(const QString& text) {
  const QByteArray bytes = QByteArray::fromHex(text.toLatin1());
  return bytes.size() == kSha256Bytes ? bytes : QByteArray();
}

Fault reasonOf(const CertificateFault& rejected) {
  if (contains(rejected.whys, fault::CertificateIsAnother)) {
    return faultOf(fault::CertificateChanged, {rejected.host, fingerprintText(rejected.pinned_sha256),
                                               fingerprintText(rejected.sha256)});
  }
  Fault reason = faultOf(fault::CertificateUntrusted, {rejected.host, fingerprintText(rejected.sha256)});
  reason.because = rejected.whys;
  return reason;
}

QSslConfiguration configurationFor(const Trust& trust) {
  QSslConfiguration configuration = QSslConfiguration::defaultConfiguration();
  if (!trust.pinned_sha256.isEmpty()) {
    configuration.setCaCertificates({});
  } else if (!trust.authorities.isEmpty()) {
    configuration.setCaCertificates(trust.authorities);
  }
  return configuration;
}

std::optional<CertificateFault> faultOf(const Trust& trust, const QSslCertificate& leaf,
                                        const QList<QSslError>& errors, const QUrl& url) {
  const bool pinned = !trust.pinned_sha256.isEmpty();
  const QByteArray sha256 = leaf.isNull() ? QByteArray() : leaf.digest(QCryptographicHash::Sha256);
  std::vector<Fault> whys;
  if (pinned && sha256 != trust.pinned_sha256) whys.push_back(fault::CertificateIsAnother);
  QList<QSslError::SslError> told;
  for (const QSslError& error : errors) {
    Fault why = rejectedReason(leaf, error);
    // For the pinned certificate itself no error counts, except revocation.
    if (pinned && why.code != fault::CertificateWithdrawn) continue;
    if (!told.contains(error.error()) && !contains(whys, why.code)) whys.push_back(std::move(why));
    told << error.error();
  }
  if (whys.empty()) return std::nullopt;
  return CertificateFault{.host = hostAndPort(url),
                          .whys = std::move(whys),
                          .sha256 = sha256,
                          .pinned_sha256 = trust.pinned_sha256,
                          .subject = subjectOf(leaf),
                          .issuer = issuerOf(leaf),
                          .from = leaf.effectiveDate(),
                          .until = leaf.expiryDate()};
}

tl::expected<QList<QSslCertificate>, Fault> readAuthorities(const QString& file) {
  keepOpensslAtExit();
  QFile source(file);
  if (!source.open(QIODevice::ReadOnly)) {
    return tl::make_unexpected(faultOf(faultText("net", "The certificate file %1 cannot be read: %2."),
                                       {plainText(file), plainText(source.errorString())}));
  }
  const QList<QSslCertificate> certificates = QSslCertificate::fromData(source.read(kLongestFile), QSsl::Pem);
  if (certificates.isEmpty() ||
      std::any_of(certificates.begin(), certificates.end(), [](const auto& one) { return one.isNull(); })) {
    return tl::make_unexpected(faultOf(
        faultText(
            "net",
            "The certificate file %1 contains no certificate in PEM form (-----BEGIN CERTIFICATE-----)."),
        {plainText(file)}));
  }
  return certificates;
}

}  // namespace mapwright::net
