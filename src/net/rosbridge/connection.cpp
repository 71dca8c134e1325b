#include "net/rosbridge/connection.h"

#include <algorithm>

#include <QRandomGenerator>

#include "net/plain_sentences.h"

namespace mapwright::net::rosbridge {
namespace {

WebSocketLinkOptions linkOptions(const ClientOptions& options) {
  WebSocketLinkOptions link = options.link;
  link.max_message_bytes = options.max_message_bytes;
  return link;
}

FragmentJoiner::Limits joinerLimits(const ClientOptions& options) {
  FragmentJoiner::Limits limits = options.fragments;
  limits.bytes = std::min(limits.bytes, std::size_t(options.max_message_bytes));
  return limits;
}

QString randomText() {
  return QString::number(QRandomGenerator::system()->generate64(), 16) +
         QString::number(QRandomGenerator::system()->generate64(), 16);
}

}  // namespace

Connection::Connection(const QUrl& url, const ClientOptions& options, QObject* parent)
    : QObject(parent),
      options_(options),
      link_({url}, QByteArray(), linkOptions(options)),
      joiner_(joinerLimits(options)) {
  connect(&link_, &WebSocketLink::changed, this, &Connection::follow);
  connect(&link_, &WebSocketLink::opened, this, &Connection::start);
  connect(&link_, &WebSocketLink::textReceived, this,
          [this](const QByteArray& utf8) { read(utf8, Frame::Wire::Text); });
  connect(&link_, &WebSocketLink::binaryReceived, this,
          [this](const QByteArray& bytes) { read(bytes, Frame::Wire::Binary); });
}

bool Connection::down() const {
  return link_.state() == WebSocketLink::State::Closed || link_.state() == WebSocketLink::State::Waiting;
}

void Connection::send(const QString& request) {
  if (ready_) link_.sendText(request);
}

void Connection::expire() {
  joiner_.expire(options_.now());
  tellOfLosses();
}

void Connection::follow() {
  if (ready_ && link_.state() != WebSocketLink::State::Open) {
    ready_ = false;
    joiner_.clear();
    Q_EMIT wasLost();
  }
  Q_EMIT changed();
}

void Connection::start() {
  ready_ = true;
  if (options_.credentials) {
    link_.sendText(authRequest(*options_.credentials, randomText(), qint64(options_.wall_s())));
  }
  Q_EMIT becameReady();
}

void Connection::read(const QByteArray& bytes, Frame::Wire wire) {
  const double received_s = options_.wall_s();
  Q_EMIT frameReceived({bytes.constData(), std::size_t(bytes.size())}, wire == Frame::Wire::Binary,
                       received_s);
  const auto frame = Frame::read(bytes, wire, {std::size_t(options_.max_message_bytes)});
  if (frame->fault() == Frame::Fault::None && frame->root()["op"].text() == "fragment") {
    join(frame->root(), received_s);
  } else {
    take(frame, bytes.size(), received_s);
  }
}

void Connection::join(const Field& fragment, double received_s) {
  const auto joined = joiner_.take(fragment, options_.now());
  if (!joined) {
    Q_EMIT odd(Oddity::BadFragment, plainText(QString::fromStdString(fragment["id"].text())));
  }
  tellOfLosses();
  if (joined && *joined) {
    const QByteArray text = **joined;
    take(Frame::read(text, Frame::Wire::Text, {std::size_t(options_.max_message_bytes)}), text.size(),
         received_s);
  }
}

void Connection::take(const std::shared_ptr<const Frame>& frame, qint64 bytes, double received_s) {
  if (frame->fault() != Frame::Fault::None) {
    Q_EMIT odd(Oddity::UnreadableFrame, {});
  } else {
    Q_EMIT came(frame, bytes, received_s);
  }
}

void Connection::tellOfLosses() {
  while (losses_told_ < joiner_.dropped()) {
    ++losses_told_;
    Q_EMIT odd(Oddity::LostFragments, {});
  }
}

}  // namespace mapwright::net::rosbridge

#include "moc_connection.cpp"
