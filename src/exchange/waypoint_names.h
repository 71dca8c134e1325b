// Names for many waypoints at once: series with numbers, and names made of the present ones. Pure functions.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>

namespace mapwright::exchange {

using TakenNames = std::set<std::string>;

/// "Corr 08", "Corr 09", "Corr 10".
struct NameSeries {
  QString prefix;
  QString first = {};  // with as many digits as were typed: "08"; empty = nextNumber()
  int step = 1;
};
/// The number after the highest one that is in use with this prefix, with as many digits; "1" if none is.
QString nextNumber(const QString& prefix, const TakenNames& taken);

struct SeriesNames {
  QStringList names;
  QStringList skipped;  // taken, so that their numbers are left out
};
SeriesNames namesOf(const NameSeries& series, qsizetype count, const TakenNames& taken);

/// What to make of the present names.
struct Renaming {
  enum class How {
    Pattern,  // each run of # is the number, with at least as many digits; * is the present name
    Replace,  // a part of the present name
  };
  How how = How::Pattern;
  QString pattern = {};  // with neither # nor *: the number is appended
  int first = 1, step = 1;
  QString find = {}, replacement = {};
  bool match_case = false;
};

enum class NameTrouble {
  None,
  Empty,  // there must be one
  Taken,  // by a waypoint that is not renamed
  Twice,  // by another one that is renamed, too
};
struct NewName {
  QString before, after;
  NameTrouble trouble = NameTrouble::None;
  bool changes() const { return before != after; }
};
/// `names`: in the order in which they are counted. `others`: the names of all other waypoints.
std::vector<NewName> renamed(const QStringList& names, const Renaming& renaming, const TakenNames& others);

}  // namespace mapwright::exchange
