// The calls of one client: waiting, in progress, or given up but still keeping the server busy.
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
  QByteArray args = "{}";  // a JSON object; messages in it must be complete
  /// Instead of `args`, for data too large for one text.
  std::shared_ptr<ArgsSource> made_while_sent = {};
  /// Progress of sending them; called on the client's thread, never from within call().
  std::function<void(qint64 bytes, qint64 of_bytes)> travelled = {};
  /// Progress of the answer in bytes: of whatever is arriving on its connection, so it may be another answer
  /// if several are in progress. Called now and then on the client's thread, never from within call().
  std::function<void(qint64 bytes)> arriving = {};
  std::chrono::milliseconds patience{10'000};  // for the answer, after the last byte was sent
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

/// A pure value; time is passed in.
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
  /// Goes through the waiting calls in order and removes those that `next` fails; passes others to `send`
  /// while the limit allows.
  std::vector<Call> advance(const std::function<Next(const Call&)>& next,
                            const std::function<bool(const Call&)>& send, std::chrono::milliseconds now);
  /// Removes the call wherever it is; `sent` says where it was.
  struct Taken {
    Call call;
    bool sent = false;
  };
  std::optional<Taken> cancel(quint64 number, std::chrono::milliseconds now);
  /// The call that an answer on that connection belongs to. An answer without an id belongs to the only call
  /// of that service. `late`: the call had been given up.
  struct Answered {
    std::optional<Call> call;
    bool late = false;
  };
  Answered answered(const std::optional<QString>& id, const std::string& service, bool large);
  /// It is still being sent: its timeout starts again.
  void goesOn(quint64 number, std::chrono::milliseconds now);
  std::vector<Call> timedOut(std::chrono::milliseconds now);
  /// All calls that were sent on a connection that is lost.
  std::vector<Call> lost(bool large);

  /// Sends all waiting calls on the quick connection from now on.
  void allQuick();
  bool waitsForLarge() const;

  /// The progress callbacks of the calls in progress on that connection.
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
