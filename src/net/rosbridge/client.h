// A client of rosbridge v2 (protocol 2.x, of ROS 1 and ROS 2): calls and subscriptions over two connections.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <QObject>
#include <QUrl>

#include "net/rosbridge/call_book.h"
#include "net/rosbridge/client_options.h"
#include "net/rosbridge/connection.h"
#include "net/rosbridge/frame.h"
#include "net/rosbridge/requests.h"
#include "net/trust.h"
#include "net/web_socket_link.h"

namespace mapwright::net::rosbridge {

struct TopicMessage {
  std::string topic;  // as it was subscribed
  std::shared_ptr<const Frame> frame;
  Field msg;
  double received_s = 0;  // seconds since the epoch
  qint64 bytes = 0;       // as it came: of the frame, or of all its pieces
  bool binary = false;
};

/// Lives on the thread that made it, like its signals and replies. Two WebSockets to one server: a quick one
/// (calls, poses) and one for large topics and answers, opened when something large is first wanted. Not to
/// be deleted in a slot of its own signals (deleteLater); in a reply it may be. A server that takes one
/// connection only gets one: everything goes by the quick one then.
class Client : public QObject {
  Q_OBJECT
 public:
  /// `url`: ws(s)://host:port[/path].
  Client(const QUrl& url, ClientOptions options, QObject* parent = nullptr);
  ~Client() override;

  void open();  // also "now, do not wait"
  void close();
  void setTrust(const Trust& trust);       // for the next connection
  const WebSocketLink& link() const;       // the quick one: state, reason, fault, certificate, attempt …
  const WebSocketLink& largeLink() const;  // Closed until it is needed, and while one has to do

  using Reply = rosbridge::Reply;
  /// The reply comes exactly once, later, never from within call(), and not after the client is gone. At most
  /// ClientOptions::calls_at_once are under way, the others wait in order. A call waits for a connection that
  /// is being made, but not for one that is lost.
  quint64 call(CallRequest request, Reply reply);
  /// Nothing for one that has been answered. The server goes on with one that was sent.
  void cancel(quint64 call);

  /// Once a topic; again = replaced, or nothing if it is the same (unsubscribe first to have what is latched
  /// sent again). Kept over reconnects, closed or not.
  void subscribe(const Subscription& wanted);
  void unsubscribe(const std::string& topic);
  /// Since the subscription was sent or the last message; nullopt: not subscribed, or not connected.
  std::optional<std::chrono::milliseconds> silentFor(const std::string& topic) const;
  /// The topic of a subscription's id, as in statusReceived().
  std::optional<std::string> topicOf(const QString& subscription_id) const;

  quint64 oddities() const;  // how many odd() have told of

 Q_SIGNALS:
  void changed();  // state or reason of a link
  void opened();   // the quick one is (again) open: its subscriptions have been sent again
  void received(const mapwright::net::rosbridge::TopicMessage& message);
  /// The server takes no second connection; told once. `why`: what became of it.
  void sharesOneConnection(const Fault& why);
  /// The server's opinion: level ("error", "warning", …), words, and the id of what it is about. Untrusted.
  void statusReceived(const QString& level, const QString& words, const QString& id);
  void frameReceived(std::string_view bytes, bool binary,
                     double received_s);  // every frame as it came, for taps
  void odd(mapwright::net::rosbridge::Oddity what, const QString& detail);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::net::rosbridge
