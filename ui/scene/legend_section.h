// What the colours and shapes of a layer mean, as rows of a symbol and words.
#pragma once

#include <vector>

#include <QImage>
#include <QString>

namespace mapwright::ui::scene {

struct LegendRow {
  QString text;       // empty for a scale that needs no more than its ends
  QImage symbol;      // on the ground of the map; its device pixel ratio is set
  QString low, high;  // the ends of a scale of colours; both empty: the symbol is none
  bool operator==(const LegendRow&) const = default;
};

struct LegendSection {
  QString title;
  std::vector<LegendRow> rows;
  bool operator==(const LegendSection&) const = default;
};

}  // namespace mapwright::ui::scene
