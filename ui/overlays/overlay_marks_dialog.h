// Landmarks and barcodes that a robot has collected: which of them become overlays.
#pragma once

#include <vector>

#include <QDialog>

#include "overlays/overlay_marks.h"

class QPushButton;
class QTableWidget;

namespace mapwright::ui {

class OverlayMarksDialog : public QDialog {
  Q_OBJECT
 public:
  /// `note`: a sentence about what could not be loaded; empty = none.
  OverlayMarksDialog(std::vector<overlays::MarkOffer> offers, const QString& note, QWidget* parent = nullptr);

  QTableWidget* table() const { return table_; }
  QPushButton* takeButton() const { return take_; }
  /// Those with a check mark.
  std::vector<overlays::MarkOffer> chosen() const;

 private:
  void refresh();

  std::vector<overlays::MarkOffer> offers_;
  QTableWidget* table_;
  QPushButton *take_, *cancel_;
};

}  // namespace mapwright::ui
