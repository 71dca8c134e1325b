#include "net/rosbridge/client.h"

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <utility>

#include <QDateTime>
#include <QLoggingCategory>
#include <QTimer>

#include "net/plain_sentences.h"
#include "net/rosbridge/read_answer.h"

namespace mapwright::net::rosbridge {
namespace {

Q_LOGGING_CATEGORY(lcRosbridge, "mapwright.rosbridge", QtWarningMsg)

using Kind = CallAnswer::Kind;

std::string lineOf(const CallAnswer& answer) {
  switch (answer.kind) {
    case Kind::Answered:
      return "answered";
    case Kind::Refused:
      return "refused: " + answer.words;
    case Kind::TimedOut:
      return "timed out";
    case Kind::LinkLost:
      return "connection lost";
    case Kind::Cancelled:
      return "cancelled";
    case Kind::Malformed:
      break;
  }
  return (answer.sent ? "unreadable answer: " : "not sent: ") + answer.words;
}

const char* lineOf(Oddity oddity) {
  switch (oddity) {
    case Oddity::UnreadableFrame:
      return "unreadable frame";
    case Oddity::BadFragment:
      return "stray fragment";
    case Oddity::LostFragments:
      return "lost fragments";
    case Oddity::UnknownOperation:
      return "unknown op";
    case Oddity::UnknownCall:
      return "unknown call";
    case Oddity::MalformedMessage:
      break;
  }
  return "malformed message";
}

/// A connection that goes so soon after the other one came may have had to make way for it.
constexpr std::chrono::milliseconds kSoonLost{2'000};
constexpr int kMostStrikes = 2;
/// Limit for data not yet sent; more would delay pings and other calls.
constexpr qint64 kMostUnsent = 512 * 1024;

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

  void open() { quick_.link().open(); }

  void close() {
    closing_ = true;
    large_.link().close();
    quick_.link().close();
    closing_ = false;
    // There may be another server the next time.
    sharing_ = Sharing::No;
    strikes_ = 0;
    advance();
  }

  void setTrust(const Trust& trust) {
    quick_.link().setTrust(trust);
    large_.link().setTrust(trust);
  }

  quint64 call(CallRequest request, Reply reply) {
    request.large = request.large && sharing_ == Sharing::No;
    if (request.large) needLarge();
    const quint64 number = book_.add(std::move(request), std::move(reply));
    advance();
    return number;
  }

  void cancel(quint64 number) {
    if (const auto taken = book_.cancel(number, options_.now())) {
      CallAnswer answer;
      answer.kind = Kind::Cancelled;
      answer.sent = taken->sent && !breakOff(number);
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
    // The signal may have made others change their subscriptions.
    if (const auto topic = topics_.find(wanted.topic); topic != topics_.end() && topic->second.id.isEmpty()) {
      send(topic->second);
    }
  }

  void unsubscribe(const std::string& topic) {
    const auto known = topics_.find(topic);
    if (known == topics_.end()) return;
    if (!known->second.id.isEmpty()) {
      qCDebug(lcRosbridge, "unsubscribe %s", topic.c_str());
      connection(isLarge(known->second)).send(unsubscribeRequest(known->second.id, topic));
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
    bool heard = false;  // since it was sent
  };

  /// Whether everything uses one connection.
  enum class Sharing {
    No,
    UntilReconnect,  // the second was refused; the server may have been busy
    ForGood,         // one of the two is always closed
  };

  struct Uploading {
    quint64 number = 0;
    Upload upload;
    std::function<void(qint64, qint64)> travelled;
  };

  Connection& connection(bool large) { return large ? large_ : quick_; }
  bool isLarge(const Topic& topic) const { return topic.wanted.large && sharing_ == Sharing::No; }

  void listen(bool large) {
    Connection& heard = connection(large);
    QObject::connect(&heard, &Connection::becameReady, owner_, [this, large] { begin(large); });
    QObject::connect(&heard, &Connection::wasLost, owner_, [this, large] { lose(large); });
    QObject::connect(&heard.link(), &WebSocketLink::written, owner_, [this, large] { pump(large); });
    QObject::connect(&heard, &Connection::changed, owner_, [this, large] {
      if (large) judgeLarge();
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

  /// The second connection depends on the first: it stays closed if the first is, and does not take the only
  /// slot of a server.
  void needLarge() {
    if (quick_.ready() && sharing_ == Sharing::No && large_.down()) large_.link().open();
  }

  void begin(bool large) {
    ready_at_ = options_.now();
    if (!large && sharing_ == Sharing::UntilReconnect) sharing_ = Sharing::No;
    const bool any_large = std::any_of(topics_.begin(), topics_.end(),
                                       [](const auto& topic) { return topic.second.wanted.large; });
    if (!large && (any_large || book_.waitsForLarge())) needLarge();
    for (auto& [topic, state] : topics_) {
      if (isLarge(state) == large) send(state);
    }
    advance();
    if (!large) Q_EMIT owner_->opened();
  }

  void lose(bool large) {
    for (auto& [topic, state] : topics_) {
      if (isLarge(state) == large) state.id.clear();
    }
    for (const CallBook::Call& call : book_.lost(large)) fail(call, Kind::LinkLost, !breakOff(call.number));
    uploads_[large].clear();
    if (sharing_ != Sharing::No || closing_) return;
    // A server that allows one connection closes the other one, each time both are open.
    const bool soon = !connection(!large).down() && options_.now() - ready_at_ <= kSoonLost;
    strikes_ = soon ? strikes_ + 1 : 0;
    if (strikes_ >= kMostStrikes) share(Sharing::ForGood, connection(large).link().reason());
  }

  /// Handles a refused second connection while the first one is open.
  void judgeLarge() {
    const WebSocketLink& link = large_.link();
    const bool refused = large_.down() && !large_was_open_ && link.reason().any();
    large_was_open_ = link.state() == WebSocketLink::State::Open ||
                      (large_was_open_ && link.state() == WebSocketLink::State::Waiting);
    if (refused && sharing_ == Sharing::No && quick_.ready()) share(Sharing::UntilReconnect, link.reason());
  }

  void share(Sharing how, const Fault& why) {
    const Fault reason = why;  // closing clears it
    for (auto& [topic, state] : topics_) {
      if (state.wanted.large) state.id.clear();
    }
    for (const CallBook::Call& call : book_.lost(true)) fail(call, Kind::LinkLost, !breakOff(call.number));
    uploads_[true].clear();
    qCInfo(lcRosbridge, "one connection for everything from now on: %s", inEnglish(reason).c_str());
    sharing_ = how;
    book_.allQuick();
    large_.link().close();
    for (auto& [topic, state] : topics_) {
      if (state.wanted.large) send(state);
    }
    if (!std::exchange(told_, true)) Q_EMIT owner_->sharesOneConnection(reason);
  }

  /// Stops sending it. True: some of it had not been sent, so it has no effect.
  bool breakOff(quint64 number) {
    for (auto& uploads : uploads_) {
      for (auto one = uploads.begin(); one != uploads.end(); ++one) {
        if (one->number != number) continue;
        const bool partly = !one->upload.done();
        uploads.erase(one);
        return partly;
      }
    }
    return false;
  }

  void beginUpload(const CallBook::Call& call) {
    const bool large = call.request.large;
    uploads_[large].push_back(
        {call.number,
         Upload(CallBook::idOf(call.number), call.request.service, call.request.made_while_sent,
                options_.most_whole_bytes, options_.fragment_bytes),
         call.request.travelled});
    QMetaObject::invokeMethod(
        owner_, [this, large] { pump(large); }, Qt::QueuedConnection);
  }

  /// Sends as much as the system accepts.
  void pump(bool large) {
    if (std::exchange(pumping_, true)) return;  // sending may signal that something was written
    pumpOnce(large);
    pumping_ = false;
  }

  void pumpOnce(bool large) {
    Connection& by = connection(large);
    auto& uploads = uploads_[large];
    while (!uploads.empty() && by.ready()) {
      const quint64 number = uploads.front().number;
      Upload& upload = uploads.front().upload;
      while (!upload.done() && by.link().unsentBytes() < kMostUnsent) {
        const std::optional<QString> frame = upload.next();
        if (!frame) break;
        by.send(*frame);
        if (!by.ready()) return;  // it has just been lost
      }
      if (upload.givenUp()) {
        cancel(number);  // its source has cancelled it
        continue;
      }
      const qint64 unsent = by.link().unsentBytes();
      book_.goesOn(number, options_.now());
      const auto travelled = uploads.front().travelled;
      const qint64 of = upload.bytes();
      const qint64 gone = std::clamp<qint64>(upload.handedOut() - unsent, 0, of);
      const bool over = upload.done() && unsent == 0;
      if (over) uploads.pop_front();
      if (travelled) travelled(gone, of);  // may cancel it
      if (!over) return;
    }
  }

  void send(Topic& topic) {
    Connection& by = connection(isLarge(topic));
    if (!by.ready()) return;
    topic.id = QLatin1Char('s') + QString::number(++last_subscription_);
    topic.since = options_.now();
    topic.heard = false;
    qCDebug(lcRosbridge, "subscribe %s (%s)", topic.wanted.topic.c_str(),
            topic.wanted.type.empty() ? "any type" : topic.wanted.type.c_str());
    by.send(subscribeRequest(topic.id, topic.wanted));
  }

  /// Sends what can be sent, and fails what cannot.
  void advance() {
    const auto next = [this](const CallBook::Call& call) {
      const Connection& by = connection(call.request.large);
      if (by.ready()) return CallBook::Next::Send;
      // The large one is opened after the quick one.
      const bool coming = !by.down() || (call.request.large && !quick_.down() && !quick_.ready());
      return coming ? CallBook::Next::Wait : CallBook::Next::Fail;
    };
    const auto send = [this](const CallBook::Call& call) {
      qCDebug(lcRosbridge, "call %llu %s", call.number, call.request.service.c_str());
      if (call.request.made_while_sent) {
        if (!call.request.service.empty()) beginUpload(call);
        return !call.request.service.empty();
      }
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
    // For a topic that was unsubscribed, or for its former subscription: it was already on its way.
    if (topic == topics_.end() || isLarge(topic->second) != large) return;
    topic->second.since = options_.now();
    if (!std::exchange(topic->second.heard, true))
      qCDebug(lcRosbridge, "first message of %s: %lld bytes", topic->first.c_str(), bytes);
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
      breakOff(answered.call->number);
      deliver(*answered.call, readAnswer(frame));
    } else if (!answered.late) {
      tell(Oddity::UnknownCall, plainText(id.value_or(QString())));
    }
    advance();
  }

  void takeStatus(const Field& status, bool large) {
    const QString level = plainText(QString::fromStdString(status["level"].text()));
    const QString words = plainText(QString::fromStdString(status["msg"].text()));
    const std::optional<QString> id = idIn(status["id"]);
    qCInfo(lcRosbridge, "status %s: %s", qUtf8Printable(level), qUtf8Printable(words));
    if (id && level == QLatin1String("error")) {
      // Instead of an answer: the request was not understood.
      if (const CallBook::Answered answered = book_.answered(id, {}, large); answered.call) {
        CallAnswer answer;
        answer.kind = Kind::Refused;
        answer.words = words.toStdString();
        answer.sent = !breakOff(answered.call->number);
        deliver(*answered.call, std::move(answer));
        advance();
      }
    }
    Q_EMIT owner_->statusReceived(level, words, plainText(id.value_or(QString())));
  }

  void look() {
    quick_.expire();
    large_.expire();
    for (const CallBook::Call& call : book_.timedOut(options_.now()))
      fail(call, Kind::TimedOut, !breakOff(call.number));
    for (const bool large : {false, true}) {
      const qint64 bytes = connection(large).arrivingBytes();
      if (bytes <= 0) continue;
      for (const auto& told : book_.whoListens(large)) told(bytes);
    }
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
    qCDebug(lcRosbridge, "call %llu %s: %s", call.number, call.request.service.c_str(),
            lineOf(answer).c_str());
    if (!call.reply) return;
    QMetaObject::invokeMethod(
        owner_, [reply = call.reply, answer = std::move(answer)] { reply(answer); }, Qt::QueuedConnection);
  }

  void tell(Oddity what, const QString& detail) {
    ++oddities_;
    qCInfo(lcRosbridge, "%s %s", lineOf(what), qUtf8Printable(detail));
    Q_EMIT owner_->odd(what, detail);
  }

  Client* owner_;
  ClientOptions options_;
  CallBook book_;
  std::map<std::string, Topic> topics_;
  quint64 last_subscription_ = 0;
  quint64 oddities_ = 0;
  Sharing sharing_ = Sharing::No;
  int strikes_ = 0;                        // how often in a row one was lost soon after both were open
  std::chrono::milliseconds ready_at_{0};  // the last of the two
  bool large_was_open_ = false;            // in this attempt, or before the server was lost
  bool closing_ = false, told_ = false;
  QTimer look_;
  bool pumping_ = false;
  std::array<std::deque<Uploading>, 2> uploads_;  // by whether they use the connection for large data
  Connection quick_, large_;                      // destroyed first
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

#include "moc_client.cpp"
