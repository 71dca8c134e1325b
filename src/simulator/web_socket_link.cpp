#include "simulator/web_socket_link.h"

#include <boost/beast/websocket.hpp>

#include "simulator/boost_sockets.h"

namespace mapwright::simulator {
namespace {

namespace websocket = boost::beast::websocket;

constexpr auto kHandshake = std::chrono::seconds(10);

}  // namespace

struct WebSocketLink::Wire {
  explicit Wire(Socket socket) : stream(std::move(socket)) {}

  boost::beast::websocket::stream<Stream, false> stream;
  boost::beast::flat_buffer buffer;
  HttpParser parser;
  Handshake handshake;
};

WebSocketLink::WebSocketLink(Connection& connection, std::size_t most_message_bytes,
                             std::size_t most_queued_bytes)
    : wire_(std::make_unique<Wire>(std::move(connection.socket))), most_queued_bytes_(most_queued_bytes) {
  websocket::stream_base::timeout timeout{};
  timeout.handshake_timeout = kHandshake;
  timeout.idle_timeout = websocket::stream_base::none();
  timeout.keep_alive_pings = false;
  wire_->stream.set_option(timeout);
  wire_->stream.read_message_max(most_message_bytes);
}

WebSocketLink::~WebSocketLink() = default;

void WebSocketLink::accept() {
  wire_->stream.next_layer().expires_after(kHandshake);
  readHttp(wire_->stream.next_layer(), wire_->buffer, wire_->parser,
           [self = shared_from_this()](ErrorCode error, std::size_t) {
             self->wire_->stream.next_layer().expires_never();
             if (!error) self->accept({self->wire_->parser.release()});
           });
}

void WebSocketLink::accept(Handshake handshake) {
  wire_->handshake = std::move(handshake);
  wire_->stream.async_accept(wire_->handshake.request, Waited([self = shared_from_this()](ErrorCode error) {
                               if (error) return;
                               self->open_ = true;
                               if (self->opened()) self->read();
                             }));
}

void WebSocketLink::read() {
  wire_->stream.async_read(wire_->buffer,
                           Transferred([self = shared_from_this()](ErrorCode error, std::size_t) {
                             if (error) {
                               self->open_ = false;
                               return self->gone();
                             }
                             const auto bytes = self->wire_->buffer.data();
                             const std::string text(static_cast<const char*>(bytes.data()), bytes.size());
                             self->wire_->buffer.consume(self->wire_->buffer.size());
                             self->take(text, self->wire_->stream.got_text());
                             if (self->open_) self->read();
                           }));
}

void WebSocketLink::send(Frame frame) {
  if (!open_) return;
  outgoing_bytes_ += frame.bytes->size();
  if (outgoing_bytes_ > most_queued_bytes_) return cut();
  outgoing_.push_back(std::move(frame));
  if (outgoing_.size() == 1) write();
}

void WebSocketLink::write() {
  wire_->stream.binary(outgoing_.front().binary);
  wire_->stream.async_write(boost::asio::buffer(*outgoing_.front().bytes),
                            Transferred([self = shared_from_this()](ErrorCode error, std::size_t) {
                              if (error) return self->cut();
                              self->outgoing_bytes_ -= self->outgoing_.front().bytes->size();
                              self->outgoing_.pop_front();
                              if (!self->outgoing_.empty()) self->write();
                            }));
}

void WebSocketLink::cut() {
  open_ = false;
  gone();
  shutDown(wire_->stream.next_layer());
}

}  // namespace mapwright::simulator
