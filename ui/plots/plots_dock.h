// The plots next to the map: one below the other, with the same time axis.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QDockWidget>
#include <QString>
#include <QStringList>
#include <QTimer>

#include "ui/plots/plot_feed.h"
#include "ui/plots/plot_widget.h"

class QLineEdit;
class QPushButton;
class QSplitter;
class QStringListModel;
class QToolButton;

namespace mapwright::ui {

class PlainLabel;

class PlotsDock : public QDockWidget {
  Q_OBJECT
 public:
  static constexpr int kMostPlots = 6, kMostCurves = 32;  // curves of all plots together

  /// `feed` must outlive its use here.
  explicit PlotsDock(PlotFeed& feed, QWidget* parent = nullptr);
  ~PlotsDock() override;

  /// A bag with this time range (seconds since the epoch) was opened: shows all of it.
  void openBag(double start_s, double end_s);
  /// It has become longer.
  void extendBag(double end_s);
  /// From now on the plots are about the robot, if there is one.
  void closeBag();
  /// Where the replay is.
  void setCurrent(double at_s);
  /// The feed has another robot.
  void sourceChanged();

  const std::vector<PlotWidget*>& plots() const { return plots_; }
  /// Empty, below the others; null: the maximum is reached.
  PlotWidget* addPlot();
  void removePlot(PlotWidget* plot);
  /// Fields of topics, but not of these; quantities of any robot stay. A sentence names what was removed.
  void removeFields(const std::set<std::string>& but_of = {});
  /// False: it exists already, or the maximum is reached; a sentence explains it.
  bool addCurve(PlotWidget* plot, const PlotSelection& selection);
  void removeCurve(PlotWidget* plot, int curve);
  /// In the active plot if its unit fits, otherwise in a new one.
  void addQuantity(series::Quantity quantity);
  /// What the user typed.
  void addTyped();

  QLineEdit* pathEdit() const { return path_; }
  QPushButton* addButton() const { return add_; }
  QToolButton* quantitiesButton() const { return quantities_; }
  QPushButton* newPlotButton() const { return new_plot_; }
  QPushButton* wholeButton() const { return whole_; }
  /// The last error; empty = none.
  QString saidText() const;

  /// What is plotted, for settings.
  QString layout() const;
  /// False: invalid, and nothing has changed.
  bool restoreLayout(const QString& layout);
  void clearPlots();

 Q_SIGNALS:
  void seekWanted(double at_s);
  /// Read the whole bag, or only what is needed.
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

}  // namespace mapwright::ui
