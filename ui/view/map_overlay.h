// Lays out the widgets on top of the map: buttons, card, notices, tool hint, toasts.
#pragma once

#include <QAbstractButton>
#include <QFrame>
#include <QObject>
#include <QString>

namespace mapwright::ui {

class Actions;
class CompareBar;
class EmptyStateCard;
class MapFurniture;
class MapView;
class NoticeBar;
class PlainLabel;
class ToastStack;

class MapOverlay : public QObject {
  Q_OBJECT
 public:
  /// All become children of the view.
  MapOverlay(MapView* view, MapFurniture* furniture);

  EmptyStateCard* card() const { return card_; }
  CompareBar* compareBar() const { return compare_bar_; }
  NoticeBar* notice() const { return notice_; }
  /// Safety conditions of the robot: above all other notices.
  NoticeBar* safetyNotice() const { return safety_notice_; }
  /// Where the robot is, if it is not in the map on screen.
  NoticeBar* placeNotice() const { return place_notice_; }
  /// Decisions about what is being edited.
  NoticeBar* editNotice() const { return edit_notice_; }
  ToastStack* toasts() const { return toasts_; }
  MapFurniture* furniture() const { return furniture_; }

  void setHint(const QString& text);  // of the tool; empty hides it
  QString hint() const;
  void setFurnitureVisible(bool visible);
  bool furnitureVisible() const { return furniture_visible_; }
  /// Puts everything where it belongs.
  void layOut();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  MapView* view_;
  MapFurniture* furniture_;
  EmptyStateCard* card_;
  NoticeBar *safety_notice_, *notice_, *place_notice_, *edit_notice_;
  CompareBar* compare_bar_;
  ToastStack* toasts_;
  QFrame* hint_frame_;
  PlainLabel* hint_;
  bool furniture_visible_ = true;
};

class MapOverlay;

/// `text` may come from a robot: invisible characters are removed. `said`: for the toast.
void copyText(MapOverlay& overlay, const QString& text, const QString& said);

/// A needle that points to the map's north (world +y) and rotates with the view; a click rotates the view
/// north up.
class NorthArrow : public QAbstractButton {
  Q_OBJECT
 public:
  explicit NorthArrow(QWidget* parent = nullptr);
  /// The view's rotation: counter-clockwise, radians.
  void setRotation(double rad);
  double rotation() const { return rotation_; }
  QSize sizeHint() const override { return {32, 32}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double rotation_ = 0;
};

class MapFurniture : public QFrame {
  Q_OBJECT
 public:
  /// With those of addCameraActions().
  explicit MapFurniture(const Actions& actions, QWidget* parent = nullptr);
  void setRotation(double rad) { north_->setRotation(rad); }
  NorthArrow* north() const { return north_; }

 private:
  NorthArrow* north_;
};

}  // namespace mapwright::ui
