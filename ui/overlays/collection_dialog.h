// What belongs to all overlays of a map: the sizes of racks and pallets that are usual there.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <QDialog>

#include "overlays/overlay_document.h"

class QDoubleSpinBox;
class QPushButton;

namespace mapwright::ui {

class CollectionDialog : public QDialog {
  Q_OBJECT
 public:
  static constexpr std::size_t kSizes = 4;

  /// `collection`: the members of the collection as they are.
  explicit CollectionDialog(const overlays::Feature& collection, QWidget* parent = nullptr);

  QDoubleSpinBox* box(std::size_t index) const { return boxes_[index]; }
  QPushButton* applyButton() const { return apply_; }
  /// With what was changed here; all else as it was.
  overlays::Feature edited() const;

 private:
  overlays::Feature before_;
  std::array<QDoubleSpinBox*, kSizes> boxes_{};
  std::array<double, kSizes> shown_{};
  QPushButton *apply_, *cancel_;
};

}  // namespace mapwright::ui
