// One plot: curves over time, painted here. It knows no robot and no bag: data is set from outside, and user
// actions are signals.
// Wheel: zoom around the pointer (on the value axis, or with Ctrl: the values). Drag: move. Click: go to that
// time. Double click: show all. Keys: + - Left Right Up Down Home End, F for all, Delete for the last curve.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <QColor>
#include <QPixmap>
#include <QString>
#include <QWidget>

#include "series/series.h"
#include "ui/plots/plot_selection.h"

class QMenu;

namespace mapwright::ui {

// The looks of curves: colours, and shapes of their marks.
inline constexpr int kPlotLooks = 8;
/// Of curve `look` (any number; they repeat). At least 3:1 against the background of both themes, and
/// distinguishable for colour-blind people. After Okabe and Ito, "Color Universal Design" (2008).
QColor plotColor(int look, bool dark);
/// Its mark: a disc, a square, a triangle … around `at`.
void paintPlotMark(QPainter& painter, int look, const QColor& color, const QPointF& at, double radius_px);

struct PlotCurve {
  PlotSelection selection;
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
  /// Their data has changed: repaints.
  void refresh();
  /// The time that is shown; seconds since the epoch.
  void setSpan(Range span);
  Range span() const { return span_; }
  /// The limits: those of the bag.
  void setBounds(Range bounds) { bounds_ = bounds; }
  /// The present time of the replay; nullopt = none.
  void setCurrent(std::optional<double> at_s);
  /// The present time of a live robot; nullopt = none.
  void setPresent(std::optional<double> at_s);
  /// The time under the pointer, in this plot or another one.
  void setPointed(std::optional<double> at_s);
  /// The value range; nullopt: fit automatically.
  void setFixedValues(std::optional<Range> values);
  std::optional<Range> fixedValues() const { return fixed_; }
  Range values() const;
  /// Shows seconds after this instead of the time of day.
  void setSince(std::optional<double> since_s);
  /// Shown if there is nothing to see.
  void setHint(const QString& hint);

  /// Where curves are drawn.
  QRect area() const;
  double timeAt(double x_px) const;
  double xOf(double at_s) const;
  double yOf(double value) const;
  /// The legend's value of a curve: under the pointer, otherwise at the cursor or at present.
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
  void dropped(const mapwright::ui::PlotSelection& selection);
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
  void paintStill(QPainter& painter) const;  // everything that does not follow the cursor
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
  mutable std::optional<Range> auto_;  // as last computed
  QPixmap still_;
  bool stale_ = true;
  struct Grip {
    QPoint at;
    Range span, values;
    bool moved = false, values_only = false;
  };
  std::optional<Grip> grip_;
};

}  // namespace mapwright::ui
