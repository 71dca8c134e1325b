// How much a dispatcher gives in one answer, as far as it has shown: some leave out what is too much, answer
// with nothing, or with an error. Pure values. Source: docs/protocols/rep130-map-dispatcher.md, "Left open".
#pragma once

#include <cstdint>

#include "geometry/rect.h"

namespace mapwright::regions {

/// How large the squares are that are asked for: all of `most_cells` along their edge until answers have
/// proved too small, then by halves what it has been seen to give.
class AnswerLimit {
 public:
  /// Squares are not made smaller than this, cells along their edge.
  static constexpr int kLeastCells = 64;

  explicit AnswerLimit(int most_cells);

  /// Cells along the edge of the squares to ask for.
  int edge() const { return edge_; }
  /// So many of them lie side by side where one of the largest lies.
  int pieces() const { return most_ / edge_; }
  /// An answer had so many cells.
  void gave(int width, int height);
  /// It has given as many cells in one answer as a square of so many needs.
  bool hasGiven(std::int64_t cells) const { return cells <= given_; }
  /// Something was left out of an answer though it is on the map. True: edge() is another one now. Where
  /// smaller squares would not help, it is that of the largest again, and stays.
  bool leftOut();

 private:
  int most_, edge_;
  std::int64_t given_ = 0;  // cells of the largest answer
  int given_edge_ = 0;      // of the largest square that lies in an answer
  bool over_ = false;       // smaller ones do not help
};

/// Whether a square was answered with nothing, or an error, because it was too much, though it is on the map:
/// then four squares side by side are answered that are not answered together. One that reaches beyond the
/// map may be answered with nothing, too, so the four are looked for around a place on the map.
class QuarterSearch {
 public:
  static constexpr int kMostQuestions = 24;

  /// `whole`: what was not answered, of so many cells (along its longer edge); `place`: in it, likely to be
  /// on the map.
  QuarterSearch(const geometry::WorldRect& whole, int cells, const Eigen::Vector2d& place);

  bool over() const { return over_; }
  /// It was too much. Once it is over.
  bool proven() const { return proven_; }
  /// While it is not over.
  geometry::WorldRect asking() const;
  void answered(bool came);

 private:
  enum class Step { First, Across, Along, Diagonal, Together };
  /// What lies beside the first of four, by so many of its edges.
  geometry::WorldRect beside(int x, int y) const;
  geometry::WorldRect together() const;
  void goOn(bool came);

  geometry::WorldRect first_;
  Eigen::Vector2d place_;
  int whole_cells_, cells_ = 0;
  int x_ = 1, y_ = 1;  // where the others of the four lie
  bool turned_x_ = false, turned_y_ = false, together_is_whole_ = true;
  Step step_ = Step::First;
  int questions_ = 0;
  bool over_ = false, proven_ = false;
};

}  // namespace mapwright::regions
