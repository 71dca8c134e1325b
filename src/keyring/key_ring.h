// Secrets in the key ring of the system, and nowhere else.
#pragma once

#include <functional>
#include <memory>

#include <QByteArray>
#include <QString>

#include "fault/fault.h"

namespace mapwright::keyring {

struct KeyRingAnswer {
  QByteArray secret;  // of read(); empty: there is none
  Fault reason;       // why it could not be done; None = it was
};

/// Used on the GUI thread. A system's key ring may ask its user for a password, so answers can take long.
class KeyRing {
 public:
  /// Called once, later, never from within the request; not after the key ring is gone.
  using Reply = std::function<void(KeyRingAnswer)>;
  virtual ~KeyRing() = default;
  virtual void read(const QString& name, Reply reply) = 0;
  virtual void write(const QString& name, const QByteArray& secret, Reply reply) = 0;
  /// One that is not there counts as removed.
  virtual void remove(const QString& name, Reply reply) = 0;
};

/// That of the desktop: GNOME Keyring, KWallet and others.
std::unique_ptr<KeyRing> systemKeyRing();

}  // namespace mapwright::keyring
