// One plot: curves over time, painted here. It knows no robot and no bag: what it is to show it is told, and
// what the hand wants of others it says.
//
// Wheel: zoom about the pointer (on the value axis, or with Ctrl: the values). Drag: move. Click: go to that
// time. Double click: all of it. Keys: + - Left Right Up Down Home End, F for all, Delete for the last curve.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <QPixmap>
#include <QString>
#include <QWidget>

#include "series/series.h"
#include "window/plots/plot_wish.h"

class QMenu;

namespace mapwright::window {

struct PlotCurve {
  PlotWish wish;
  std::shared_ptr<const series::Series> series;
  int look = 0;
};

class PlotWidget : public QWidget {
  Q_OBJECT
 public:
  using Range = std::pair<double, double>;

  explicit PlotWidget(QWidget* parent = nullptr);

  void setCurves(std::vector<PlotCurve> curves);
  const std::vector<PlotCurve>& curves() const { return curves_; }
  /// What of them has changed is drawn.
  void refresh();
  /// The time that is shown; seconds since the epoch.
  void setSpan(Range span);
  Range span() const { return span_; }
  /// As far as one can go: the bag's.
  void setBounds(Range bounds) { bounds_ = bounds; }
  /// Where the replay is; nullopt = nowhere.
  void setCurrent(std::optional<double> at_s);
  /// Of a robot that speaks: what is now; nullopt = nothing does.
  void setPresent(std::optional<double> at_s);
  /// Where the pointer is, in this plot or another one.
  void setPointed(std::optional<double> at_s);
  /// The values that are shown; nullopt: those that there are.
  void setFixedValues(std::optional<Range> values);
  std::optional<Range> fixedValues() const { return fixed_; }
  Range values() const;
  /// Seconds after this instead of the time of day.
  void setSince(std::optional<double> since_s);
  /// What is said where nothing is to be seen.
  void setHint(const QString& hint);

  /// Where curves are drawn.
  QRect area() const;
  double timeAt(double x_px) const;
  double xOf(double at_s) const;
  double yOf(double value) const;
  /// What the legend says of a curve: its value where the pointer is, else at the cursor, else at present.
  QString valueAtCursor(std::size_t curve) const;
  /// What the menu offers. `menu` is empty.
  void fillMenu(QMenu& menu);

  QSize sizeHint() const override { return {480, 160}; }
  QSize minimumSizeHint() const override { return {160, 90}; }

 Q_SIGNALS:
  void seekWanted(double at_s);
  void spanWanted(double from_s, double until_s);
  void allWanted();
  void pointed(std::optional<double> at_s);
  void dropped(const mapwright::window::PlotWish& wish);
  void curveUnwanted(int curve);
  void plotUnwanted();
  void sinceWanted(bool seconds);  // or the time of day

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  struct Legend {
    struct Item {
      QRect rect;
      std::size_t curve;
    };
    std::vector<Item> items;
    int height = 0;
  };
  Legend legend() const;
  Range autoValues() const;
  void paintStill(QPainter& painter) const;  // all but what follows the cursor
  void paintAxes(QPainter& painter) const;
  void paintCurve(QPainter& painter, const PlotCurve& curve) const;
  void paintMoving(QPainter& painter) const;
  void zoomTime(double factor, double about_s);
  void zoomValues(double factor, double about);
  void moveTime(double by_s);
  void moveValues(double by);
  void want(double from_s, double until_s);
  void askForValues();
  bool isOnValueAxis(const QPoint& at) const { return at.x() < area().left(); }

  std::vector<PlotCurve> curves_;
  Range span_{0, 60}, bounds_{0, 60};
  std::optional<double> cursor_s_, pointed_s_, present_s_, since_s_;
  std::optional<Range> fixed_;
  QString hint_;
  mutable std::optional<Range> auto_;  // as it was last reckoned
  QPixmap still_;
  bool stale_ = true;
  struct Grip {
    QPoint at;
    Range span, values;
    bool moved = false, values_only = false;
  };
  std::optional<Grip> grip_;
};

}  // namespace mapwright::window
