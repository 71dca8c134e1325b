// Asks an Autoxing robot for its maps. Lives on the link's thread; replies arrive there from its event loop.
// Source: axbot.md, "Requests".
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QUrl>

#include "map/catalogue.h"
#include "net/http_client.h"
#include "robot/axbot/parse_maps.h"
#include "robot/axbot/picture_origins.h"
#include "robot/robot.h"

namespace mapwright::robot::axbot {

class MapRequests {
 public:
  using Report = std::function<void(const map::Problem&)>;
  using Recovered = std::function<void(const map::Recovery&)>;
  /// `http` outlives this object, and calls nobody any more once it is gone itself.
  MapRequests(net::HttpClient& http, QUrl base, Report report, Recovered recovered);

  void list(AnswerTo<std::vector<map::CatalogueEntry>> reply);
  void describe(const map::MapKey& key, AnswerTo<map::CatalogueEntry> reply);
  void thumbnail(const map::MapKey& key, AnswerTo<std::string> reply);
  void fetch(const map::MapKey& key, AnswerTo<map::WholeMap> reply);
  void fetchOverview(double resolution_m, AnswerTo<map::WholeMap> reply);
  void discardThumbnail(const map::MapKey& key);
  /// Nothing happens when it is none of its pictures.
  void discardPicture(const std::string& fingerprint);

 private:
  using Taken = std::function<void(const net::HttpAnswer&)>;
  struct Listing;
  struct Fetch;

  void getJson(const QString& path, Taken taken);
  /// Asks for "/maps/" and, when that is not known, for "/maps".
  void getList(const QString& path, Taken taken);
  void getPicture(const QUrl& url, Taken taken);
  void detail(const map::MapKey& key, AnswerTo<MapDetail> reply);
  void finishPart(const std::shared_ptr<Listing>& listing);
  void addRows(Listing& listing, const net::HttpAnswer& answer, map::MapKind kind);
  void fetchParts(const std::shared_ptr<Fetch>& fetch, const MapDetail& detail);
  void fetchPicture(const std::shared_ptr<Fetch>& fetch, const QUrl& url);
  void fetchExtra(const std::shared_ptr<Fetch>& fetch, const std::string& given_url, const QString& file,
                  std::function<void(map::WholeMap&, std::string_view)> add);

  net::HttpClient& http_;
  QUrl base_;
  Report report_;
  Recovered recovered_;
  PictureOrigins origins_;
};

}  // namespace mapwright::robot::axbot
