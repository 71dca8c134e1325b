// The middle part of the SLAM inspector: filter, groups, what to draw.
#pragma once

#include <QWidget>

#include "render/tile_renderer.h"

class QAction;
class QCheckBox;
class QComboBox;
class QLineEdit;
class QSpinBox;

namespace mapwright::window {

class InspectorControls : public QWidget {
  Q_OBJECT
 public:
  InspectorControls(QAction* show_ids, QAction* show_outlines, QWidget* parent = nullptr);

  QString filterText() const;
  void setGroups(Qt::CheckState nearby, int nearby_count, Qt::CheckState incremental, int incremental_count);
  void setSlices(int present, int how_many);
  void setColorMode(render::ColorMode mode);
  QLineEdit* filterEdit() const { return filter_; }

 Q_SIGNALS:
  void filterChanged(const QString& text);
  void nearbyWanted(bool visible);
  void incrementalWanted(bool visible);
  void sliceWanted(int slice);
  void colorModeWanted(mapwright::render::ColorMode mode);

 private:
  QCheckBox* addGroup(const QString& name, const QString& tip);
  QLineEdit* filter_;
  QCheckBox* nearby_;
  QCheckBox* incremental_;
  QSpinBox* slice_;
  QComboBox* colors_;
};

}  // namespace mapwright::window
