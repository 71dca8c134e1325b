// A client of rosbridge v2 (protocol 2.x, of ROS 1 and ROS 2): calls and subscriptions over two connections.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <QObject>
#include <QUrl>

#include "net/rosbridge/fragment_joiner.h"
#include "net/rosbridge/frame.h"
#include "net/rosbridge/requests.h"
#include "net/trust.h"
#include "net/web_socket_link.h"

namespace mapwright::net::rosbridge {

struct ClientOptions {
  WebSocketLinkOptions link;  // of both connections; its max_message_bytes is replaced by the one below
  quint64 max_message_bytes = quint64(256)
                              << 20;       // of a frame, and of the content of its fragments or picture
  FragmentJoiner::Limits fragments;        // its bytes are at most max_message_bytes
  std::optional<Credentials> credentials;  // sent first after each connect
  /// More than about 12 at once can stall a node.
  int calls_at_once = 8;
  /// A call that was given up after sending keeps the server busy: it counts for this long, or until its late
  /// answer.
  std::chrono::milliseconds busy_after_giving_up{20'000};
  /// Limit for a single frame with streamed arguments (ArgsSource); larger ones are sent in fragments. The
  /// servers of ROS 1 and ROS 2 accept 10,000,000 bytes by default.
  qint64 most_whole_bytes = 8'000'000;
  qint64 fragment_bytes = 256 * 1024;
  std::chrono::milliseconds look_every{100};  // how often to check for timeouts
  /// A monotonic clock, and one for seconds since the epoch; empty = the default ones.
  std::function<std::chrono::milliseconds()> now = {};
  std::function<double()> wall_s = {};
};

/// Something unusable was received. It has no other effect.
enum class Oddity {
  UnreadableFrame,   // too large, too deep, invalid JSON, CBOR or picture
  BadFragment,       // a piece that fits nowhere
  LostFragments,     // a message whose other fragments did not arrive in time, or that was too large
  UnknownOperation,  // the detail names it
  UnknownCall,       // an answer to no call; the detail is its id
  MalformedMessage,  // a publish without topic or msg, an answer without values
};

struct TopicMessage {
  std::string topic;  // as it was subscribed
  std::shared_ptr<const Frame> frame;
  Field msg;
  double received_s = 0;  // seconds since the epoch
  qint64 bytes = 0;       // as received: of the frame, or of all its fragments
  bool binary = false;
};

/// Lives on the thread that made it, like its signals and replies. Uses two WebSockets to one server: a quick
/// one (calls, poses) and one for large topics and answers, opened on demand. Do not delete it in a slot of
/// its own signals (use deleteLater); in a reply it is allowed. If the server accepts only one connection,
/// everything uses the quick one.
class Client : public QObject {
  Q_OBJECT
 public:
  /// `url`: ws(s)://host:port[/path].
  Client(const QUrl& url, ClientOptions options, QObject* parent = nullptr);
  ~Client() override;

  void open();  // also "now, do not wait"
  void close();
  void setTrust(const Trust& trust);  // for the next connection
  const WebSocketLink& link() const;  // the quick one: state, reason, fault, certificate, attempt …
  const WebSocketLink& largeLink()
      const;  // Closed until needed, and if the server accepts only one connection

  using Reply = rosbridge::Reply;
  /// The reply is called exactly once, later, never from within call(), and not after the client is gone. At
  /// most ClientOptions::calls_at_once are in progress, the others wait in order. A call waits for a
  /// connection that is being established, but not for one that is lost.
  quint64 call(CallRequest request, Reply reply);
  /// Does nothing if it has been answered. The server continues with a call that was sent.
  void cancel(quint64 call);

  /// One subscription per topic; a second one replaces it, or does nothing if it is the same (unsubscribe
  /// first to get latched messages again). Kept across reconnects, even while closed.
  void subscribe(const Subscription& wanted);
  void unsubscribe(const std::string& topic);
  /// Since the subscription was sent or the last message; nullopt: not subscribed, or not connected.
  std::optional<std::chrono::milliseconds> silentFor(const std::string& topic) const;
  /// The server's own words (untrusted) when it refused the present subscription, such as for a type that it
  /// does not know; empty: it did not, or messages have come since.
  QString refusalOf(const std::string& topic) const;

  quint64 oddities() const;  // number of odd() signals

 Q_SIGNALS:
  void changed();  // state or reason of a connection
  void opened();   // the quick connection is open (again), and its subscriptions were sent again
  void received(const mapwright::net::rosbridge::TopicMessage& message);
  /// The server does not accept a second connection; emitted once. `why`: how it failed.
  void sharesOneConnection(const Fault& why);
  /// The server's own status: level ("error", "warning", …), text, and the id that it refers to. Untrusted.
  void statusReceived(const QString& level, const QString& words, const QString& id);
  void frameReceived(std::string_view bytes, bool binary,
                     double received_s);  // every frame as received, for taps
  void odd(mapwright::net::rosbridge::Oddity what, const QString& detail);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::net::rosbridge
