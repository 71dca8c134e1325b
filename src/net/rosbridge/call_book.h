// The calls of one client: which wait, which are under way, which were given up and keep the server busy.
#pragma once

#include <chrono>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QByteArray>
#include <QString>

#include "net/rosbridge/frame.h"
#include "net/rosbridge/upload.h"

namespace mapwright::net::rosbridge {

struct CallRequest {
  std::string service;
  QByteArray args = "{}";  // a JSON object; messages in it complete
  /// Instead of `args`, for what is too large to be held as text.
  std::shared_ptr<ArgsSource> made_while_sent = {};
  /// Of these, how much has left, and of how much; on the client's thread, never from within call().
  std::function<void(qint64 bytes, qint64 of_bytes)> travelled = {};
  /// While its answer comes, how much is there: of what is arriving by its connection, so of another answer
  /// where several are under way. Now and then; on the client's thread, never from within call().
  std::function<void(qint64 bytes)> arriving = {};
  std::chrono::milliseconds patience{10'000};  // for the answer, from the moment that the last of it was sent
  bool large = false;  // its answer may be megabytes: by the connection for large things
};

struct CallAnswer {
  enum class Kind {
    Answered,
    Refused,    // result:false; `words` is what the server says
    TimedOut,   // it was sent, and no answer came in time
    LinkLost,   // or there was none to send it by
    Cancelled,  // by the caller
    Malformed,  // the answer, or what was to be sent: see `sent`
  };
  Kind kind = Kind::LinkLost;
  std::shared_ptr<const Frame> frame;  // keeps `values` alive
  Field values;                        // Answered: the service's answer
  std::string words;                   // Refused, Malformed: untrusted plain text
  /// It may have reached the robot. Then nothing but Answered says what was done there: a service that breaks
  /// off after its work is Refused as well. What broke off while it travelled has not: no server acts on a
  /// part of it.
  bool sent = false;
};

using Reply = std::function<void(const CallAnswer&)>;

/// A pure value; time is handed in.
class CallBook {
 public:
  struct Call {
    quint64 number = 0;
    CallRequest request;
    Reply reply;
    std::chrono::milliseconds until{0};  // once sent
  };
  enum class Next { Send, Wait, Fail };

  explicit CallBook(int at_once, std::chrono::milliseconds busy) : at_once_(at_once), busy_(busy) {}

  quint64 add(CallRequest request, Reply reply);
  /// Goes through those that wait, in order, and takes out what `next` says is to fail; what is to be sent is
  /// handed to `send` as long as the bound allows.
  std::vector<Call> advance(const std::function<Next(const Call&)>& next,
                            const std::function<bool(const Call&)>& send, std::chrono::milliseconds now);
  /// Takes out the call, wherever it is; `sent` tells where.
  struct Taken {
    Call call;
    bool sent = false;
  };
  std::optional<Taken> cancel(quint64 number, std::chrono::milliseconds now);
  /// The call under way that an answer by that connection belongs to. An answer without an id belongs to the
  /// only one of that service. `late`: it had been given up.
  struct Answered {
    std::optional<Call> call;
    bool late = false;
  };
  Answered answered(const std::optional<QString>& id, const std::string& service, bool large);
  /// It is on its way still: its patience begins anew.
  void goesOn(quint64 number, std::chrono::milliseconds now);
  std::vector<Call> timedOut(std::chrono::milliseconds now);
  /// All that were sent by a connection that is lost.
  std::vector<Call> lost(bool large);

  /// All that wait go by the quick connection from now on.
  void allQuick();
  bool waitsForLarge() const;

  /// Who of those under way by that connection wants to know how much has come.
  std::vector<std::function<void(qint64)>> whoListens(bool large) const;

  bool hasSent() const { return !under_way_.empty() || !given_up_.empty(); }
  static QString idOf(quint64 number);

 private:
  struct GivenUp {
    quint64 number = 0;
    bool large = false;
    std::chrono::milliseconds until{0};
  };
  void giveUp(const Call& call, std::chrono::milliseconds now);

  std::size_t busy() const { return under_way_.size() + given_up_.size(); }

  int at_once_;
  std::chrono::milliseconds busy_;
  quint64 last_ = 0;
  std::list<Call> waiting_, under_way_;
  std::list<GivenUp> given_up_;
};

}  // namespace mapwright::net::rosbridge
