// The plots beside the map: one below the other, over the same time.
#pragma once

#include <optional>
#include <vector>

#include <QDockWidget>
#include <QString>
#include <QStringList>
#include <QTimer>

#include "window/plots/plot_feed.h"
#include "window/plots/plot_widget.h"

class QLineEdit;
class QPushButton;
class QSplitter;
class QStringListModel;
class QToolButton;

namespace mapwright::window {

class PlainLabel;

class PlotsDock : public QDockWidget {
  Q_OBJECT
 public:
  static constexpr int kMostPlots = 6, kMostCurves = 32;  // curves of all plots together

  /// `feed` is there as long as anything is done with it.
  explicit PlotsDock(PlotFeed& feed, QWidget* parent = nullptr);
  ~PlotsDock() override;

  /// A bag of this time (seconds since the epoch) is open: all of it is shown.
  void openBag(double start_s, double end_s);
  /// It has become longer.
  void extendBag(double end_s);
  /// From now on the plots are of the robot, if there is one.
  void closeBag();
  /// Where the replay is.
  void setCurrent(double at_s);
  /// Who gives the samples has another robot.
  void sourceChanged();

  const std::vector<PlotWidget*>& plots() const { return plots_; }
  /// Empty, below the others; null: there are as many as there may be.
  PlotWidget* addPlot();
  void removePlot(PlotWidget* plot);
  /// False: it is there already, or there are as many as there may be; a sentence says so.
  bool addCurve(PlotWidget* plot, const PlotWish& wish);
  void removeCurve(PlotWidget* plot, int curve);
  /// In the plot at hand if it fits there by its unit, else in one of its own.
  void addQuantity(series::Quantity quantity);
  /// What the user typed.
  void addTyped();

  QLineEdit* pathEdit() const { return path_; }
  QPushButton* addButton() const { return add_; }
  QToolButton* quantitiesButton() const { return quantities_; }
  QPushButton* newPlotButton() const { return new_plot_; }
  QPushButton* wholeButton() const { return whole_; }
  /// What was wrong last; empty = nothing.
  QString saidText() const;

  /// What is plotted, for settings.
  QString layout() const;
  /// False: that was none, and nothing has changed.
  bool restoreLayout(const QString& layout);
  void clearPlots();

 Q_SIGNALS:
  void seekWanted(double at_s);
  /// All of the bag is to be read, or what is needed only.
  void wholeWanted(bool whole);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* buildControls();
  void wire(PlotWidget* plot);
  void setCurves(PlotWidget* plot, std::vector<PlotCurve> curves);
  void refresh();
  void follow();
  void showAll();
  void setSpan(PlotWidget::Range span);
  void say(const QString& sentence);
  void updateControls();
  PlotWidget* atHand() const;

  PlotFeed& feed_;
  std::vector<PlotWidget*> plots_;
  PlotWidget* at_hand_ = nullptr;
  std::optional<PlotWidget::Range> bag_;
  PlotWidget::Range span_{0, 60};
  std::optional<double> current_s_;
  bool seconds_ = false, follows_ = true, on_screen_ = false;
  QTimer follow_timer_;
  QSplitter* stack_;
  QLineEdit* path_;
  QStringListModel* paths_;
  QPushButton *add_, *new_plot_, *whole_;
  QToolButton* quantities_;
  PlainLabel* said_;
};

}  // namespace mapwright::window
