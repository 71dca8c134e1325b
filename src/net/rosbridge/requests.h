// What a client writes (rosbridge v2, "call_service", "subscribe", "unsubscribe"; rosauth, "auth"). Pure
// functions; each is one text frame.
#pragma once

#include <optional>
#include <string>

#include <QByteArray>
#include <QString>

namespace mapwright::net::rosbridge {

/// A topic, and how it is wanted.
struct Subscription {
  std::string topic;
  std::string type;     // empty = as the server knows it
  int throttle_ms = 0;  // at least so much time between two; the last is never dropped
  /// How messages travel. One with a list of texts is lost in Cbor: a fault of servers.
  enum class Compression { None, Cbor, Png } compression = Compression::None;
  bool large = false;  // by the connection for large things
  bool operator==(const Subscription&) const = default;
};

/// What rosauth wants to know. Held in memory only, in no log and no sentence.
struct Credentials {
  QByteArray secret;
  QString client, destination;  // addresses, as the server was told them
  QString level = QStringLiteral("admin");
  qint64 valid_s = 3600;
};

/// `args` a JSON object. nullopt: it is none.
std::optional<QString> callRequest(const QString& id, const std::string& service, const QByteArray& args);
QString subscribeRequest(const QString& id, const Subscription& wanted);
QString unsubscribeRequest(const QString& id, const std::string& topic);
/// The MAC is SHA-512 of secret, client, destination, rand, time, level and end of validity, side by side.
QString authRequest(const Credentials& credentials, const QString& rand, qint64 now_s);

/// What a server means by the text that stands for the values of a call that failed: of
/// `service [/x] responded with an error: b'…'` the inner text, its escapes resolved; all else as it is.
std::string innerWords(const std::string& words);

}  // namespace mapwright::net::rosbridge
