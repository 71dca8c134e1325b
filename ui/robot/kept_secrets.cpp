#include "ui/robot/kept_secrets.h"

#include <utility>

#include <QPointer>
#include <QSettings>

namespace mapwright::ui {

namespace {

QString choiceKey(const QString& server) {
  // A slash would begin a group.
  return QStringLiteral("secretChoices/") + QString(server).replace(QLatin1Char('/'), QLatin1Char('|'));
}

}  // namespace

KeptSecrets::KeptSecrets(QSettings& settings, const robot::Addresses& addresses, keyring::KeyRing* ring,
                         QObject* parent)
    : QObject(parent), settings_(settings), addresses_(addresses), ring_(ring) {}

QString KeptSecrets::serverOf(const QString& address) const {
  const auto parsed = addresses_.parse(address);
  const QString host = parsed ? robot::hostOf(*parsed) : QString();
  return host.isEmpty() ? QString() : (parsed->url.scheme() + QStringLiteral("://") + host).toLower();
}

KeptSecrets::Choice KeptSecrets::choiceFor(const QString& server) const {
  const QString noted = server.isEmpty() ? QString() : settings_.value(choiceKey(server)).toString();
  return noted == QLatin1String("kept")    ? Choice::Kept
         : noted == QLatin1String("never") ? Choice::Never
                                           : Choice::None;
}

void KeptSecrets::saveChoice(const QString& server, Choice choice) {
  if (choice == Choice::None) return settings_.remove(choiceKey(server));
  settings_.setValue(choiceKey(server),
                     choice == Choice::Kept ? QStringLiteral("kept") : QStringLiteral("never"));
}

bool KeptSecrets::kept(const QString& address) const {
  return ring_ && choiceFor(serverOf(address)) == Choice::Kept;
}

bool KeptSecrets::mayAsk(const QString& address) const {
  const QString server = serverOf(address);
  return ring_ && !server.isEmpty() && choiceFor(server) == Choice::None;
}

keyring::KeyRing::Reply KeptSecrets::guarded(keyring::KeyRing::Reply reply) {
  return [self = QPointer<KeptSecrets>(this), reply = std::move(reply)](keyring::KeyRingAnswer answer) {
    if (self && reply) reply(std::move(answer));
  };
}

void KeptSecrets::read(const QString& address, keyring::KeyRing::Reply reply) {
  ring_->read(serverOf(address), guarded(std::move(reply)));
}

void KeptSecrets::keep(const QString& address, const QByteArray& secret, keyring::KeyRing::Reply reply) {
  const QString server = serverOf(address);
  ring_->write(server, secret,
               guarded([this, server, reply = std::move(reply)](keyring::KeyRingAnswer answer) {
                 if (!answer.reason.any()) saveChoice(server, Choice::Kept);
                 reply(std::move(answer));
               }));
}

void KeptSecrets::neverAsk(const QString& address) { saveChoice(serverOf(address), Choice::Never); }

void KeptSecrets::forget(const QString& address, keyring::KeyRing::Reply reply) {
  const QString server = serverOf(address);
  if (server.isEmpty()) return;
  const bool in_ring = ring_ && choiceFor(server) == Choice::Kept;
  saveChoice(server, Choice::None);
  if (in_ring) ring_->remove(server, guarded(std::move(reply)));
}

}  // namespace mapwright::ui

#include "moc_kept_secrets.cpp"
