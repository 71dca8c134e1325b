// The robot's map catalogue as rows with thumbnails: requested on demand, kept while it is refreshed.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include <QDateTime>
#include <QObject>

#include "map/catalogue.h"
#include "robot/robot.h"

namespace mapwright::session {

/// GUI-thread object. The robot must outlive it.
class Catalogue : public QObject {
  Q_OBJECT
 public:
  explicit Catalogue(robot::MapCatalogue* source, QObject* parent = nullptr);

  bool offered() const { return source_ != nullptr; }
  /// The robot's catalogue, or null if it has none now: then the rows are cleared.
  void setSource(robot::MapCatalogue* source);
  /// Requests it again; while an answer is pending it only remembers to request once more afterwards.
  void refresh();
  bool loading() const { return loading_; }
  /// Whether it was ever requested.
  bool asked() const { return asked_once_; }
  /// Why the last request failed; nullopt if it did not. The previous rows stay.
  const std::optional<map::Failure>& failure() const { return failure_; }
  std::optional<QDateTime> asOf() const { return as_of_; }
  /// Stored maps first, then archived ones, then mappings; each newest first, or in the robot's own order.
  const std::vector<map::CatalogueEntry>& entries() const { return entries_; }
  const map::CatalogueEntry* find(const map::MapKey& key) const { return map::entryOf(entries_, key); }
  const map::CatalogueEntry* current() const { return map::currentOf(entries_); }
  /// The row for `text` (map::toText); nullptr if there is none.
  const map::CatalogueEntry* called(const std::string& text) const;

  /// The thumbnail (PNG bytes), or empty: then it is requested, and thumbnailArrived() follows. A failed one
  /// is not requested again until its row changes.
  QByteArray thumbnail(const map::MapKey& key);
  bool hasThumbnail(const map::MapKey& key) const { return thumbnails_.contains(key); }
  /// It cannot be decoded: do not cache it.
  void discardThumbnail(const map::MapKey& key);
  /// Why there is none, as far as that is known; nullptr: there is one, or it was not asked for.
  const map::Failure* noThumbnailReason(const map::MapKey& key) const;
  /// Nobody looks at them now: those that are on their way are asked for again when they are wanted.
  void releaseThumbnails();

 Q_SIGNALS:
  void changed();
  void thumbnailArrived(const mapwright::map::MapKey& key);  // or there is none

 private:
  void onAnswer(robot::Outcome<std::vector<map::CatalogueEntry>> answer);
  void askForThumbnails();
  void onThumbnail(const map::MapKey& key, robot::Outcome<std::string> answer);

  robot::MapCatalogue* source_;
  bool loading_ = false, again_ = false, asked_once_ = false;
  std::optional<map::Failure> failure_;
  std::optional<QDateTime> as_of_;
  std::vector<map::CatalogueEntry> entries_;
  std::map<map::MapKey, QByteArray> thumbnails_;
  std::set<map::MapKey> asked_;
  std::vector<map::MapKey> wanted_;
  std::map<map::MapKey, robot::Call> thumbnails_in_progress_;
  std::map<map::MapKey, map::Failure> no_thumbnail_;
};

}  // namespace mapwright::session
