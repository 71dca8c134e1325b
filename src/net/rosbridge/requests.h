// The frames that a client sends, and the answers to them (rosbridge v2, "call_service", "service_response",
// "subscribe", "unsubscribe", "fragmentation"; rosauth, "auth"). Pure.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QByteArray>
#include <QString>

#include "net/rosbridge/frame.h"

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

/// A JSON object as UTF-8 that is never in memory as a whole. Used on the client's thread.
class ArgsSource {
 public:
  virtual ~ArgsSource() = default;
  /// The total size of all next().
  virtual qint64 bytes() const = 0;
  /// The next part, at least one byte, of any convenient size; not called beyond bytes(). nullopt: cancel
  /// sending; it is not called again.
  virtual std::optional<QByteArray> next() = 0;
};

struct CallRequest {
  std::string service;
  QByteArray args = "{}";  // a JSON object; messages in it must be complete
  /// Instead of `args`, for data too large for one text.
  std::shared_ptr<ArgsSource> made_while_sent = {};
  /// Progress of sending them; called on the client's thread, never from within call().
  std::function<void(qint64 bytes, qint64 of_bytes)> travelled = {};
  /// Progress of the answer in bytes: of whatever is arriving on its connection, so it may be another answer
  /// if several are in progress. Called now and then on the client's thread, never from within call().
  std::function<void(qint64 bytes)> arriving = {};
  std::chrono::milliseconds timeout{10'000};  // for the answer, after the last byte was sent
  bool large = false;  // its answer may be megabytes: uses the connection for large data
};

struct CallAnswer {
  enum class Kind {
    Answered,
    Refused,    // result:false; `words` is the server's text
    TimedOut,   // it was sent, and no answer came in time
    LinkLost,   // the connection was lost, or there was none
    Cancelled,  // by the caller
    Malformed,  // the answer, or the arguments: see `sent`
  };
  Kind kind = Kind::LinkLost;
  std::shared_ptr<const Frame> frame;  // keeps `values` alive
  Field values;                        // Answered: the service's answer
  std::string words;                   // Refused, Malformed: untrusted plain text
  /// It may have reached the robot. Then only Answered says for sure what was done: a service that fails
  /// half-way is Refused as well. A request cut off while being sent has not: no server acts on a partial
  /// one.
  bool sent = false;
};

using Reply = std::function<void(const CallAnswer&)>;

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

/// An id as text, in whatever form the server sent it; nullopt: there is none.
std::optional<QString> idIn(const Field& id);
/// The answer to a call. Its texts are plain and bounded.
CallAnswer readAnswer(const std::shared_ptr<const Frame>& frame);

/// A call whose arguments are made while they are sent, as text frames. One thread; does not send by itself.
class Upload {
 public:
  /// Up to `most_whole_bytes` it is one frame, otherwise fragments of `fragment_bytes` each.
  Upload(const QString& id, const std::string& service, std::shared_ptr<ArgsSource> args,
         qint64 most_whole_bytes, qint64 fragment_bytes);

  /// The next frame; nullopt if done() or cancelled.
  std::optional<QString> next();
  bool done() const { return number_ == count_; }
  bool givenUp() const { return given_up_; }
  /// Of the request as one text, without the overhead of fragments.
  qint64 bytes() const { return bytes_; }
  qint64 handedOut() const { return handed_out_; }

 private:
  /// Buffers data up to `end`.
  bool holdUntil(qint64 end);
  QString framed(const QByteArray& piece) const;

  QString id_;
  std::shared_ptr<ArgsSource> args_;
  QByteArray held_;  // made, and not handed out
  qint64 bytes_ = 0, args_left_ = 0, handed_out_ = 0, piece_ = 0;
  qint64 number_ = 0, count_ = 1;
  bool closed_ = false, given_up_ = false;
};

}  // namespace mapwright::net::rosbridge
