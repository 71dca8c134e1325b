// Addresses on a robot, and requests to them. Source: docs/protocols/autoxing.md, "Requests", "Addresses that
// a robot names".
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <QString>
#include <QUrl>

#include "map/problem.h"
#include "net/http_client.h"
#include "robot/call.h"

namespace mapwright::robot::axbot {

/// `path` ("/maps/", percent-encoded if needed) below the address that the user connected to.
QUrl urlOnRobot(const QUrl& base, const QString& path, const QString& query = {});

/// The meaning of a robot's `*_url` or `data_url`: robots often use host names for themselves that cannot be
/// reached, so only path and query are used, on `base`. An invalid URL if there is no path.
QUrl robotUrl(const QUrl& base, std::string_view given);

/// A segment of a path, percent-encoded.
QString pathSegment(std::string_view text);

/// The path of one thing in a folder ("/maps/"): nullopt if its id is no plain one (letters, digits, - and
/// _), because a DELETE to the folder itself deletes everything in it, and what has dots, slashes or signs
/// may lead there. Every address with an id is made by this or pathOfNamed().
std::optional<QString> pathOf(const QString& folder, std::string_view id);
/// The same for a thing that has the name of a file: no folders, no part of an address, not blank.
std::optional<QString> pathOfNamed(const QString& folder, std::string_view name);
/// Can stand in an address: the id has a path.
bool isPlainId(std::string_view id);

/// The web server of a robot, for the requests that capabilities make: on the link's thread. Replies arrive
/// there from its event loop.
struct RobotServer {
  net::HttpClient& http;  // outlives this; no callback is called after it is destroyed
  QUrl base;
  std::chrono::milliseconds timeout;  // without a byte
  std::function<void(const map::Problem&)> report;
  std::function<void(const map::Recovery&)> recovered;

  /// A GET of JSON.
  net::HttpRequest request(const QString& path, const QString& query = {}) const;
  net::HttpRequest pictureRequest(const QUrl& url) const;
};

/// Why an answer with 200 is a refusal: {"success": false, "message": "…"}; nullopt: it is none.
std::optional<map::Failure> refusalIn(const net::HttpAnswer& answer, const map::Subject& subject);

/// The body of an answer with a picture. An empty one counts as a failure.
Outcome<std::shared_ptr<const std::string>> pictureOf(const net::HttpAnswer& answer,
                                                      const map::Subject& subject,
                                                      map::AskedFor asked_for = map::AskedFor::Picture);

/// The addresses of the latest pictures.
class PictureOrigins {
 public:
  void remember(const std::string& fingerprint, const QUrl& url) {
    latest_.emplace_back(fingerprint, url);
    if (latest_.size() > kKept) latest_.pop_front();
  }
  /// Invalid if it is no longer known.
  QUrl find(const std::string& fingerprint) const {
    for (auto at = latest_.rbegin(); at != latest_.rend(); ++at) {
      if (at->first == fingerprint) return at->second;
    }
    return {};
  }

 private:
  static constexpr std::size_t kKept = 32;
  std::deque<std::pair<std::string, QUrl>> latest_;
};

}  // namespace mapwright::robot::axbot
