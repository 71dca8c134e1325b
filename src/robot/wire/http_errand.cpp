#include "robot/wire/http_errand.h"

#include <utility>

namespace mapwright::robot::wire {

void send(const ErrandPtr& errand, net::HttpClient& http, net::HttpRequest request,
          net::HttpClient::Reply reply, bool tells) {
  if (tells) {
    request.progress = [errand](const net::HttpProgress& progress) {
      errand->tell({progress.bytes,
                    progress.of_bytes ? std::optional<std::int64_t>(*progress.of_bytes) : std::nullopt});
    };
  }
  const auto number = std::make_shared<int>(0);
  const auto id = http.send(request, [errand, number, reply = std::move(reply)](net::HttpAnswer answer) {
    errand->ended(*number);
    reply(std::move(answer));
  });
  *number = errand->begun([&http, id] { http.cancel(id); });
}

}  // namespace mapwright::robot::wire
