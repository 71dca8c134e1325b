// The projections of a draft as rows of a table.
#pragma once

#include <QAbstractTableModel>

#include "ui/clouds/projection_draft.h"

namespace mapwright::ui {

class ProjectionsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { X, Y, Width, Height, MinZ, MaxZ, Frame, kColumns };

  /// The draft must outlive this; call refresh() after changing it.
  explicit ProjectionsModel(const ProjectionDraft* draft, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

  void setEditable(bool editable);
  void refresh();

 Q_SIGNALS:
  void edited(int row, const mapwright::map::Projection& projection);

 private:
  const ProjectionDraft* draft_;
  int rows_ = 0;  // as known to the view
  bool editable_ = false;
};

/// Why it cannot be sent; empty = it can.
QString flawText(map::ProjectionFlaw flaw);

}  // namespace mapwright::ui
