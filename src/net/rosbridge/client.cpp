#include "net/rosbridge/client.h"

#include <algorithm>
#include <array>
#include <deque>
#include <list>
#include <map>
#include <utility>

#include <QDateTime>
#include <QLoggingCategory>
#include <QRandomGenerator>
#include <QTimer>

#include "net/plain_sentences.h"

namespace mapwright::net::rosbridge {
namespace {

Q_LOGGING_CATEGORY(lcRosbridge, "mapwright.rosbridge", QtWarningMsg)

using Kind = CallAnswer::Kind;

std::string lineOf(const CallAnswer& answer) {
  constexpr const char* kLines[] = {"answered", "refused: ", "timed out", "connection lost", "cancelled"};
  if (answer.kind == Kind::Malformed)
    return (answer.sent ? "unreadable answer: " : "not sent: ") + answer.words;
  return kLines[int(answer.kind)] + (answer.kind == Kind::Refused ? answer.words : std::string());
}

const char* lineOf(Oddity oddity) {
  constexpr const char* kLines[] = {"unreadable frame", "stray fragment", "lost fragments",
                                    "unknown op",       "unknown call",   "malformed message"};
  return kLines[int(oddity)];
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

class Client::Impl {
 public:
  Impl(Client* owner, const QUrl& url, ClientOptions options)
      : owner_(owner),
        options_(withClocks(std::move(options))),
        quick_(url, options_),
        large_(url, options_) {
    for (const bool large : {false, true}) listen(large);
    QObject::connect(&look_, &QTimer::timeout, owner_, [this] { look(); });
  }

  void open() { quick_.link.open(); }

  void close() {
    closing_ = true;
    large_.link.close();
    quick_.link.close();
    closing_ = false;
    // There may be another server the next time.
    sharing_ = Sharing::No;
    strikes_ = 0;
    advance();
  }

  void setTrust(const Trust& trust) {
    quick_.link.setTrust(trust);
    large_.link.setTrust(trust);
  }

  quint64 call(CallRequest request, Reply reply) {
    request.large = request.large && sharing_ == Sharing::No;
    if (request.large) needLarge();
    const quint64 number = ++last_call_;
    waiting_.push_back({number, std::move(request), std::move(reply)});
    advance();
    return number;
  }

  void cancel(quint64 number) {
    for (std::list<Call>* const calls : {&waiting_, &sent_}) {
      const auto at =
          std::find_if(calls->begin(), calls->end(), [&](const Call& call) { return call.number == number; });
      if (at == calls->end()) continue;
      const Call call = std::move(*at);
      calls->erase(at);
      const bool sent = calls == &sent_;
      if (sent) giveUp(call);
      end(call, Kind::Cancelled, sent && !breakOff(number));
      return advance();
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

  QString refusalOf(const std::string& name) const {
    const auto topic = topics_.find(name);
    return topic == topics_.end() ? QString() : topic->second.refusal;
  }

  const WebSocketLink& link(bool large) const { return large ? large_.link : quick_.link; }
  quint64 oddities() const { return oddities_; }

 private:
  /// One of the two connections.
  struct Connection {
    Connection(const QUrl& url, const ClientOptions& options)
        : link({url}, QByteArray(), linkOptions(options)), joiner(joinerLimits(options)) {}
    /// Not ready, and will not be without another attempt.
    bool down() const {
      return link.state() == WebSocketLink::State::Closed || link.state() == WebSocketLink::State::Waiting;
    }
    /// Dropped unless ready.
    void send(const QString& request) {
      if (ready) link.sendText(request);
    }
    bool joining() const { return joiner.heldMessages() > 0; }

    WebSocketLink link;
    FragmentJoiner joiner;
    std::uint64_t losses_told = 0;
    bool ready = false;  // connected, and the credentials were sent: requests may follow
  };

  struct Topic {
    Subscription wanted;
    QString id;  // empty: not sent
    std::chrono::milliseconds since{0};
    bool heard = false;  // since it was sent
    QString refusal;     // by the server, since it was sent
  };

  struct Call {
    quint64 number = 0;
    CallRequest request;
    Reply reply;
    std::chrono::milliseconds until{0};  // once sent
    QString id() const { return QLatin1Char('c') + QString::number(number); }
  };

  /// It may keep the server busy, although nobody waits for it any more.
  struct GivenUp {
    QString id;
    bool large = false;
    std::chrono::milliseconds until{0};
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
    const WebSocketLink* const link = &connection(large).link;
    QObject::connect(link, &WebSocketLink::changed, owner_, [this, large] { follow(large); });
    QObject::connect(link, &WebSocketLink::opened, owner_, [this, large] { start(large); });
    QObject::connect(link, &WebSocketLink::written, owner_, [this, large] { pump(large); });
    QObject::connect(link, &WebSocketLink::textReceived, owner_,
                     [this, large](const QByteArray& utf8) { read(utf8, Frame::Wire::Text, large); });
    QObject::connect(link, &WebSocketLink::binaryReceived, owner_,
                     [this, large](const QByteArray& bytes) { read(bytes, Frame::Wire::Binary, large); });
  }

  void follow(bool large) {
    Connection& by = connection(large);
    if (by.ready && by.link.state() != WebSocketLink::State::Open) {
      by.ready = false;
      by.joiner.clear();
      lose(large);
    }
    if (large) judgeLarge();
    advance();
    Q_EMIT owner_->changed();
  }

  void start(bool large) {
    Connection& by = connection(large);
    by.ready = true;
    if (options_.credentials)
      by.link.sendText(authRequest(*options_.credentials, randomText(), qint64(options_.wall_s())));
    begin(large);
  }

  void read(const QByteArray& bytes, Frame::Wire wire, bool large) {
    const double received_s = options_.wall_s();
    Q_EMIT owner_->frameReceived({bytes.constData(), std::size_t(bytes.size())}, wire == Frame::Wire::Binary,
                                 received_s);
    lookLater();
    const auto frame = Frame::read(bytes, wire, std::size_t(options_.max_message_bytes));
    if (frame->fault() == Frame::Fault::None && frame->root()["op"].text() == "fragment") {
      join(frame->root(), received_s, large);
    } else {
      onFrame(frame, bytes.size(), received_s, large);
    }
  }

  void join(const Field& fragment, double received_s, bool large) {
    const auto joined = connection(large).joiner.add(fragment, options_.now());
    if (!joined) reportOddity(Oddity::BadFragment, plainText(QString::fromStdString(fragment["id"].text())));
    reportLosses(large);
    if (!joined || !*joined) return;
    const QByteArray text = **joined;
    onFrame(Frame::read(text, Frame::Wire::Text, std::size_t(options_.max_message_bytes)), text.size(),
            received_s, large);
  }

  void reportLosses(bool large) {
    Connection& by = connection(large);
    while (by.losses_told < by.joiner.dropped()) {
      ++by.losses_told;
      reportOddity(Oddity::LostFragments, {});
    }
  }

  /// The second connection depends on the first: it stays closed if the first is, and does not take the only
  /// slot of a server.
  void needLarge() {
    if (quick_.ready && sharing_ == Sharing::No && large_.down()) large_.link.open();
  }

  void begin(bool large) {
    ready_at_ = options_.now();
    if (!large && sharing_ == Sharing::UntilReconnect) sharing_ = Sharing::No;
    const bool any_large =
        std::any_of(topics_.begin(), topics_.end(),
                    [](const auto& topic) { return topic.second.wanted.large; }) ||
        std::any_of(waiting_.begin(), waiting_.end(), [](const Call& call) { return call.request.large; });
    if (!large && any_large) needLarge();
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
    loseCalls(large);
    if (sharing_ != Sharing::No || closing_) return;
    // A server that allows one connection closes the other one, each time both are open.
    const bool soon = !connection(!large).down() && options_.now() - ready_at_ <= kSoonLost;
    strikes_ = soon ? strikes_ + 1 : 0;
    if (strikes_ >= kMostStrikes) share(Sharing::ForGood, connection(large).link.reason());
  }

  /// Handles a refused second connection while the first one is open.
  void judgeLarge() {
    const WebSocketLink& link = large_.link;
    const bool refused = large_.down() && !large_was_open_ && link.reason().any();
    large_was_open_ = link.state() == WebSocketLink::State::Open ||
                      (large_was_open_ && link.state() == WebSocketLink::State::Waiting);
    if (refused && sharing_ == Sharing::No && quick_.ready) share(Sharing::UntilReconnect, link.reason());
  }

  void share(Sharing how, const Fault& why) {
    const Fault reason = why;  // closing clears it
    for (auto& [topic, state] : topics_) {
      if (state.wanted.large) state.id.clear();
    }
    loseCalls(true);
    qCInfo(lcRosbridge, "one connection for everything from now on: %s", inEnglish(reason).c_str());
    sharing_ = how;
    for (Call& call : waiting_) call.request.large = false;
    large_.link.close();
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

  void beginUpload(const Call& call) {
    const bool large = call.request.large;
    uploads_[large].push_back({call.number,
                               Upload(call.id(), call.request.service, call.request.made_while_sent,
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
    while (!uploads.empty() && by.ready) {
      const quint64 number = uploads.front().number;
      Upload& upload = uploads.front().upload;
      while (!upload.done() && by.link.unsentBytes() < kMostUnsent) {
        const std::optional<QString> frame = upload.next();
        if (!frame) break;
        by.send(*frame);
        if (!by.ready) return;  // it has just been lost
      }
      if (upload.givenUp()) {
        cancel(number);  // its source has cancelled it
        continue;
      }
      const qint64 unsent = by.link.unsentBytes();
      for (Call& call : sent_) {
        if (call.number == number) startTimeout(call);
      }
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
    if (!by.ready) return;
    topic.id = QLatin1Char('s') + QString::number(++last_subscription_);
    topic.since = options_.now();
    topic.heard = false;
    topic.refusal.clear();
    qCDebug(lcRosbridge, "subscribe %s (%s)", topic.wanted.topic.c_str(),
            topic.wanted.type.empty() ? "any type" : topic.wanted.type.c_str());
    by.send(subscribeRequest(topic.id, topic.wanted));
  }

  /// Sends what can be sent, and ends what cannot.
  void advance() {
    for (auto call = waiting_.begin(); call != waiting_.end();) {
      const auto here = call++;
      const Connection& by = connection(here->request.large);
      // The large one is opened after the quick one.
      const bool coming = !by.down() || (here->request.large && !quick_.down() && !quick_.ready);
      const bool busy = sent_.size() + given_up_.size() >= std::size_t(std::max(1, options_.calls_at_once));
      if (by.ready ? busy : coming) continue;
      if (by.ready && send(*here)) {
        startTimeout(*here);
        sent_.splice(sent_.end(), waiting_, here);
        continue;
      }
      end(*here, by.ready ? Kind::Malformed : Kind::LinkLost, false);
      waiting_.erase(here);
    }
    lookLater();
  }

  bool send(const Call& call) {
    qCDebug(lcRosbridge, "call %llu %s", call.number, call.request.service.c_str());
    if (call.request.made_while_sent) {
      if (!call.request.service.empty()) beginUpload(call);
      return !call.request.service.empty();
    }
    const std::optional<QString> request = callRequest(call.id(), call.request.service, call.request.args);
    if (request) connection(call.request.large).send(*request);
    return request.has_value();
  }

  void startTimeout(Call& call) { call.until = options_.now() + call.request.timeout; }

  void giveUp(const Call& call) {
    given_up_.push_back({call.id(), call.request.large, options_.now() + options_.busy_after_giving_up});
  }

  /// The calls that were sent and are `over`.
  template <typename Over>
  void endSent(Kind kind, const Over& over) {
    for (auto call = sent_.begin(); call != sent_.end();) {
      const auto here = call++;
      if (!over(*here)) continue;
      if (kind == Kind::TimedOut) giveUp(*here);
      end(*here, kind, !breakOff(here->number));
      sent_.erase(here);
    }
  }

  void loseCalls(bool large) {
    std::erase_if(given_up_, [&](const GivenUp& call) { return call.large == large; });
    endSent(Kind::LinkLost, [&](const Call& call) { return call.request.large == large; });
    uploads_[large].clear();
  }

  /// Takes out the call that an answer on that connection belongs to. An answer without an id belongs to the
  /// only call of that service.
  std::optional<Call> finishAnswered(const std::optional<QString>& id, const std::string& service,
                                     bool large) {
    auto found = sent_.end();
    for (auto call = sent_.begin(); call != sent_.end(); ++call) {
      const bool fits = id ? call->id() == *id : call->request.service == service;
      if (call->request.large != large || !fits) continue;
      if (found != sent_.end()) return std::nullopt;  // ambiguous
      found = call;
    }
    if (found == sent_.end()) return std::nullopt;
    Call call = std::move(*found);
    sent_.erase(found);
    return call;
  }

  /// The late answer to a call that had been given up.
  bool onLateAnswer(const std::optional<QString>& id, bool large) {
    return std::erase_if(given_up_,
                         [&](const GivenUp& call) { return call.large == large && call.id == id; }) > 0;
  }

  void onFrame(const std::shared_ptr<const Frame>& frame, qint64 bytes, double received_s, bool large) {
    const std::string operation = frame->root()["op"].text();
    if (frame->fault() != Frame::Fault::None) {
      reportOddity(Oddity::UnreadableFrame, {});
    } else if (operation == "publish") {
      onMessage(frame, bytes, received_s, large);
    } else if (operation == "service_response") {
      onAnswer(frame, large);
    } else if (operation == "status") {
      onStatus(frame->root(), large);
    } else {
      reportOddity(Oddity::UnknownOperation, plainText(QString::fromStdString(operation)));
    }
  }

  void onMessage(const std::shared_ptr<const Frame>& frame, qint64 bytes, double received_s, bool large) {
    const std::string name = frame->root()["topic"].text();
    TopicMessage message;
    message.msg = frame->root()["msg"];
    if (name.empty() || !message.msg.isObject()) {
      reportOddity(Oddity::MalformedMessage, plainText(QString::fromStdString(name)));
      return;
    }
    auto topic = topics_.find(name);
    if (topic == topics_.end()) topic = topics_.find(name.front() == '/' ? name.substr(1) : '/' + name);
    // For a topic that was unsubscribed, or for its former subscription: it was already on its way.
    if (topic == topics_.end() || isLarge(topic->second) != large) return;
    topic->second.since = options_.now();
    topic->second.refusal.clear();
    if (!std::exchange(topic->second.heard, true))
      qCDebug(lcRosbridge, "first message of %s: %lld bytes", topic->first.c_str(), bytes);
    message.topic = topic->first;
    message.frame = frame;
    message.received_s = received_s;
    message.bytes = bytes;
    message.binary = frame->wire() == Frame::Wire::Binary;
    Q_EMIT owner_->received(message);
  }

  void onAnswer(const std::shared_ptr<const Frame>& frame, bool large) {
    const std::optional<QString> id = idIn(frame->root()["id"]);
    if (const auto call = finishAnswered(id, frame->root()["service"].text(), large)) {
      breakOff(call->number);
      deliver(*call, readAnswer(frame));
    } else if (!onLateAnswer(id, large)) {
      reportOddity(Oddity::UnknownCall, plainText(id.value_or(QString())));
    }
    advance();
  }

  void onStatus(const Field& status, bool large) {
    const QString level = plainText(QString::fromStdString(status["level"].text()));
    const QString words = plainText(QString::fromStdString(status["msg"].text()));
    const std::optional<QString> id = idIn(status["id"]);
    qCInfo(lcRosbridge, "status %s: %s", qUtf8Printable(level), qUtf8Printable(words));
    if (id && level == QLatin1String("error")) {
      for (auto& [name, topic] : topics_) {
        if (topic.id == *id && isLarge(topic) == large) topic.refusal = words.left(300);
      }
      // Instead of an answer: the request was not understood.
      if (const auto call = finishAnswered(id, {}, large)) {
        CallAnswer answer;
        answer.kind = Kind::Refused;
        answer.words = words.toStdString();
        answer.sent = !breakOff(call->number);
        deliver(*call, std::move(answer));
        advance();
      } else {
        onLateAnswer(id, large);
      }
    }
    Q_EMIT owner_->statusReceived(level, words, plainText(id.value_or(QString())));
  }

  void look() {
    for (const bool large : {false, true}) {
      connection(large).joiner.expire(options_.now());
      reportLosses(large);
    }
    const auto now = options_.now();
    std::erase_if(given_up_, [&](const GivenUp& call) { return call.until <= now; });
    endSent(Kind::TimedOut, [&](const Call& call) { return call.until <= now; });
    for (const bool large : {false, true}) {
      // Of an incomplete frame or fragmented message.
      const Connection& by = connection(large);
      const qint64 bytes = by.link.arrivingBytes() + qint64(by.joiner.heldBytes());
      if (bytes <= 0) continue;
      std::vector<std::function<void(qint64)>> listeners;  // they may cancel calls
      for (const Call& call : sent_) {
        if (call.request.large == large && call.request.arriving) listeners.push_back(call.request.arriving);
      }
      for (const auto& arriving : listeners) arriving(bytes);
    }
    advance();
    if (!needsLooks()) look_.stop();
  }

  bool needsLooks() const {
    return !sent_.empty() || !given_up_.empty() || quick_.joining() || large_.joining();
  }

  void lookLater() {
    if (!look_.isActive() && needsLooks()) look_.start(options_.look_every);
  }

  void end(const Call& call, Kind kind, bool sent) {
    CallAnswer answer;
    answer.kind = kind;
    answer.sent = sent;
    deliver(call, std::move(answer));
  }

  void deliver(const Call& call, CallAnswer answer) {
    qCDebug(lcRosbridge, "call %llu %s: %s", call.number, call.request.service.c_str(),
            lineOf(answer).c_str());
    if (!call.reply) return;
    QMetaObject::invokeMethod(
        owner_, [reply = call.reply, answer = std::move(answer)] { reply(answer); }, Qt::QueuedConnection);
  }

  void reportOddity(Oddity what, const QString& detail) {
    ++oddities_;
    qCInfo(lcRosbridge, "%s %s", lineOf(what), qUtf8Printable(detail));
    Q_EMIT owner_->odd(what, detail);
  }

  Client* owner_;
  ClientOptions options_;
  quint64 last_call_ = 0;
  std::list<Call> waiting_, sent_;
  std::vector<GivenUp> given_up_;
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
QString Client::refusalOf(const std::string& topic) const { return impl_->refusalOf(topic); }
quint64 Client::oddities() const { return impl_->oddities(); }

}  // namespace mapwright::net::rosbridge

#include "moc_client.cpp"
