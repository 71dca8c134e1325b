// Builds the frames that a client sends (rosbridge v2, "call_service", "subscribe", "unsubscribe"; rosauth,
// "auth"). Pure functions; each returns one text frame.
#pragma once

#include <optional>
#include <string>

#include <QByteArray>
#include <QString>

namespace mapwright::net::rosbridge {

/// A topic and the options for it.
struct Subscription {
  std::string topic;
  std::string type;     // empty = as known to the server
  int throttle_ms = 0;  // minimum time between two messages; the last is never dropped
  /// How messages are encoded. Servers have a bug: messages with a list of texts are lost with Cbor.
  enum class Compression { None, Cbor, Png } compression = Compression::None;
  bool large = false;  // uses the connection for large data
  bool operator==(const Subscription&) const = default;
};

/// Credentials for rosauth. Kept in memory only, never in a log or sentence.
struct Credentials {
  QByteArray secret;
  QString client, destination;  // addresses, as given to the server
  QString level = QStringLiteral("admin");
  qint64 valid_s = 3600;
};

/// `args` must be a JSON object, otherwise nullopt.
std::optional<QString> callRequest(const QString& id, const std::string& service, const QByteArray& args);
QString subscribeRequest(const QString& id, const Subscription& wanted);
QString unsubscribeRequest(const QString& id, const std::string& topic);
/// The MAC is the SHA-512 of secret, client, destination, rand, time, level and end of validity,
/// concatenated.
QString authRequest(const Credentials& credentials, const QString& rand, qint64 now_s);

/// The error text inside a server's message: for `service [/x] responded with an error: b'…'` the inner text,
/// unescaped; anything else unchanged.
std::string innerWords(const std::string& words);

}  // namespace mapwright::net::rosbridge
