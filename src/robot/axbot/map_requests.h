// Requests for an Autoxing robot's maps. Lives on the link's thread; replies arrive there from its event
// loop. Source: docs/protocols/autoxing.md, "Requests".
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QJsonObject>
#include <QUrl>

#include "map/catalogue.h"
#include "net/http_client.h"
#include "robot/axbot/parse_maps.h"
#include "robot/axbot/picture_origins.h"
#include "robot/robot.h"
#include "robot/wire/errand.h"

namespace mapwright::robot::axbot {

class MapRequests {
 public:
  using Errand = wire::ErrandPtr;
  using Report = std::function<void(const map::Problem&)>;
  using Recovered = std::function<void(const map::Recovery&)>;
  /// `http` outlives this object, and makes no callbacks after it is destroyed.
  MapRequests(net::HttpClient& http, QUrl base, std::chrono::milliseconds patience, Report report,
              Recovered recovered);

  void list(Errand errand, OutcomeTo<std::vector<map::CatalogueEntry>> reply);
  void describe(Errand errand, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  void thumbnail(Errand errand, const map::MapKey& key, OutcomeTo<std::string> reply);
  void fetch(Errand errand, const map::MapKey& key, OutcomeTo<map::WholeMap> reply);
  void fetchOverview(Errand errand, double resolution_m, OutcomeTo<map::WholeMap> reply);
  void rename(Errand errand, const map::MapKey& key, const std::string& name,
              OutcomeTo<map::CatalogueEntry> reply);
  void load(Errand errand, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  void discardThumbnail(const map::MapKey& key);
  /// Does nothing if it is not one of its pictures.
  void discardPicture(const std::string& fingerprint);

 private:
  using Taken = std::function<void(const net::HttpAnswer&)>;
  struct Listing;
  struct Fetch;

  net::HttpRequest requestTo(QUrl url) const;
  void getJson(Errand errand, const QString& path, Taken taken);
  /// Requests "/maps/" and, if that does not exist, "/maps".
  void getList(Errand errand, const QString& path, Taken taken);
  void getPicture(Errand errand, const QUrl& url, Taken taken, bool tells);
  using Holds = std::function<bool(const map::CatalogueEntry&)>;
  /// `holds`: whether the map is in the requested state, in case the answer is lost.
  void change(Errand errand, net::HttpMethod method, const QString& path, const QJsonObject& body,
              const map::MapKey& key, Holds holds, OutcomeTo<map::CatalogueEntry> reply);
  /// The map as it is now, and whether it is the current one.
  void lookAt(const Errand& errand, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  void detail(Errand errand, const map::MapKey& key, OutcomeTo<MapDetail> reply);
  void finishPart(const std::shared_ptr<Listing>& listing);
  void addRows(Listing& listing, const net::HttpAnswer& answer, map::MapKind kind);
  void fetchParts(const std::shared_ptr<Fetch>& fetch, const MapDetail& detail);
  void fetchPicture(const std::shared_ptr<Fetch>& fetch, const QUrl& url);
  void fetchExtra(const std::shared_ptr<Fetch>& fetch, const std::string& given_url, const QString& file,
                  std::function<void(map::WholeMap&, std::string_view)> add);

  net::HttpClient& http_;
  QUrl base_;
  std::chrono::milliseconds patience_;
  Report report_;
  Recovered recovered_;
  PictureOrigins origins_;
};

}  // namespace mapwright::robot::axbot
