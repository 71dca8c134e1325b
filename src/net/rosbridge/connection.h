// One of a client's connections: a WebSocketLink that parses frames and joins fragments.
#pragma once

#include <memory>
#include <string_view>

#include <QObject>
#include <QString>
#include <QUrl>

#include "net/rosbridge/client_options.h"
#include "net/rosbridge/frame.h"
#include "net/web_socket_link.h"

namespace mapwright::net::rosbridge {

/// Something unusable was received. It has no other effect.
enum class Oddity {
  UnreadableFrame,   // too large, too deep, invalid JSON, CBOR or picture
  BadFragment,       // a piece that fits nowhere
  LostFragments,     // a message whose other fragments did not arrive in time, or that was too large
  UnknownOperation,  // the detail names it
  UnknownCall,       // an answer to no call; the detail is its id
  MalformedMessage,  // a publish without topic or msg, an answer without values
};

/// Lives on the thread that made it.
class Connection : public QObject {
  Q_OBJECT
 public:
  /// `options` with its clocks.
  Connection(const QUrl& url, const ClientOptions& options, QObject* parent);

  WebSocketLink& link() { return link_; }
  const WebSocketLink& link() const { return link_; }
  /// Connected, and the credentials were sent: requests may follow.
  bool ready() const { return ready_; }
  /// Not ready, and will not be without another attempt.
  bool down() const;
  void send(const QString& request);  // dropped unless ready
  /// received so far of an incomplete frame or fragmented message
  qint64 arrivingBytes() const { return link_.arrivingBytes() + qint64(joiner_.heldBytes()); }
  bool joining() const { return joiner_.heldMessages() > 0; }
  void expire();

 Q_SIGNALS:
  void becameReady();
  void wasLost();  // it had been ready
  void changed();  // those of the link, after the two above
  void came(const std::shared_ptr<const mapwright::net::rosbridge::Frame>& frame, qint64 bytes,
            double received_s);
  void frameReceived(std::string_view bytes, bool binary, double received_s);
  void odd(mapwright::net::rosbridge::Oddity what, const QString& detail);

 private:
  void follow();
  void start();
  void read(const QByteArray& bytes, Frame::Wire wire);
  void take(const std::shared_ptr<const Frame>& frame, qint64 bytes, double received_s);
  void join(const Field& fragment, double received_s);
  void tellOfLosses();

  ClientOptions options_;
  WebSocketLink link_;
  FragmentJoiner joiner_;
  std::uint64_t losses_told_ = 0;
  bool ready_ = false;
};

}  // namespace mapwright::net::rosbridge
