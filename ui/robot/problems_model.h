// The problems of a session as a table; updates by differences, so that the selection is stable.
#pragma once

#include <vector>

#include <QAbstractTableModel>

#include "session/problem_log.h"

namespace mapwright::ui {

class ProblemsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { TimeColumn, CountColumn, DurationColumn, SubjectColumn, SentenceColumn, kColumns };

  using QAbstractTableModel::QAbstractTableModel;
  void sync(const session::ProblemLog::Rows& rows);
  const session::LoggedProblem& problem(int row) const { return rows_[std::size_t(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : int(rows_.size());
  }
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<session::LoggedProblem> rows_;
};

/// One problem as a line of plain text for the clipboard.
QString problemLine(const session::LoggedProblem& problem);

}  // namespace mapwright::ui
