// Secrets that people keep in the key ring of the system, by the server that they belong to. The settings
// hold only for which servers there is one, so that nothing else is ever asked for.
#pragma once

#include <functional>

#include <QByteArray>
#include <QObject>
#include <QString>

#include "keyring/key_ring.h"
#include "robot/address.h"

class QSettings;

namespace mapwright::ui {

class KeptSecrets : public QObject {
  Q_OBJECT
 public:
  /// `ring` null: nothing is kept, and nobody is asked. All outlive this.
  KeptSecrets(QSettings& settings, const robot::Addresses& addresses, keyring::KeyRing* ring,
              QObject* parent = nullptr);

  bool kept(const QString& address) const;
  /// Whether to ask whether the secret should be kept.
  bool mayAsk(const QString& address) const;
  /// Later, once. Not after this is gone.
  void read(const QString& address, keyring::KeyRing::Reply reply);
  void keep(const QString& address, const QByteArray& secret, keyring::KeyRing::Reply reply);
  void neverAsk(const QString& address);
  /// Of this server nothing stays, nor that nobody should ask.
  void forget(const QString& address, keyring::KeyRing::Reply reply = {});

 private:
  enum class Choice { None, Kept, Never };
  /// "http://192.0.2.7:8090"; empty: it belongs to no server.
  QString serverOf(const QString& address) const;
  Choice choiceFor(const QString& server) const;
  void saveChoice(const QString& server, Choice choice);
  keyring::KeyRing::Reply guarded(keyring::KeyRing::Reply reply);

  QSettings& settings_;
  const robot::Addresses& addresses_;
  keyring::KeyRing* ring_;
};

}  // namespace mapwright::ui
