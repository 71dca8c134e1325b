// Requests for an Autoxing robot's maps. Lives on the link's thread. Source: docs/protocols/autoxing.md,
// "Requests".
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QJsonObject>
#include <QUrl>

#include "map/catalogue.h"
#include "robot/axbot/parse_maps.h"
#include "robot/axbot/robot_urls.h"
#include "robot/robot.h"
#include "robot/wire/task.h"

namespace mapwright::robot::axbot {

class MapRequests {
 public:
  using Task = wire::TaskPtr;
  explicit MapRequests(RobotServer server) : server_(std::move(server)) {}

  void list(const Task& task, OutcomeTo<std::vector<map::CatalogueEntry>> reply);
  void describe(const Task& task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  void thumbnail(const Task& task, const map::MapKey& key, OutcomeTo<std::string> reply);
  void fetch(const Task& task, const map::MapKey& key, OutcomeTo<map::WholeMap> reply);
  void fetchOverview(const Task& task, double resolution_m, OutcomeTo<map::WholeMap> reply);
  void rename(const Task& task, const map::MapKey& key, const std::string& name,
              OutcomeTo<map::CatalogueEntry> reply);
  void load(const Task& task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  void discardThumbnail(const map::MapKey& key);
  /// Does nothing if it is not one of its pictures.
  void discardPicture(const std::string& fingerprint);

 private:
  using Reply = std::function<void(const net::HttpAnswer&)>;
  struct Listing;
  struct Fetch;

  void getJson(const Task& task, const QString& path, Reply reply);
  /// Requests "/maps/" and, if that does not exist, "/maps".
  void getList(const Task& task, const QString& path, Reply reply);
  void getPicture(const Task& task, const QUrl& url, Reply reply);
  using Holds = std::function<bool(const map::CatalogueEntry&)>;
  /// `holds`: whether the map is in the requested state, in case the answer is lost.
  void change(const Task& task, net::HttpMethod method, const QString& path, const QJsonObject& body,
              const map::MapKey& key, Holds holds, OutcomeTo<map::CatalogueEntry> reply);
  /// The map as it is now, and whether it is the current one.
  void lookAt(const Task& task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
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

}  // namespace mapwright::robot::axbot
