// What was placed by hand on the reference map, on the map on screen: what becomes of each, and those that
// are carried over become unsaved changes there. Why: docs/tasks/new-map.md.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QObject>

#include "carry/carried.h"
#include "geometry/rect.h"
#include "map/catalogue.h"
#include "robot/robot.h"
#include "ui/carry/carry_model.h"
#include "ui/kit/background_run.h"
#include "ui/shell/laid_map.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class CarryDock;

class Carrying : public QObject {
  Q_OBJECT
 public:
  ~Carrying() override;

  CarryDock* dock() const { return dock_; }
  /// The reference map; nullopt = none, or it is still being read.
  void setLaid(const std::optional<LaidMap>& laid);
  /// Shows the dock, and what becomes of them.
  void open();
  /// The map on screen or what lies on it has changed.
  void refresh();

 Q_SIGNALS:
  /// Empty: they can be carried over.
  void possibleChanged(const QString& why_not);
  void carried();

 protected:
  /// What the verdicts are about.
  struct Subject {
    LaidMap laid;
    render::PlacedGrid map;
    map::MapKey key;
    std::string content;  // of the map: names exactly these cells; empty: not known
    /// It still is, although the map on screen may have changed.
    bool sameAs(const Subject& other) const { return laid == other.laid && key == other.key; }
    /// A file is read again when anything beside it is saved.
    bool sameCells(const Subject& other) const {
      return map == other.map ||
             (!content.empty() && content == other.content && map.reference == other.map.reference);
    }
  };

  using Job = std::function<BackgroundRun::Then(const carry::Site& site)>;

  /// `context` must outlive this.
  Carrying(WindowContext& context, const CarryWords& words, const QString& dock_name, int menu_rank,
           QObject* parent);

  /// Why nothing can be carried over although both maps are there; empty: it can.
  virtual QString whyNotBetween(robot::Robot& reader) const = 0;
  /// What lies on the map on screen can be changed at present.
  virtual bool editable() const = 0;
  /// Reads them of the reference map, then calls start() or giveUp(). An answer counts only as long as turn()
  /// is the same.
  virtual void read(robot::Robot& reader, const map::MapKey& key) = 0;
  /// Another reference map: what became of its things is nothing to go by.
  virtual void forgetCarried() = 0;
  /// Of each row: Open, There, OtherThere or Carried.
  virtual std::vector<CarryRow::State> statesNow() const = 0;
  /// As it lies on the new map.
  virtual geometry::WorldRect boundsOf(int row) const = 0;
  /// Shows on the map what would become of it; nullopt: of none any more.
  virtual void mark(std::optional<int> /*row*/) {}
  /// Makes changes of them; false: there are none.
  virtual bool put(const std::vector<int>& rows) = 0;

  const std::vector<CarryRow>& rows() const;
  int turn() const { return turn_; }
  const std::optional<Subject>& lookedAt() const { return looked_at_; }
  bool adjusts() const;
  /// Looks at both maps, beside the pool.
  void start(Job job);
  /// What it found. `besides` is said after the sum.
  void setRows(std::vector<CarryRow> rows, const QString& besides = {});
  void giveUp(const QString& said);

  WindowContext& context_;

 private:
  QString whyNot() const;
  std::optional<Subject> subject() const;
  void look();
  void forget(const QString& said);
  void updateStates();
  void show();
  void goTo(int row);
  void carryOver(const std::vector<int>& rows);
  void leaveOut(const std::vector<int>& rows);

  CarryWords words_;
  CarryDock* dock_;
  std::optional<LaidMap> laid_;
  std::optional<QString> why_not_;  // as it was said last
  std::optional<Subject> looked_at_;
  std::set<std::string> left_out_;  // by hand: the ids of rows
  int turn_ = 0;                    // answers of earlier ones are of no use
  QString said_;                    // instead of the sum
  QString besides_;                 // after it
  BackgroundRun run_;
};

}  // namespace mapwright::ui
