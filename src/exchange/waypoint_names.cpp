#include "exchange/waypoint_names.h"

#include <algorithm>
#include <map>

namespace mapwright::exchange {
namespace {

constexpr qsizetype kMostDigits = 9;

bool isDigit(QChar c) { return c >= QLatin1Char('0') && c <= QLatin1Char('9'); }

QString numberText(qint64 number, qsizetype digits) {
  return number < 0 ? QLatin1Char('-') + QString::number(-number).rightJustified(digits, QLatin1Char('0'))
                    : QString::number(number).rightJustified(digits, QLatin1Char('0'));
}

QString fromPattern(const QString& pattern, const QString& name, qint64 number) {
  QString made;
  for (qsizetype i = 0; i < pattern.size();) {
    const QChar c = pattern[i];
    if (c == QLatin1Char('#')) {
      qsizetype end = i;
      while (end < pattern.size() && pattern[end] == QLatin1Char('#')) ++end;
      made += numberText(number, end - i);
      i = end;
      continue;
    }
    made += c == QLatin1Char('*') ? name : QString(c);
    ++i;
  }
  return made;
}

}  // namespace

QString nextNumber(const QString& prefix, const TakenNames& taken) {
  qint64 highest = 0;
  qsizetype digits = 1;
  const std::string begin = prefix.toStdString();
  for (auto name = taken.lower_bound(begin); name != taken.end() && name->starts_with(begin); ++name) {
    const QString rest = QString::fromStdString(name->substr(begin.size()));
    const bool numbered =
        !rest.isEmpty() && rest.size() <= kMostDigits && std::all_of(rest.begin(), rest.end(), isDigit);
    if (!numbered || rest.toLongLong() < highest) continue;
    highest = rest.toLongLong();
    digits = rest.size();
  }
  return numberText(highest + 1, digits);
}

SeriesNames namesOf(const NameSeries& series, qsizetype count, const TakenNames& taken) {
  QString first = series.first.trimmed();
  if (first.isEmpty()) first = nextNumber(series.prefix, taken);
  first = first.left(kMostDigits);
  bool is_number = false;
  qint64 number = first.toLongLong(&is_number);
  if (!is_number || series.step == 0) return {};
  SeriesNames made;
  // Every name that is skipped is one of those taken, so it ends.
  while (made.names.size() < count) {
    const QString name = (series.prefix + numberText(number, first.size())).trimmed();
    number += series.step;
    (taken.contains(name.toStdString()) ? made.skipped : made.names) << name;
  }
  return made;
}

std::vector<NewName> renamed(const QStringList& names, const Renaming& renaming, const TakenNames& others) {
  QString pattern = renaming.pattern;
  if (!pattern.contains(QLatin1Char('#')) && !pattern.contains(QLatin1Char('*')))
    pattern = pattern.trimmed() + QStringLiteral(" #");
  const bool says_nothing =
      renaming.how == Renaming::How::Pattern ? renaming.pattern.trimmed().isEmpty() : renaming.find.isEmpty();
  std::vector<NewName> made;
  made.reserve(std::size_t(names.size()));
  qint64 number = renaming.first;
  for (const QString& name : names) {
    QString after = name;
    if (says_nothing) {
      // Nothing to do yet.
    } else if (renaming.how == Renaming::How::Pattern) {
      after = fromPattern(pattern, name, number).trimmed();
      number += renaming.step;
    } else if (name.contains(renaming.find, renaming.match_case ? Qt::CaseSensitive : Qt::CaseInsensitive)) {
      after.replace(renaming.find, renaming.replacement,
                    renaming.match_case ? Qt::CaseSensitive : Qt::CaseInsensitive);
      after = after.trimmed();
    }
    made.push_back({name, after});
  }
  std::map<QString, int> bearers;
  for (const NewName& one : made) ++bearers[one.after];
  for (NewName& one : made) {
    if (!one.changes()) continue;
    one.trouble = one.after.isEmpty()                        ? NameTrouble::Empty
                  : others.contains(one.after.toStdString()) ? NameTrouble::Taken
                  : bearers[one.after] > 1                   ? NameTrouble::Twice
                                                             : NameTrouble::None;
  }
  return made;
}

}  // namespace mapwright::exchange
