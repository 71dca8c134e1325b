// The rows of the catalogue: the live map, maps fetched from it, sections, maps, and below each map what of
// its SLAM session can be downloaded; filtered by the search text.
#pragma once

#include <map>
#include <vector>

#include <QAbstractListModel>
#include <QPixmap>
#include <QPointer>

#include "session/session.h"

namespace mapwright::ui {

class MapsModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum class RowKind { Live, Fetched, Section, Map, Submaps };
  enum Role {
    KindRole = Qt::UserRole,  // RowKind
    DetailRole,               // second line
    BadgesRole,               // QStringList of words: first "current", then "open"
    CurrentRole,              // bool: the robot works with it
    ThumbnailRole,            // QPixmap, null while there is none
    NamelessRole,             // bool: the name is a placeholder, not the robot's
  };
  static constexpr int kThumbnailPx = 48;

  using QAbstractListModel::QAbstractListModel;

  /// Not owned; null = none.
  void setSession(session::Session* session);
  /// Shows maps whose name, id or details contain all words of `text`.
  void setFilter(const QString& text);
  /// Updates from the catalogue and the open map.
  void sync();
  void thumbnailArrived(const map::MapKey& key);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

  /// nullopt for sections.
  std::optional<map::MapKey> key(const QModelIndex& index) const;
  /// It was fetched from the robot's map and is not stored on the robot.
  bool isFetched(const QModelIndex& index) const { return is(index, RowKind::Fetched); }
  /// It stands for the submaps of the map above it, which has the same key.
  bool isSubmaps(const QModelIndex& index) const { return is(index, RowKind::Submaps); }
  QModelIndex indexOf(const map::MapKey& key) const;
  int maps() const { return maps_; }    // of the robot
  int found() const { return found_; }  // rows that match the filter

 private:
  struct Row {
    RowKind kind = RowKind::Map;
    map::MapKey key;
    QString title, detail;
    bool nameless = false, current = false, open = false;
    bool operator==(const Row&) const = default;
  };
  std::vector<Row> build();
  bool is(const QModelIndex& index, RowKind kind) const;
  QPixmap thumbnail(const map::MapKey& key) const;
  bool local() const;
  /// A line for the tooltip; empty: there is a picture, or it is on its way.
  QString noPictureReason(const Row& row) const;

  QPointer<session::Session> session_;
  QStringList words_;
  std::vector<Row> rows_;
  int maps_ = 0, found_ = 0;
  mutable std::map<map::MapKey, QPixmap> thumbnails_;
};

/// "id 12 · v9 · 2022-02-11 · 2,898 x 2,603", as far as known.
QString mapDetail(const map::CatalogueEntry& entry);
/// A thumbnail from a robot's bytes; null if they are invalid or too large.
QPixmap thumbnailFrom(const QByteArray& png, int edge_px);

}  // namespace mapwright::ui
