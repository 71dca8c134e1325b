// What a robot is to lay on the plane, edited beside what it says that it does. Pure.
#pragma once

#include <optional>
#include <vector>

#include "map/projections.h"

namespace mapwright::window {

class ProjectionDraft {
 public:
  using List = std::vector<map::Projection>;

  /// What the robot says. It is taken over, unless something was edited: then it is what revert() leads to.
  /// True: it was taken over.
  bool tell(List told);
  /// What the robot made of the list that it was sent: taken over, whatever was edited.
  void settle(List told);
  void forget();
  void revert();

  const std::optional<List>& told() const { return told_; }  // nullopt = the robot has said nothing
  const List& wanted() const { return wanted_; }
  bool changed() const { return told_ ? wanted_ != *told_ : !wanted_.empty(); }
  /// The first one that cannot be sent.
  std::optional<int> firstFlawed() const;

  std::optional<int> selected() const { return selected_; }
  const map::Projection* selectedOne() const {
    return selected_ ? &wanted_[std::size_t(*selected_)] : nullptr;
  }
  /// Anything that is not there is none.
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

/// What of a rectangle on the map the hand has hold of.
enum class RectGrip { None, Inside, Left, Right, Bottom, Top, BottomLeft, BottomRight, TopLeft, TopRight };

/// What is at `at_m`: an edge or a corner that is nearer than `reach_m`, else the inside.
RectGrip gripAt(const map::Projection& projection, const Eigen::Vector2d& at_m, double reach_m);
/// `before` with that part moved by `step_m`; pulled over the other side it turns round, and has size always.
map::Projection moved(const map::Projection& before, RectGrip grip, const Eigen::Vector2d& step_m);

}  // namespace mapwright::window
