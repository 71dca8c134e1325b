// The rows of the list of overlays, and which of them are shown.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include <QAbstractTableModel>

#include "edit/overlays/overlay_editing.h"
#include "ui/kit/sorted_rows.h"
#include "ui/overlays/overlay_text.h"

namespace mapwright::ui {

/// What the list may be filtered by; bits.
enum OverlayFilterBit {
  kOverlayUnsaved = 1,
  kOverlayChangedThere = 2,
  kOverlayInConflict = 4,
  kOverlayFlawed = 8
};

class OverlaysModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { NameColumn, TypeColumn, StateColumn, kColumns };
  static constexpr int kBitsRole = Qt::UserRole + 1;
  static constexpr int kNamelessRole = Qt::UserRole + 2;

  /// `editing` must outlive this.
  explicit OverlaysModel(edit::OverlayEditing* editing, QObject* parent = nullptr);
  void setFlawed(std::set<FeatureKey> keys);

  FeatureKey key(const QModelIndex& index) const { return rows_[std::size_t(index.row())].key; }
  QModelIndex indexOf(FeatureKey key) const;  // invalid: it has no row

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// What is shown of one, made once for as long as it stays the same.
  struct Row {
    FeatureKey key = 0;
    std::optional<Feature> feature;
    QString name, kind;
    overlays::EditingDocument::State state = overlays::EditingDocument::State::Same;
    bool nameless = false;
    int bits = 0;
  };

  void onEditingChanged();
  int bits(FeatureKey key, overlays::EditingDocument::State state) const;
  QString stateText(const Row& row) const;
  /// As it is, or as the robot holds it when it was deleted here.
  const Feature* shown(FeatureKey key) const;

  edit::OverlayEditing* editing_;
  Row rowOf(FeatureKey key, const Row* before) const;

  std::vector<Row> rows_;
  std::set<FeatureKey> flawed_, conflicting_;
};

/// By name, type or id; "Wall 2" stands before "Wall 10".
class OverlayFilter : public SortedRows {
  Q_OBJECT
 public:
  explicit OverlayFilter(QObject* parent = nullptr);
  void look(const QString& text);
  void lookForBits(int bits);  // 0 = all

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  SortValue sortValue(const QModelIndex& source) const override;

 private:
  QString wanted_;
  int bits_ = 0;
};

}  // namespace mapwright::ui
