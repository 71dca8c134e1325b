// The layers of the map: which are drawn, in which order, how strongly and how.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include <QDockWidget>
#include <QPointer>

#include "robot/offers_topics.h"
#include "ui/scene/map_scene.h"

class QFrame;
class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QScrollArea;
class QSettings;
class QSlider;
class QToolButton;
class QVBoxLayout;

namespace mapwright::ui {

class FoldHeader;
class LayerRow;
class PlainLabel;

/// The list matches the map: the top layer is at the top. Groups are a view of that one order, which they do
/// not change: each has its layers as they are painted, and a row that is moved keeps to its group. Without
/// groups all are one list. Rows are moved by dragging, or with Ctrl+Up and Ctrl+Down.
class LayersDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit LayersDock(scene::MapScene* scene, QWidget* parent = nullptr);
  /// Layers without data from this robot are folded away. Null: no robot.
  void setSession(session::Session* session);
  /// Shows what the scene says.
  void sync();
  /// Offered next to the filter. Not owned.
  void setPresets(QMenu* menu);

  LayerRow* row(scene::Layer layer) const;
  QToolButton* eye(scene::Layer layer) const;
  QSlider* opacity(scene::Layer layer) const;
  QLineEdit* filterField() const { return filter_; }
  FoldHeader* header(scene::LayerGroup group) const { return headers_.at(group); }
  FoldHeader* unavailableHeader() const { return unavailable_; }
  /// The sentences above the layers that this robot has no data for.
  QStringList reasonsShown() const;

  bool grouped() const { return grouped_; }
  void setGrouped(bool grouped);
  void setFolded(bool folded);  // all groups

  /// Shows this layer alone. If it already is, everything is shown as before.
  void toggleSolo(scene::Layer layer);
  /// The layer that is shown alone.
  std::optional<scene::Layer> solo() const;
  /// Shows what was there before, if a layer is shown alone.
  void endSolo();
  /// The layers are chosen otherwise: what was there before is of no interest any more.
  void forgetSolo();

  /// The context menu, at a layer or elsewhere.
  void fillMenu(QMenu& menu, std::optional<scene::Layer> layer);

  void saveFolds(QSettings& settings) const;
  void restoreFolds(const QSettings& settings);
  void resetFolds();

 Q_SIGNALS:
  /// The user wants other topics from this robot.
  void topicsChosen(const mapwright::robot::TopicChoices& choices);
  void zoomWanted(mapwright::ui::scene::Layer layer);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  struct Solo {
    scene::Layer layer;
    std::set<scene::Layer> before;  // what was shown
  };
  void makeRows();
  void makeHead();
  void updateAvailability();
  void updateTopics(LayerRow* row);
  void chooseTopic(map::Stream stream, const QString& topic);
  void layOut();
  void layOutUnavailable();
  void put(QWidget* widget);
  void updateCounts();
  void updateSolo();
  bool fits(const LayerRow& row) const;
  /// Those that a row can be moved among: the rows on screen of its group, without groups all of them.
  std::vector<LayerRow*> peers(const LayerRow* row) const;
  void putAt(LayerRow* row, std::size_t index_among_peers);
  void drag(LayerRow* row, int y);
  void commit();
  void move(LayerRow* row, int rows);
  void focusNext(QWidget* from, int rows);
  void fold(FoldHeader* header, bool open);

  scene::MapScene* scene_;
  QPointer<session::Session> session_;
  std::vector<LayerRow*> rows_;  // in the order of the layers, top first
  std::map<scene::LayerGroup, FoldHeader*> headers_;
  FoldHeader* unavailable_;
  std::vector<QLabel*> reasons_;
  std::vector<QWidget*> steps_;  // headers and rows on screen, from top to bottom
  std::set<QWidget*> laid_out_;  // while they are laid out
  QLineEdit* filter_;
  QToolButton *in_order_, *presets_;
  QFrame* solo_strip_;
  PlainLabel* solo_text_;
  QPushButton* solo_end_;
  QLabel* nothing_;
  QScrollArea* scroll_;
  QWidget* body_;
  QVBoxLayout* column_;
  std::optional<Solo> solo_;
  bool grouped_ = true;
  bool dragging_ = false;
};

}  // namespace mapwright::ui
