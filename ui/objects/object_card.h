// A small card on the map that says what a thing is.
#pragma once

#include <vector>

#include <QFrame>
#include <QLabel>
#include <QToolButton>

#include "ui/scene/map_object.h"

class QGridLayout;

namespace mapwright::ui::scene {
class MapScene;
}

namespace mapwright::ui {

class PlainLabel;

class ObjectCard : public QFrame {
  Q_OBJECT
 public:
  ObjectCard(const scene::MapScene& scene, QWidget* parent);

  /// What the card says. `beneath`: how many other things lie at the same place.
  void show(const scene::MapObject& object, const std::vector<scene::ObjectProperty>& facts, int beneath);
  /// As many rows as there are; fewer where there is no room.
  int allRows() const { return int(shown_.size()); }
  void showRows(int rows);
  /// One that stays has buttons; the other lets the mouse through.
  void setStaying(bool stays);
  bool staying() const { return stays_; }
  QString title() const;
  QStringList lines() const;  // "State: open"
  QString moreShown() const;

 Q_SIGNALS:
  void copyWanted();
  void propertiesWanted();
  void nextWanted();
  void closeWanted();

 private:
  const scene::MapScene& scene_;
  QLabel* symbol_;
  PlainLabel *kind_, *name_;
  QGridLayout* grid_;
  std::vector<PlainLabel*> labels_;  // name, value, name, value …
  std::vector<scene::ObjectProperty> shown_;
  int rows_ = 0;   // of them
  int known_ = 0;  // of everything
  QWidget* buttons_;
  QToolButton *copy_, *properties_, *next_, *close_;
  PlainLabel *more_, *hint_;
  bool stays_ = false;
};

}  // namespace mapwright::ui
