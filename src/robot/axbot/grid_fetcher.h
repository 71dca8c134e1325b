// Fetches pictures that picture topics give only by address. Lives on the link's thread. Source:
// docs/protocols/autoxing.md, "Addresses that a robot names".
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "map/live_topics.h"
#include "robot/axbot/parse_topics.h"
#include "robot/axbot/robot_urls.h"

namespace mapwright::robot::axbot {

/// One fetch per topic at a time; of newer pictures only the latest waits. So a connection slower than the
/// topic still shows pictures, without a backlog.
class GridFetcher {
 public:
  explicit GridFetcher(RobotServer server) : server_(std::move(server)) {}

  /// Gets a GridMessage with its picture, or an UnreadableMessage.
  using Take = std::function<void(map::TopicMessage)>;
  void setTaker(Take take) { take_ = std::move(take); }
  /// Gets every picture with its topic and its address in the message.
  using Keep = std::function<void(const std::string& topic, const std::string& data_url,
                                  const char* media_type, std::shared_ptr<const std::string> picture)>;
  void setKeeper(Keep keep) { keep_ = std::move(keep); }

  void fetch(GridToFetch wanted);
  /// Cancels everything in progress or waiting.
  void cancelAll();
  /// Does nothing if it is not one of its pictures.
  void discardPicture(const std::string& fingerprint);

 private:
  struct Job {
    net::HttpClient::RequestId request = 0;
    std::optional<GridToFetch> next;
  };
  void start(const GridToFetch& wanted);
  void finish(const GridToFetch& wanted, const QUrl& url, const net::HttpAnswer& answer);

  const RobotServer server_;
  Take take_;
  Keep keep_;
  PictureOrigins origins_;
  std::map<std::string, Job> jobs_;  // by topic
};

}  // namespace mapwright::robot::axbot
