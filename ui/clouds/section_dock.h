// The section of a cloud, with the width of its strip and the values under the cursor.
#pragma once

#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QToolButton>

#include "ui/clouds/section_view.h"
#include "ui/kit/plain_label.h"

namespace mapwright::ui {

class SectionDock : public QDockWidget {
  Q_OBJECT
 public:
  SectionDock(std::shared_ptr<work::Workers> workers, QWidget* parent = nullptr);

  void showSection(std::shared_ptr<const clouds::Section> section, render::TilePainter painter);
  SectionView* view() const { return view_; }
  QDoubleSpinBox* widthBox() const { return width_; }
  QString told() const { return told_->text(); }

 Q_SIGNALS:
  void widthChosen(double metres);
  /// Metres along the line; nullopt = the cursor has left.
  void looksAt(std::optional<double> along_m);

 private:
  void updateText();
  SectionView* view_;
  QDoubleSpinBox* width_;
  PlainLabel* told_;
};

}  // namespace mapwright::ui
