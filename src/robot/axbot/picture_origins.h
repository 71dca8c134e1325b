// The addresses of the latest pictures.
#pragma once

#include <deque>
#include <string>
#include <utility>

#include <QUrl>

namespace mapwright::robot::axbot {

class PictureOrigins {
 public:
  void note(const std::string& fingerprint, const QUrl& url) {
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
