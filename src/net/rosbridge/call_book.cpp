#include "net/rosbridge/call_book.h"

#include <algorithm>

namespace mapwright::net::rosbridge {

QString CallBook::idOf(quint64 number) { return QLatin1Char('c') + QString::number(number); }

quint64 CallBook::add(CallRequest request, Reply reply) {
  Call call;
  call.number = ++last_;
  call.request = std::move(request);
  call.reply = std::move(reply);
  waiting_.push_back(std::move(call));
  return last_;
}

std::vector<CallBook::Call> CallBook::advance(const std::function<Next(const Call&)>& next,
                                              const std::function<bool(const Call&)>& send,
                                              std::chrono::milliseconds now) {
  std::vector<Call> failed;
  for (auto call = waiting_.begin(); call != waiting_.end();) {
    const auto here = call++;
    const Next what = next(*here);
    const bool may = what == Next::Send && busy() < std::size_t(std::max(1, at_once_));
    if (may && send(*here)) {
      here->until = now + here->request.patience;
      under_way_.splice(under_way_.end(), waiting_, here);
    } else if (may || what == Next::Fail) {
      failed.push_back(std::move(*here));
      waiting_.erase(here);
    }
  }
  return failed;
}

std::optional<CallBook::Taken> CallBook::cancel(quint64 number, std::chrono::milliseconds now) {
  for (std::list<Call>* const calls : {&waiting_, &under_way_}) {
    const auto at =
        std::find_if(calls->begin(), calls->end(), [&](const Call& call) { return call.number == number; });
    if (at == calls->end()) continue;
    Taken taken{std::move(*at), calls == &under_way_};
    calls->erase(at);
    if (taken.sent) giveUp(taken.call, now);
    return taken;
  }
  return std::nullopt;
}

CallBook::Answered CallBook::answered(const std::optional<QString>& id, const std::string& service,
                                      bool large) {
  Answered result;
  auto found = under_way_.end();
  for (auto call = under_way_.begin(); call != under_way_.end(); ++call) {
    if (call->request.large != large) continue;
    const bool fits = id ? idOf(call->number) == *id : call->request.service == service;
    if (!fits) continue;
    if (found != under_way_.end()) return result;  // ambiguous
    found = call;
  }
  if (found != under_way_.end()) {
    result.call = std::move(*found);
    under_way_.erase(found);
  } else if (id) {
    result.late = std::erase_if(given_up_, [&](const GivenUp& call) {
                    return call.large == large && idOf(call.number) == *id;
                  }) > 0;
  }
  return result;
}

void CallBook::goesOn(quint64 number, std::chrono::milliseconds now) {
  for (Call& call : under_way_) {
    if (call.number == number) call.until = now + call.request.patience;
  }
}

std::vector<CallBook::Call> CallBook::timedOut(std::chrono::milliseconds now) {
  std::erase_if(given_up_, [&](const GivenUp& call) { return call.until <= now; });
  std::vector<Call> late;
  for (auto call = under_way_.begin(); call != under_way_.end();) {
    const auto here = call++;
    if (here->until > now) continue;
    giveUp(*here, now);
    late.push_back(std::move(*here));
    under_way_.erase(here);
  }
  return late;
}

std::vector<CallBook::Call> CallBook::lost(bool large) {
  std::erase_if(given_up_, [&](const GivenUp& call) { return call.large == large; });
  std::vector<Call> gone;
  for (auto call = under_way_.begin(); call != under_way_.end();) {
    const auto here = call++;
    if (here->request.large != large) continue;
    gone.push_back(std::move(*here));
    under_way_.erase(here);
  }
  return gone;
}

std::vector<std::function<void(qint64)>> CallBook::whoListens(bool large) const {
  std::vector<std::function<void(qint64)>> all;
  for (const Call& call : under_way_) {
    if (call.request.large == large && call.request.arriving) all.push_back(call.request.arriving);
  }
  return all;
}

void CallBook::allQuick() {
  for (Call& call : waiting_) call.request.large = false;
}

bool CallBook::waitsForLarge() const {
  return std::any_of(waiting_.begin(), waiting_.end(), [](const Call& call) { return call.request.large; });
}

void CallBook::giveUp(const Call& call, std::chrono::milliseconds now) {
  given_up_.push_back({call.number, call.request.large, now + busy_});
}

}  // namespace mapwright::net::rosbridge
