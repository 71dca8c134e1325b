// The projections of a robot, edited next to the ones it reports. Pure.
#pragma once

#include <optional>
#include <vector>

#include "map/map_part.h"

namespace mapwright::ui {

class ProjectionDraft {
 public:
  using List = std::vector<map::Projection>;

  /// The reported list. It replaces the draft unless that was edited: then revert() returns to it. True: it
  /// was replaced.
  bool setAnswer(List told);
  /// The robot's answer to the list that was sent: replaces the draft in any case.
  void settle(List told);
  void forget();
  void revert();

  const std::optional<List>& told() const { return told_; }  // nullopt = nothing reported yet
  const List& wanted() const { return wanted_; }
  bool changed() const { return told_ ? wanted_ != *told_ : !wanted_.empty(); }
  /// The first one that cannot be sent.
  std::optional<int> firstFlawed() const;

  std::optional<int> selected() const { return selected_; }
  const map::Projection* selectedOne() const {
    return selected_ ? &wanted_[std::size_t(*selected_)] : nullptr;
  }
  /// An invalid index selects none.
  void select(std::optional<int> index);
  /// At the end, selected.
  void add(const map::Projection& projection);
  void set(int index, const map::Projection& projection);
  void removeSelected();

 private:
  std::optional<List> told_;
  List wanted_;
  std::optional<int> selected_;
};

/// The part of a rectangle that is being dragged.
enum class RectGrip { None, Inside, Left, Right, Bottom, Top, BottomLeft, BottomRight, TopLeft, TopRight };

/// The part at `at_m`: an edge or corner within `reach_m`, otherwise the inside.
RectGrip gripAt(const map::Projection& projection, const Eigen::Vector2d& at_m, double reach_m);
/// `before` with that part moved by `step_m`; dragging across the opposite side flips it, and it never
/// becomes empty.
map::Projection moved(const map::Projection& before, RectGrip grip, const Eigen::Vector2d& step_m);

}  // namespace mapwright::ui
