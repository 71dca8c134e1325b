// What the robot keeps, as rows with thumbnails: asked for when wanted, kept while asked again.
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
  /// The robot can tell its maps from now on, or (null) no more: what was told goes.
  void setSource(robot::MapCatalogue* source);
  /// Asks again; while an answer is awaited this does nothing but remember to ask once more after it.
  void refresh();
  bool loading() const { return loading_; }
  /// Whether anybody has ever asked.
  bool asked() const { return asked_once_; }
  /// Why the last question failed; nullopt when it did not. The rows of before stay.
  const std::optional<map::Failure>& failure() const { return failure_; }
  std::optional<QDateTime> asOf() const { return as_of_; }
  /// Stored maps first, then archived ones, then mappings; each newest first, the robot's own order where it
  /// has one.
  const std::vector<map::CatalogueEntry>& entries() const { return entries_; }
  const map::CatalogueEntry* find(const map::MapKey& key) const;
  const map::CatalogueEntry* current() const;
  /// The row that people call `text` (map::toText); nullptr when there is none.
  const map::CatalogueEntry* called(const std::string& text) const;

  /// The thumbnail (PNG bytes), or empty: then it is asked for, and thumbnailArrived() tells. A failed one is
  /// not asked for again until its row changes.
  QByteArray thumbnail(const map::MapKey& key);
  /// It cannot be decoded: it is kept nowhere.
  void discardThumbnail(const map::MapKey& key);

 Q_SIGNALS:
  void changed();
  void thumbnailArrived(const mapwright::map::MapKey& key);

 private:
  void take(robot::Outcome<std::vector<map::CatalogueEntry>> answer);
  void askForThumbnails();

  robot::MapCatalogue* source_;
  bool loading_ = false, again_ = false, asked_once_ = false;
  std::optional<map::Failure> failure_;
  std::optional<QDateTime> as_of_;
  std::vector<map::CatalogueEntry> entries_;
  std::map<map::MapKey, QByteArray> thumbnails_;
  std::set<map::MapKey> asked_;
  std::vector<map::MapKey> wanted_;
  int thumbnails_under_way_ = 0;
};

}  // namespace mapwright::session
