// Asks what a map made of a picture is called and where it lies, and shows it there.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QDialog>
#include <QImage>

#include "geometry/pose.h"
#include "geometry/rect.h"
#include "jobs/new_map.h"

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace mapwright::ui {

/// A picture over what is known of the robot's present map: both in their places.
class PlacePreview : public QWidget {
  Q_OBJECT
 public:
  explicit PlacePreview(QWidget* parent = nullptr);
  void setPicture(const QImage& picture) {
    picture_ = picture;
    update();
  }
  /// Empty = there is none.
  void setPresent(const geometry::WorldRect& map, const std::optional<geometry::Pose2>& robot);
  /// Where the picture lies; empty = unknown.
  void setPlace(const geometry::WorldRect& place);
  QSize sizeHint() const override { return {420, 240}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage picture_;
  geometry::WorldRect present_, place_;
  std::optional<geometry::Pose2> robot_;
};

class NewMapDialog : public QDialog {
  Q_OBJECT
 public:
  /// `size`: of the picture in pixels; `shown`: a small copy of it.
  NewMapDialog(const QString& path, const QSize& size, const QImage& shown, QWidget* parent = nullptr);

  void setPresent(const geometry::WorldRect& map, const std::optional<geometry::Pose2>& robot);
  /// Says live what is to be known of a name; empty = nothing.
  void setRemark(std::function<QString(const QString& name)> remark);
  jobs::PictureMap picture() const;
  QLineEdit* nameEdit() const { return name_; }
  QDoubleSpinBox* resolutionBox() const { return resolution_; }
  QDoubleSpinBox* xBox() const { return x_; }
  QDoubleSpinBox* yBox() const { return y_; }
  QPushButton* acceptButton() const { return accept_; }
  QString sizeShown() const;
  QString errorShown() const;

 private:
  void check();

  const QString path_;
  const QSize size_px_;
  QLineEdit* name_;
  QDoubleSpinBox *resolution_, *x_, *y_;
  QLabel *size_, *error_;
  std::function<QString(const QString&)> remark_;
  PlacePreview* preview_;
  QPushButton *accept_, *cancel_;
};

}  // namespace mapwright::ui
