#include "app/robot_access.h"

#include <QFile>

#include "app/command_text.h"
#include "app/robot_factory.h"
#include "sentences/fault_sentence.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

constexpr qint64 kLongest = 4096;

using words::text;

tl::expected<QByteArray, QString> checked(const QByteArray& secret) {
  if (secret.size() > kLongest || secret.contains('\n') || secret.contains('\r') || secret.contains('\0')) {
    return tl::make_unexpected(Text::tr("The secret must be one line of at most 4096 bytes."));
  }
  return secret;
}

/// The server of a robot; empty for other addresses (files, the demo) and invalid ones.
QUrl originOf(const QString& address) {
  const auto parsed = knownAddresses().parse(address);
  return parsed ? parsed->url : QUrl();
}

}  // namespace

tl::expected<QByteArray, QString> readSecret(const QString& file) {
  QFile source(file);
  if (!source.open(QIODevice::ReadOnly)) {
    return tl::make_unexpected(
        Text::tr("The secret file %1 cannot be read: %2.").arg(file, source.errorString()));
  }
  return checked(source.read(kLongest + 1).trimmed());
}

tl::expected<RobotAccess, QString> RobotAccess::read(const AccessArguments& args, const QString& robot) {
  RobotAccess access;
  for (const auto& [address, file] : args.secret_files_for) {
    const auto parsed = knownAddresses().parse(text(address));
    if (!parsed) return tl::make_unexpected(QStringLiteral("--secret-file-for: ") + parsed.error());
    const QUrl origin = parsed->url;
    if (origin.isEmpty()) {
      return tl::make_unexpected(
          Text::tr("--secret-file-for %1: give the address of a robot, followed by the file.")
              .arg(text(address)));
    }
    const auto secret = readSecret(text(file));
    if (!secret) return passOn(secret);
    access.secrets_.emplace_back(origin, *secret);
  }
  if (!args.secret_file.empty()) {
    const auto secret = readSecret(text(args.secret_file));
    if (!secret) return passOn(secret);
    if (robot.isEmpty()) {
      return tl::make_unexpected(
          Text::tr("--secret-file needs --robot. For another robot pass --secret-file-for ADDRESS FILE."));
    }
    access.secrets_.emplace_back(originOf(robot), *secret);
  } else if (const QByteArray given = qgetenv("MAPWRIGHT_SECRET").trimmed(); !given.isEmpty()) {
    const auto secret = checked(given);
    if (!secret) return passOn(secret);
    const QString owner = qEnvironmentVariable("MAPWRIGHT_ROBOT");
    access.secrets_.emplace_back(originOf(owner.isEmpty() ? robot : owner), *secret);
  }
  if (!args.ca_file.empty()) {
    const auto authorities = net::readAuthorities(text(args.ca_file));
    if (!authorities) return tl::make_unexpected(sentences::wordsOf(authorities.error()));
    access.trust_.authorities = QSslConfiguration::systemCaCertificates() + *authorities;
  }
  return access;
}

Access RobotAccess::forAddress(const QString& address) const {
  Access access;
  access.trust = trust_;
  const QUrl origin = originOf(address);
  for (const net::Secret& secret : secrets_) {
    access.secret = secret.forUrl(origin);
    if (!access.secret.isEmpty()) break;
  }
  return access;
}

QString notConnectedReason(const robot::ConnectionState& state) {
  const QString reason = sentences::wordsOf(state.reason);
  if (!state.certificate) return reason;
  return reason + Text::tr(". If it is signed by your own authority, pass --ca-file PEM.");
}

}  // namespace mapwright::app
