#include "ui/maps/maps_model.h"

#include <algorithm>

#include <QBuffer>
#include <QCoreApplication>
#include <QDateTime>
#include <QGuiApplication>
#include <QImageReader>

#include "robot/sends_map.h"
#include "sentences/failure_sentence.h"
#include "sentences/state_words.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

constexpr qsizetype kLongestTitle = 300;
constexpr int kLargestThumbnail = 4'096;

QString sectionTitle(map::MapKind kind) {
  switch (kind) {
    case map::MapKind::Live:
      return QCoreApplication::translate("window", "Live");
    case map::MapKind::Stored:
      return QCoreApplication::translate("window", "Stored maps");
    case map::MapKind::Mapping:
      return QCoreApplication::translate("window", "Mappings");
    case map::MapKind::File:
      return QCoreApplication::translate("window", "File");
  }
  return {};
}

}  // namespace

QString mapDetail(const map::CatalogueEntry& entry) {
  QStringList parts;
  const QString id = words::plainName(entry.key.id).left(kLongestTitle);
  if (entry.key.kind != map::MapKind::File && !id.isEmpty())
    parts << QCoreApplication::translate("window", "id %1").arg(id);
  if (!entry.file_name.empty() && entry.file_name != entry.name)
    parts << words::plainName(entry.file_name).left(kLongestTitle);
  if (entry.map_version) parts << QStringLiteral("v%1").arg(*entry.map_version);
  const auto date = entry.modified_s ? entry.modified_s : entry.created_s;
  // Beyond these years the clock is wrong.
  if (date && *date > 0 && *date < 4e9) {
    parts << QDateTime::fromSecsSinceEpoch(qint64(*date)).toString(QStringLiteral("yyyy-MM-dd"));
  }
  if (!entry.state.empty()) parts << plainWords(sentences::stateWord(entry.state), 40);
  if (entry.grid && entry.grid->width > 0 && entry.grid->height > 0) {
    parts << QStringLiteral("%1 x %2").arg(countText(entry.grid->width), countText(entry.grid->height));
  }
  if (entry.bytes) parts << bytesText(qint64(std::min<std::uint64_t>(*entry.bytes, 1ULL << 60)));
  return parts.join(QStringLiteral(" · "));
}

QPixmap thumbnailFrom(const QByteArray& png, int edge_px) {
  QBuffer buffer;
  buffer.setData(png);
  QImageReader reader(&buffer);
  reader.setAutoDetectImageFormat(true);
  const QSize size = reader.size();
  if (!size.isValid() || size.isEmpty() || std::max(size.width(), size.height()) > kLargestThumbnail)
    return {};
  reader.setScaledSize(size.scaled(edge_px, edge_px, Qt::KeepAspectRatio).expandedTo({1, 1}));
  const QImage image = reader.read();
  return image.isNull() ? QPixmap() : QPixmap::fromImage(image);
}

void MapsModel::setSession(session::Session* session) {
  beginResetModel();
  session_ = session;
  rows_.clear();
  thumbnails_.clear();
  endResetModel();
  sync();
}

void MapsModel::setFilter(const QString& text) {
  words_ = text.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  sync();
}

std::vector<MapsModel::Row> MapsModel::build() {
  std::vector<Row> rows;
  maps_ = found_ = 0;
  if (!session_) return rows;
  const session::MapSlot& slot = session_->wholeMap();
  const auto open = [&](const map::MapKey& key) {
    return slot.phase() != session::MapSlot::Phase::Empty && slot.key() == key;
  };
  const auto passes = [&](const QString& text) {
    return std::all_of(words_.begin(), words_.end(),
                       [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
  };
  // A robot may list it, too.
  const bool listed = session_->catalogue().find({map::MapKind::Live, {}}) != nullptr;
  if (robot::sendsItsMap(session_->robot()) && !listed) {
    Row row;
    row.kind = RowKind::Live;
    row.key.kind = map::MapKind::Live;
    row.title = tr("Live map");
    row.detail = tr("as the robot sends it");
    row.nameless = true;
    row.open = open(row.key);
    if (passes(row.title)) rows.push_back(row);
  }
  // Maps fetched by region are not listed by the robot; they are here as long as they are shown.
  if (slot.cells() && slot.shown().state_of) {
    Row row;
    row.kind = RowKind::Fetched;
    row.key = slot.shown().key;
    row.title = mapTitle(slot.shown().name);
    row.detail = tr("%1, %2 x %3 cells")
                     .arg(words::plainName(row.key.id), countText(slot.reference().width),
                          countText(slot.reference().height));
    if (passes(row.title + QLatin1Char(' ') + row.detail)) rows.push_back(row);
  }
  using Section = std::pair<map::MapKind, bool>;
  std::optional<Section> section;
  for (const map::CatalogueEntry& entry : session_->catalogue().entries()) {
    ++maps_;
    Row row{RowKind::Map,     entry.key,          mapTitle(entry.name),
            mapDetail(entry), entry.name.empty(), entry.is_current && !local(),
            open(entry.key)};
    if (!passes(QString::fromStdString(entry.name) + QLatin1Char(' ') + row.detail)) continue;
    ++found_;
    if (section != Section(entry.key.kind, entry.is_archived)) {
      section = Section(entry.key.kind, entry.is_archived);
      Row heading;
      heading.kind = RowKind::Section;
      heading.title = entry.is_archived ? tr("Archived maps") : sectionTitle(entry.key.kind);
      heading.nameless = true;
      rows.push_back(std::move(heading));
    }
    rows.push_back(std::move(row));
    if (!session_->robot().mapTransfer() || entry.key.kind != map::MapKind::Stored) continue;
    Row below{RowKind::Submaps, entry.key, tr("Its submaps"), tr("download and open"), false, false, false};
    rows.push_back(std::move(below));
  }
  return rows;
}

void MapsModel::sync() {
  // What has changed has another picture.
  std::erase_if(thumbnails_, [this](const auto& one) {
    return !session_ || !session_->catalogue().hasThumbnail(one.first);
  });
  std::vector<Row> fresh = build();
  if (fresh == rows_) return;
  const bool same_rows =
      fresh.size() == rows_.size() &&
      std::equal(fresh.begin(), fresh.end(), rows_.begin(),
                 [](const Row& a, const Row& b) { return a.kind == b.kind && a.key == b.key; });
  if (same_rows) {
    rows_ = std::move(fresh);
    Q_EMIT dataChanged(index(0), index(int(rows_.size()) - 1));
    return;
  }
  beginResetModel();
  rows_ = std::move(fresh);
  endResetModel();
}

void MapsModel::thumbnailArrived(const map::MapKey& key) {
  thumbnails_.erase(key);
  const QModelIndex at = indexOf(key);
  if (at.isValid()) Q_EMIT dataChanged(at, at, {ThumbnailRole});
}

QPixmap MapsModel::thumbnail(const map::MapKey& key) const {
  if (const auto found = thumbnails_.find(key); found != thumbnails_.end()) return found->second;
  const QByteArray bytes = session_ ? session_->catalogue().thumbnail(key) : QByteArray();
  if (bytes.isEmpty()) return {};
  const double ratio = qApp->devicePixelRatio();
  QPixmap pixmap = thumbnailFrom(bytes, int(kThumbnailPx * ratio));
  if (pixmap.isNull()) session_->catalogue().discardThumbnail(key);
  pixmap.setDevicePixelRatio(ratio);
  thumbnails_[key] = pixmap;
  return pixmap;
}

bool MapsModel::local() const { return session_ && session_->robot().isLocal(); }

QString MapsModel::noPictureReason(const Row& row) const {
  if (row.kind != RowKind::Map || !session_) return {};
  const session::Catalogue& catalogue = session_->catalogue();
  const map::CatalogueEntry* const entry = catalogue.find(row.key);
  if (entry && !entry->has_thumbnail) return QLatin1Char('\n') + tr("This robot sends no preview of it.");
  const map::Failure* const why = catalogue.noThumbnailReason(row.key);
  return why ? QLatin1Char('\n') + QString::fromStdString(sentences::sentenceOf(*why)) : QString();
}

int MapsModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(rows_.size()); }

QVariant MapsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= int(rows_.size())) return {};
  const Row& row = rows_[std::size_t(index.row())];
  const auto badges = [&row] {
    QStringList words;
    if (row.current) words << tr("current");
    if (row.open) words << tr("open");
    return words;
  };
  switch (role) {
    case Qt::DisplayRole:
      return row.title;
    case Qt::ToolTipRole:
      if (row.kind == RowKind::Section) return {};
      if (row.kind == RowKind::Fetched)
        return plainToolTip(tr("%1\n%2\nKept until another map is shown. Double-click to preview it.")
                                .arg(row.title, row.detail));
      if (row.kind == RowKind::Submaps)
        return plainToolTip(
            tr("Double-click to download this map with its data and to open its submaps, trajectories and "
               "loop closures.\nThis changes nothing on the robot."));
      return plainToolTip(
          (local() ? tr("%1\n%2\nDouble-click to open it.")
                   : tr("%1\n%2\nDouble-click to open it here. This loads and changes nothing on the robot."))
              .arg(row.title, row.detail) +
          noPictureReason(row));
    case Qt::AccessibleTextRole: {
      QStringList said{row.title};
      if (!row.detail.isEmpty()) said << row.detail;
      return words::listed(said + badges());
    }
    case KindRole:
      return int(row.kind);
    case DetailRole:
      return row.detail;
    case NamelessRole:
      return row.nameless;
    case BadgesRole:
      return badges();
    case CurrentRole:
      return row.current;
    case ThumbnailRole:
      return row.kind == RowKind::Map ? QVariant(thumbnail(row.key)) : QVariant();
    default:
      return {};
  }
}

Qt::ItemFlags MapsModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  return rows_[std::size_t(index.row())].kind == RowKind::Section ? Qt::ItemFlags(Qt::NoItemFlags)
                                                                  : QAbstractListModel::flags(index);
}

std::optional<map::MapKey> MapsModel::key(const QModelIndex& index) const {
  if (!index.isValid() || index.row() >= int(rows_.size())) return std::nullopt;
  const Row& row = rows_[std::size_t(index.row())];
  return row.kind == RowKind::Section ? std::nullopt : std::optional(row.key);
}

bool MapsModel::is(const QModelIndex& index, RowKind kind) const {
  return index.isValid() && index.row() < int(rows_.size()) && rows_[std::size_t(index.row())].kind == kind;
}

QModelIndex MapsModel::indexOf(const map::MapKey& key) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const RowKind kind = rows_[i].kind;
    if (kind != RowKind::Section && kind != RowKind::Submaps && rows_[i].key == key) return index(int(i));
  }
  return {};
}

}  // namespace mapwright::ui

#include "moc_maps_model.cpp"
