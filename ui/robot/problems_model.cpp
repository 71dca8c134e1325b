#include "ui/robot/problems_model.h"

#include <algorithm>

#include <QColor>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>

#include "sentences/problem_sentence.h"
#include "sentences/subject_name.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

bool same(const session::LoggedProblem& a, const session::LoggedProblem& b) { return a.row == b.row; }

QString subjectText(const session::LoggedProblem& problem) {
  return words::plainName(sentences::nameOf(problem.problem.subject));
}

/// A persisting problem has no length yet; one that recovered at once has none worth showing.
QString durationText(const session::LoggedProblem& problem) {
  if (!problem.resolved) return {};
  return session::spanText(problem.lastedMs(*problem.resolved));
}

QString timesText(const session::LoggedProblem& problem) {
  const auto at = [](const QDateTime& time) {
    return QLocale::c().toString(time, QStringLiteral("yyyy-MM-dd HH:mm:ss"));
  };
  const QString text = problem.count > 1
                           ? ProblemsModel::tr("First %1, last %2.").arg(at(problem.first), at(problem.last))
                           : ProblemsModel::tr("At %1.").arg(at(problem.last));
  if (!problem.resolved) return text;
  return words::paragraph(
      {text, ProblemsModel::tr("Resolved %1, after %2.").arg(at(*problem.resolved), durationText(problem))});
}

QString severityWord(map::Severity severity) {
  switch (severity) {
    case map::Severity::Info:
      return QCoreApplication::translate("window", "information");
    case map::Severity::Warning:
      return QCoreApplication::translate("window", "warning");
    case map::Severity::Error:
      break;
  }
  return QCoreApplication::translate("window", "error");
}

QVariant severityPicture(const session::LoggedProblem& problem) {
  const UiColors colors = appColors();
  const double ratio = qApp->devicePixelRatio();
  if (problem.resolved) return iconPixmap(QStringLiteral("ok"), 16, ratio, colors.ok_text);
  switch (problem.problem.severity) {
    case map::Severity::Info:
      return iconPixmap(QStringLiteral("info"), 16, ratio, colors.accent_text);
    case map::Severity::Warning:
      return iconPixmap(QStringLiteral("problem"), 16, ratio, colors.warning_text);
    case map::Severity::Error:
      break;
  }
  return iconPixmap(QStringLiteral("error"), 16, ratio, colors.error_text);
}

}  // namespace

void ProblemsModel::sync(const session::ProblemLog::Rows& fresh) {
  // The log only appends, removes at its front and sometimes moves a row: a greedy walk is enough.
  std::size_t row = 0;
  for (; row < fresh.size(); ++row) {
    if (row < rows_.size() && same(rows_[row], fresh[row])) continue;
    const auto found = std::find_if(rows_.begin() + std::ptrdiff_t(std::min(row, rows_.size())), rows_.end(),
                                    [&](const session::LoggedProblem& old) { return same(old, fresh[row]); });
    if (found != rows_.end()) {
      beginRemoveRows({}, int(row), int(found - rows_.begin()) - 1);
      rows_.erase(rows_.begin() + std::ptrdiff_t(row), found);
      endRemoveRows();
    } else {
      beginInsertRows({}, int(row), int(row));
      rows_.insert(rows_.begin() + std::ptrdiff_t(row), fresh[row]);
      endInsertRows();
    }
  }
  if (rows_.size() > fresh.size()) {
    beginRemoveRows({}, int(fresh.size()), int(rows_.size()) - 1);
    rows_.resize(fresh.size());
    endRemoveRows();
  }
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    if (rows_[i].count == fresh[i].count && rows_[i].resolved == fresh[i].resolved) continue;
    rows_[i] = fresh[i];
    Q_EMIT dataChanged(index(int(i), 0), index(int(i), kColumns - 1));
  }
}

QVariant ProblemsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= int(rows_.size())) return {};
  const session::LoggedProblem& row = rows_[std::size_t(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      switch (index.column()) {
        case TimeColumn:
          return QLocale::c().toString(row.last, QStringLiteral("HH:mm:ss"));
        case CountColumn:
          return QStringLiteral("%1×").arg(countText(row.count));
        case SubjectColumn:
          return subjectText(row);
        case DurationColumn:
          return durationText(row);
        case SentenceColumn:
          return words::plainName(sentences::sentenceOf(row.problem));
        default:
          return {};
      }
    case Qt::DecorationRole:
      return index.column() == TimeColumn ? severityPicture(row) : QVariant();
    case Qt::TextAlignmentRole:
      return index.column() == CountColumn || index.column() == DurationColumn
                 ? int(Qt::AlignRight | Qt::AlignVCenter)
                 : int(Qt::AlignLeft | Qt::AlignVCenter);
    case Qt::ForegroundRole:
      return row.resolved ? QVariant(appColors().secondary_text) : QVariant();
    case Qt::ToolTipRole:
      return plainToolTip(words::about(subjectText(row), sentences::sentenceOf(row.problem)) +
                          QLatin1Char('\n') + timesText(row));
    case Qt::AccessibleTextRole:
      return index.column() == TimeColumn
                 ? words::listed({severityWord(row.problem.severity), row.last.toString()})
                 : data(index, Qt::DisplayRole);
    default:
      return {};
  }
}

QVariant ProblemsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    return section == CountColumn || section == DurationColumn ? int(Qt::AlignRight | Qt::AlignVCenter)
                                                               : int(Qt::AlignLeft | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case TimeColumn:
      return tr("Last");
    case CountColumn:
      return tr("Count");
    case DurationColumn:
      return tr("Lasted");
    case SubjectColumn:
      return tr("What");
    case SentenceColumn:
      return tr("What happened");
    default:
      return {};
  }
}

QString problemLine(const session::LoggedProblem& problem) {
  return QStringLiteral("%1 %2 %3×  %4: %5  (%6)")
      .arg(QLocale::c().toString(problem.last, QStringLiteral("yyyy-MM-dd HH:mm:ss")),
           severityWord(problem.problem.severity), QString::number(problem.count), subjectText(problem),
           words::plainName(sentences::sentenceOf(problem.problem)), timesText(problem));
}

}  // namespace mapwright::ui

#include "moc_problems_model.cpp"
