// Which clouds of the robot's map to fetch, and how to show them.
#pragma once

#include <optional>

#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "clouds/cloud_store.h"
#include "ui/clouds/color_scale.h"
#include "ui/clouds/height_slider.h"
#include "ui/clouds/region_tool.h"
#include "ui/kit/plain_label.h"

class QVBoxLayout;

namespace mapwright::ui {

/// What can be requested now, by kind; and why not, for a tooltip.
struct CloudOffer {
  bool whole = false, region = false;
  QString unavailable_reason;  // what is missing
};

class CloudsDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit CloudsDock(QWidget* parent = nullptr);

  /// Not empty: why there are no clouds.
  void setAbsence(const QString& sentence);
  void setOffer(const CloudOffer& offer);
  /// Not empty: the progress of a request.
  void setProgress(const QString& words);
  /// The result of the last request; empty = none.
  void setOutcome(const QString& sentence, bool bad);
  void setClouds(const clouds::CloudSums& sums, const clouds::Heights& heights,
                 const std::optional<clouds::HeightRange>& range);
  /// New data is being processed and neither shown nor counted: until setClouds().
  void setSorting();
  void setStyle(const scene::LayerStyle& style);
  /// nullopt: the colours do not depend on a value.
  void setScale(const std::optional<scene::CloudScale>& scale);

  bool voxels() const { return kind_->currentIndex() == 1; }
  RegionShape shape() const { return RegionShape(shape_->currentIndex()); }
  /// The heights to request, low first.
  clouds::HeightRange askedHeights() const;

  QComboBox* kindBox() const { return kind_; }
  QComboBox* shapeBox() const { return shape_; }
  QComboBox* colorBox() const { return color_; }
  QDoubleSpinBox* sizeBox() const { return size_; }
  QDoubleSpinBox* voxelBox() const { return voxel_; }
  QDoubleSpinBox* lowBox() const { return low_; }
  QDoubleSpinBox* highBox() const { return high_; }
  QDoubleSpinBox* askLowBox() const { return ask_low_; }
  QDoubleSpinBox* askHighBox() const { return ask_high_; }
  ColorScale* scale() const { return scale_; }
  HeightSlider* slider() const { return slider_; }
  QPushButton* viewButton() const { return view_; }
  QPushButton* regionButton() const { return region_; }
  QPushButton* wholeButton() const { return whole_; }
  QPushButton* wholeSureButton() const { return sure_; }
  QPushButton* cancelButton() const { return cancel_; }
  QPushButton* saveButton() const { return save_; }
  QPushButton* clearButton() const { return clear_; }
  QString counts() const { return counts_->text(); }
  QString outcome() const { return outcome_->text(); }
  QString absence() const { return absence_->text(); }

 Q_SIGNALS:
  void wholeWanted();
  void rangeChosen(std::optional<mapwright::clouds::HeightRange> range);

 private:
  void buildAsking(QVBoxLayout* column);
  void buildLook(QVBoxLayout* column);
  void buildEnd(QVBoxLayout* column);
  void typedRange();
  void refresh();

  QLabel *absence_, *outcome_ = nullptr, *counts_ = nullptr;
  QWidget *body_, *asking_ = nullptr, *question_ = nullptr, *progress_row_ = nullptr;
  QComboBox *kind_ = nullptr, *shape_ = nullptr, *color_ = nullptr;
  QDoubleSpinBox *ask_low_ = nullptr, *ask_high_ = nullptr, *low_ = nullptr, *high_ = nullptr,
                 *size_ = nullptr, *voxel_ = nullptr;
  QPushButton *view_ = nullptr, *region_ = nullptr, *whole_ = nullptr, *sure_ = nullptr, *cancel_ = nullptr,
              *save_ = nullptr, *clear_ = nullptr;
  HeightSlider* slider_ = nullptr;
  ColorScale* scale_ = nullptr;
  PlainLabel* progress_ = nullptr;
  CloudOffer offer_;
  bool busy_ = false, has_clouds_ = false;
};

}  // namespace mapwright::ui
