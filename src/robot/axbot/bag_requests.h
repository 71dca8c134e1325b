// Requests for an Autoxing robot's bags. Lives on the link's thread; replies arrive there from its event
// loop. Source: docs/protocols/autoxing.md, "Bags".
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QObject>
#include <QThreadPool>
#include <QUrl>

#include "map/problem.h"
#include "net/http_client.h"
#include "robot/axbot/bag_download.h"
#include "robot/bag_library.h"
#include "robot/wire/errand.h"

namespace mapwright::robot::axbot {

class BagRequests {
 public:
  using Errand = wire::ErrandPtr;
  using Report = std::function<void(const map::Problem&)>;
  using Recovered = std::function<void(const map::Recovery&)>;
  /// `http` outlives this object, and makes no callbacks after it is destroyed.
  BagRequests(net::HttpClient& http, QUrl base, std::chrono::milliseconds patience, Report report,
              Recovered recovered);
  ~BagRequests();

  void list(Errand errand, OutcomeTo<std::vector<BagEntry>> reply);
  void info(Errand errand, const BagKey& key, OutcomeTo<BagInfo> reply);
  /// The answer is parsed on another thread: it may be long, and live messages need this one.
  void messages(Errand errand, const BagKey& key, const BagRange& range, OutcomeTo<BagChunkPtr> reply);
  void picture(Errand errand, const std::string& topic, const std::string& url,
               OutcomeTo<std::shared_ptr<const std::string>> reply);
  void record(Errand errand, const BagOrder& order, OutcomeTo<BagEntry> reply);
  void remove(Errand errand, const BagKey& key, OutcomeTo<BagKey> reply);
  /// Whether it is complete and unchanged is decided by the last result of list().
  void download(Errand errand, const BagKey& key, const QString& path, OutcomeTo<BagDownload> reply);

 private:
  struct Listing;
  net::HttpRequest requestTo(const QString& path, const QString& query = {}) const;
  void addRows(const std::shared_ptr<Listing>& listing, const net::HttpAnswer& answer, BagKind kind);

  net::HttpClient& http_;
  QUrl base_;
  std::chrono::milliseconds patience_;
  Report report_;
  Recovered recovered_;
  QObject context_;  // results return to its thread
  QThreadPool reading_;
  std::vector<BagEntry> listed_;  // the last list
};

}  // namespace mapwright::robot::axbot
