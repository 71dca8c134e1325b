#include "keyring/key_ring.h"

#include <utility>

#include <QFileInfo>
#include <QObject>
#include <QStandardPaths>
#include <qt6keychain/keychain.h>

#include "keyring/faults.h"

namespace mapwright::keyring {
namespace {

/// Key rings are reached by the session's D-Bus.
bool hasSessionBus() {
  return !qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS") ||
         QFileInfo::exists(QStandardPaths::writableLocation(QStandardPaths::RuntimeLocation) +
                           QStringLiteral("/bus"));
}

Fault faultOf(const QKeychain::Job& job) {
  switch (job.error()) {
    case QKeychain::NoError:
    case QKeychain::EntryNotFound:
      return {};
    case QKeychain::NoBackendAvailable:
    case QKeychain::NotImplemented:
      return {fault::NoKeyRing};
    case QKeychain::AccessDenied:
    case QKeychain::AccessDeniedByUser:
      return {fault::KeyRingDenied};
    case QKeychain::CouldNotDeleteEntry:
    case QKeychain::OtherError:
      break;
  }
  if (!hasSessionBus()) return {fault::NoKeyRing};
  if (job.errorString().trimmed().isEmpty()) return {faultText("keyring", "the key ring does not answer")};
  return {faultText("keyring", "the key ring answered: %1"), {job.errorString().left(300).toStdString()}};
}

class SystemKeyRing : public KeyRing {
 public:
  void read(const QString& name, Reply reply) override {
    auto* const job = new QKeychain::ReadPasswordJob(QStringLiteral("mapwright"));
    start(job, name, [job, reply = std::move(reply)] { reply({job->binaryData(), faultOf(*job)}); });
  }
  void write(const QString& name, const QByteArray& secret, Reply reply) override {
    auto* const job = new QKeychain::WritePasswordJob(QStringLiteral("mapwright"));
    job->setBinaryData(secret);
    start(job, name, [job, reply = std::move(reply)] { reply({{}, faultOf(*job)}); });
  }
  void remove(const QString& name, Reply reply) override {
    auto* const job = new QKeychain::DeletePasswordJob(QStringLiteral("mapwright"));
    start(job, name, [job, reply = std::move(reply)] { reply({{}, faultOf(*job)}); });
  }

 private:
  void start(QKeychain::Job* job, const QString& name, std::function<void()> done) {
    job->setInsecureFallback(false);  // never into a file
    job->setKey(name);
    QObject::connect(job, &QKeychain::Job::finished, &context_, std::move(done));
    job->start();  // deletes itself
  }

  QObject context_;
};

}  // namespace

std::unique_ptr<KeyRing> systemKeyRing() { return std::make_unique<SystemKeyRing>(); }

}  // namespace mapwright::keyring
