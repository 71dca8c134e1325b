// Where submaps contradict each other: how much, the places, and buttons that step through the submaps of
// one.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QAbstractTableModel>
#include <QDockWidget>

#include "agreement/survey.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;

namespace mapwright::ui {

class PlainLabel;

/// How many cells of a place it holds occupied that others saw free, and the other way round.
QString claimText(const agreement::Part& part);

/// In their order: the worst first.
class PlacesModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { CellsColumn, XColumn, YColumn, SubmapsColumn, kColumns };
  using QAbstractTableModel::QAbstractTableModel;

  using Places = std::shared_ptr<const std::vector<agreement::Place>>;  // never null
  void setPlaces(Places places);
  const agreement::Place& place(int row) const { return (*places_)[std::size_t(row)]; }
  /// -1 = not listed.
  int rowOf(const agreement::Place& place) const;

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : int(places_->size());
  }
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  Places places_ = std::make_shared<std::vector<agreement::Place>>();
};

class DisagreementDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit DisagreementDock(QWidget* parent = nullptr);
  ~DisagreementDock() override;

  void setText(const QString& text);  // plain
  /// The selected place stays selected and where it is seen, though it may have another row; one that is
  /// gone is selected again when it comes back.
  void setPlaces(PlacesModel::Places places);
  enum class Work { Done, Goes, Stopped };
  void setWork(Work work, double share_made);
  /// What can be done about the submap in hand.
  enum class InHand { None, Hide, Show };
  /// `text`: which submap is in hand, and what it says; empty: none is. `possible`: a place is chosen.
  void setSteps(bool possible, bool stepping, const QString& text, InHand in_hand);
  /// Whether the user has hidden any.
  void setHidden(bool any);
  void setTolerance(int cells, double cell_m);
  int tolerance() const;
  void clearSelection();

  QTableView* table() const { return table_; }
  PlacesModel* model() const { return model_; }
  QLabel* summary() const { return summary_; }
  QComboBox* toleranceBox() const { return tolerance_; }
  QCheckBox* layerBox() const { return layer_; }
  QPushButton* workButton() const { return work_; }
  QPushButton* blinkButton() const { return blink_; }
  QPushButton* nextButton() const { return next_; }
  QPushButton* allButton() const { return all_; }
  QPushButton* hideButton() const { return hide_; }
  QPushButton* showHiddenButton() const { return show_hidden_; }

 Q_SIGNALS:
  void placeWanted(int row);  // by a click or Enter

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  PlacesModel* model_;
  std::optional<agreement::Place> chosen_;
  QComboBox* tolerance_;
  QCheckBox* layer_;
  QLabel* summary_;
  QProgressBar* progress_;
  QPushButton* work_;
  QTableView* table_;
  QWidget* steps_;
  PlainLabel* shown_;
  QPushButton *blink_, *next_, *all_, *hide_, *show_hidden_;
};

}  // namespace mapwright::ui
