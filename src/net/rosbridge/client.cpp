#include "net/rosbridge/client.h"

#include <algorithm>
#include <map>

#include <QDateTime>
#include <QTimer>

#include "net/plain_sentences.h"

namespace mapwright::net::rosbridge {
namespace {

using Kind = CallAnswer::Kind;

ClientOptions withClocks(ClientOptions options) {
  if (!options.now) {
    options.now = [] {
      return std::chrono::duration_cast<std::chrono::milliseconds>(
          std::chrono::steady_clock::now().time_since_epoch());
    };
  }
  if (!options.wall_s) {
    options.wall_s = [] { return double(QDateTime::currentMSecsSinceEpoch()) / 1000; };
  }
  return options;
}

/// An id as text, whatever the server made of it.
std::optional<QString> idIn(const Field& id) {
  if (id.isText()) return QString::fromStdString(id.text());
  const std::optional<std::int64_t> whole = id.integer();
  return whole ? std::optional(QString::number(*whole)) : std::nullopt;
}

/// Of a server, for people: bounded, and plain.
std::string plainWords(const std::string& words) {
  return plainText(QString::fromStdString(words)).toStdString();
}

/// What the answer to a call says (rosbridge v2, "service_response").
CallAnswer answerIn(const std::shared_ptr<const Frame>& frame) {
  constexpr qsizetype kShown = 300;
  CallAnswer answer;
  answer.frame = frame;
  answer.sent = true;
  const Field root = frame->root();
  const Field values = root["values"];
  const Field result = root["result"];
  // Old servers say no result of calls that worked.
  const std::optional<bool> worked = result              ? result.flag()
                                     : values.isObject() ? std::optional(true)
                                                         : std::nullopt;
  if (worked == false) {
    answer.kind = Kind::Refused;
    answer.words = values.isText() ? plainWords(innerWords(values.text()))
                   : values        ? plainWords(values.toJson(kShown).toStdString())
                                   : std::string();
  } else if (worked == true && (values.isObject() || values.isNull() || values.isText())) {
    answer.kind = Kind::Answered;
    answer.values = values;
  } else {
    answer.kind = Kind::Malformed;
    answer.words = plainWords(root.toJson(kShown).toStdString());
  }
  return answer;
}

}  // namespace

class Client::Impl {
 public:
  Impl(Client* owner, const QUrl& url, ClientOptions options)
      : owner_(owner),
        options_(withClocks(std::move(options))),
        book_(options_.calls_at_once, options_.busy_after_giving_up),
        quick_(url, options_, nullptr),
        large_(url, options_, nullptr) {
    for (const bool large : {false, true}) listen(large);
    QObject::connect(&look_, &QTimer::timeout, owner_, [this] { look(); });
  }

  void open() {
    quick_.link().open();
    const bool any_large = std::any_of(topics_.begin(), topics_.end(),
                                       [](const auto& topic) { return topic.second.wanted.large; });
    if (any_large) needLarge();
  }

  void close() {
    large_.link().close();
    quick_.link().close();
    advance();
  }

  void setTrust(const Trust& trust) {
    quick_.link().setTrust(trust);
    large_.link().setTrust(trust);
  }

  quint64 call(CallRequest request, Reply reply) {
    if (request.large) needLarge();
    const quint64 number = book_.add(std::move(request), std::move(reply));
    advance();
    return number;
  }

  void cancel(quint64 number) {
    if (const auto taken = book_.cancel(number, options_.now())) {
      CallAnswer answer;
      answer.kind = Kind::Cancelled;
      answer.sent = taken->sent;
      deliver(taken->call, std::move(answer));
      advance();
    }
  }

  void subscribe(const Subscription& wanted) {
    const auto known = topics_.find(wanted.topic);
    if (known != topics_.end() && known->second.wanted == wanted) return;
    if (known != topics_.end()) unsubscribe(wanted.topic);
    topics_[wanted.topic].wanted = wanted;
    if (wanted.large) needLarge();
    // Opening may have told others, who may have changed their mind.
    if (const auto topic = topics_.find(wanted.topic); topic != topics_.end() && topic->second.id.isEmpty()) {
      send(topic->second);
    }
  }

  void unsubscribe(const std::string& topic) {
    const auto known = topics_.find(topic);
    if (known == topics_.end()) return;
    if (!known->second.id.isEmpty()) {
      connection(known->second.wanted.large).send(unsubscribeRequest(known->second.id, topic));
    }
    topics_.erase(known);
  }

  std::optional<std::chrono::milliseconds> silentFor(const std::string& topic) const {
    const auto known = topics_.find(topic);
    if (known == topics_.end() || known->second.id.isEmpty()) return std::nullopt;
    return options_.now() - known->second.since;
  }

  std::optional<std::string> topicOf(const QString& id) const {
    for (const auto& [topic, state] : topics_) {
      if (!id.isEmpty() && state.id == id) return topic;
    }
    return std::nullopt;
  }

  const WebSocketLink& link(bool large) const { return large ? large_.link() : quick_.link(); }
  quint64 oddities() const { return oddities_; }

 private:
  struct Topic {
    Subscription wanted;
    QString id;  // empty: not sent
    std::chrono::milliseconds since{0};
  };

  Connection& connection(bool large) { return large ? large_ : quick_; }

  void listen(bool large) {
    Connection& heard = connection(large);
    QObject::connect(&heard, &Connection::becameReady, owner_, [this, large] { begin(large); });
    QObject::connect(&heard, &Connection::wasLost, owner_, [this, large] { lose(large); });
    QObject::connect(&heard, &Connection::changed, owner_, [this] {
      advance();
      Q_EMIT owner_->changed();
    });
    QObject::connect(&heard, &Connection::came, owner_,
                     [this, large](const std::shared_ptr<const Frame>& frame, qint64 bytes,
                                   double received_s) { take(frame, bytes, received_s, large); });
    QObject::connect(&heard, &Connection::frameReceived, owner_,
                     [this](std::string_view bytes, bool binary, double received_s) {
                       Q_EMIT owner_->frameReceived(bytes, binary, received_s);
                       lookLater();
                     });
    QObject::connect(&heard, &Connection::odd, owner_,
                     [this](Oddity what, const QString& detail) { tell(what, detail); });
  }

  /// The second connection follows the first: what is closed stays closed.
  void needLarge() {
    const bool closed = quick_.link().state() == WebSocketLink::State::Closed;
    if (!closed && large_.down()) large_.link().open();
  }

  void begin(bool large) {
    for (auto& [topic, state] : topics_) {
      if (state.wanted.large == large) send(state);
    }
    advance();
    if (!large) Q_EMIT owner_->opened();
  }

  void lose(bool large) {
    for (auto& [topic, state] : topics_) {
      if (state.wanted.large == large) state.id.clear();
    }
    for (const CallBook::Call& call : book_.lost(large)) fail(call, Kind::LinkLost, true);
  }

  void send(Topic& topic) {
    Connection& by = connection(topic.wanted.large);
    if (!by.ready()) return;
    topic.id = QLatin1Char('s') + QString::number(++last_subscription_);
    topic.since = options_.now();
    by.send(subscribeRequest(topic.id, topic.wanted));
  }

  /// Sends what can be sent, and fails what cannot.
  void advance() {
    const auto next = [this](const CallBook::Call& call) {
      const Connection& by = connection(call.request.large);
      return by.ready() ? CallBook::Next::Send : by.down() ? CallBook::Next::Fail : CallBook::Next::Wait;
    };
    const auto send = [this](const CallBook::Call& call) {
      const std::optional<QString> request =
          callRequest(CallBook::idOf(call.number), call.request.service, call.request.args);
      if (request) connection(call.request.large).send(*request);
      return request.has_value();
    };
    for (const CallBook::Call& call : book_.advance(next, send, options_.now())) {
      fail(call, connection(call.request.large).ready() ? Kind::Malformed : Kind::LinkLost, false);
    }
    lookLater();
  }

  void take(const std::shared_ptr<const Frame>& frame, qint64 bytes, double received_s, bool large) {
    const std::string operation = frame->root()["op"].text();
    if (operation == "publish") {
      takeMessage(frame, bytes, received_s, large);
    } else if (operation == "service_response") {
      takeAnswer(frame, large);
    } else if (operation == "status") {
      takeStatus(frame->root(), large);
    } else {
      tell(Oddity::UnknownOperation, plainText(QString::fromStdString(operation)));
    }
  }

  void takeMessage(const std::shared_ptr<const Frame>& frame, qint64 bytes, double received_s, bool large) {
    const std::string name = frame->root()["topic"].text();
    TopicMessage message;
    message.msg = frame->root()["msg"];
    if (name.empty() || !message.msg.isObject()) {
      tell(Oddity::MalformedMessage, plainText(QString::fromStdString(name)));
      return;
    }
    auto topic = topics_.find(name);
    if (topic == topics_.end()) topic = topics_.find(name.front() == '/' ? name.substr(1) : '/' + name);
    // Of a topic that was unsubscribed, or of its former subscription: under way as that was sent.
    if (topic == topics_.end() || topic->second.wanted.large != large) return;
    topic->second.since = options_.now();
    message.topic = topic->first;
    message.frame = frame;
    message.received_s = received_s;
    message.bytes = bytes;
    message.binary = frame->wire() == Frame::Wire::Binary;
    Q_EMIT owner_->received(message);
  }

  void takeAnswer(const std::shared_ptr<const Frame>& frame, bool large) {
    const std::optional<QString> id = idIn(frame->root()["id"]);
    const CallBook::Answered answered = book_.answered(id, frame->root()["service"].text(), large);
    if (answered.call) {
      deliver(*answered.call, answerIn(frame));
    } else if (!answered.late) {
      tell(Oddity::UnknownCall, plainText(id.value_or(QString())));
    }
    advance();
  }

  void takeStatus(const Field& status, bool large) {
    const QString level = plainText(QString::fromStdString(status["level"].text()));
    const QString words = plainText(QString::fromStdString(status["msg"].text()));
    const std::optional<QString> id = idIn(status["id"]);
    if (id && level == QLatin1String("error")) {
      // Instead of an answer: what was asked for could not be understood.
      if (const CallBook::Answered answered = book_.answered(id, {}, large); answered.call) {
        CallAnswer answer;
        answer.kind = Kind::Refused;
        answer.words = words.toStdString();
        answer.sent = true;
        deliver(*answered.call, std::move(answer));
        advance();
      }
    }
    Q_EMIT owner_->statusReceived(level, words, plainText(id.value_or(QString())));
  }

  void look() {
    quick_.expire();
    large_.expire();
    for (const CallBook::Call& call : book_.timedOut(options_.now())) fail(call, Kind::TimedOut, true);
    advance();
    if (!needsLooks()) look_.stop();
  }

  bool needsLooks() const { return book_.hasSent() || quick_.joining() || large_.joining(); }

  void lookLater() {
    if (!look_.isActive() && needsLooks()) look_.start(options_.look_every);
  }

  void fail(const CallBook::Call& call, Kind kind, bool sent) {
    CallAnswer answer;
    answer.kind = kind;
    answer.sent = sent;
    deliver(call, std::move(answer));
  }

  void deliver(const CallBook::Call& call, CallAnswer answer) {
    if (!call.reply) return;
    QMetaObject::invokeMethod(
        owner_, [reply = call.reply, answer = std::move(answer)] { reply(answer); }, Qt::QueuedConnection);
  }

  void tell(Oddity what, const QString& detail) {
    ++oddities_;
    Q_EMIT owner_->odd(what, detail);
  }

  Client* owner_;
  ClientOptions options_;
  CallBook book_;
  std::map<std::string, Topic> topics_;
  quint64 last_subscription_ = 0;
  quint64 oddities_ = 0;
  QTimer look_;
  Connection quick_, large_;  // the first to go
};

Client::Client(const QUrl& url, ClientOptions options, QObject* parent)
    : QObject(parent), impl_(std::make_unique<Impl>(this, url, std::move(options))) {}

Client::~Client() = default;

void Client::open() { impl_->open(); }
void Client::close() { impl_->close(); }
void Client::setTrust(const Trust& trust) { impl_->setTrust(trust); }
const WebSocketLink& Client::link() const { return impl_->link(false); }
const WebSocketLink& Client::largeLink() const { return impl_->link(true); }
quint64 Client::call(CallRequest request, Reply reply) {
  return impl_->call(std::move(request), std::move(reply));
}
void Client::cancel(quint64 call) { impl_->cancel(call); }
void Client::subscribe(const Subscription& wanted) { impl_->subscribe(wanted); }
void Client::unsubscribe(const std::string& topic) { impl_->unsubscribe(topic); }
std::optional<std::chrono::milliseconds> Client::silentFor(const std::string& topic) const {
  return impl_->silentFor(topic);
}
std::optional<std::string> Client::topicOf(const QString& subscription_id) const {
  return impl_->topicOf(subscription_id);
}
quint64 Client::oddities() const { return impl_->oddities(); }

}  // namespace mapwright::net::rosbridge
