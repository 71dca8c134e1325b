// Requests for an Autoxing robot's maps and for the pictures of its topics. Lives on the link's thread.
// Source: docs/protocols/autoxing.md, "Requests", "Addresses that a robot names".
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QUrl>

#include "map/catalogue.h"
#include "map/live_topics.h"
#include "robot/axbot/parse_maps.h"
#include "robot/axbot/parse_topics.h"
#include "robot/axbot/robot_urls.h"
#include "robot/robot.h"
#include "robot/wire/task.h"

namespace mapwright::robot::axbot {

class MapRequests {
 public:
  using Task = wire::TaskPtr;
  explicit MapRequests(RobotServer server) : server_(std::move(server)) {}

  /// Maps and mappings, as far as they can be read: what is missing is reported.
  void list(const Task& task, OutcomeTo<std::vector<map::CatalogueEntry>> reply);
  /// The same, and a failure if some cannot be read: for conclusions from what is not listed.
  void listAll(const Task& task, OutcomeTo<std::vector<map::CatalogueEntry>> reply);
  void describe(const Task& task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  void thumbnail(const Task& task, const map::MapKey& key, OutcomeTo<std::string> reply);
  void fetch(const Task& task, const map::MapKey& key, OutcomeTo<map::WholeMap> reply);
  void fetchOverview(const Task& task, double resolution_m, OutcomeTo<map::WholeMap> reply);
  void discardThumbnail(const map::MapKey& key);
  /// Does nothing if it is not one of its pictures.
  void discardPicture(const std::string& fingerprint);

 private:
  using Reply = std::function<void(const net::HttpAnswer&)>;
  struct Listing;
  struct Fetch;

  void fill(const Task& task, const std::shared_ptr<Listing>& listing);
  void getJson(const Task& task, const QString& path, Reply reply);
  /// Requests "/maps/" and, if that does not exist, "/maps".
  void getList(const Task& task, const QString& path, Reply reply);
  void getPicture(const Task& task, const QUrl& url, Reply reply);
  void detail(const Task& task, const map::MapKey& key, OutcomeTo<MapDetail> reply);
  void finishPart(Listing& listing);
  void addRows(Listing& listing, const net::HttpAnswer& answer, map::MapKind kind);
  void fetchParts(const std::shared_ptr<Fetch>& fetch, const MapDetail& detail);
  void fetchPicture(const std::shared_ptr<Fetch>& fetch, const QUrl& url);
  void fetchExtra(const std::shared_ptr<Fetch>& fetch, const std::string& given_url, const QString& file,
                  std::function<void(map::WholeMap&, std::string_view)> add);

  const RobotServer server_;
  PictureOrigins origins_;
};

/// Fetches pictures that picture topics give only by address. One fetch per topic at a time; of newer
/// pictures only the latest waits. So a connection slower than the topic still shows pictures, without a
/// backlog.
class GridFetcher {
 public:
  explicit GridFetcher(RobotServer server) : server_(std::move(server)) {}

  /// Gets a GridMessage with its picture, or an UnreadableMessage.
  using Receive = std::function<void(map::TopicMessage)>;
  void setReceiver(Receive receive) { receive_ = std::move(receive); }
  /// Gets every picture (PNG) with its topic and its address in the message.
  using Keep = std::function<void(const std::string& topic, const std::string& data_url,
                                  std::shared_ptr<const std::string> picture)>;
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
  Receive receive_;
  Keep keep_;
  PictureOrigins origins_;
  std::map<std::string, Job> jobs_;  // by topic
};

}  // namespace mapwright::robot::axbot
